# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of `touchstone cell missed`, of missed.csv."""
from results import distinct
from style import STYLES, plt, rows_of, save, whiskers


def draw_missed(axes, rows):
    """Shares by step, a curve a radius."""
    radii = distinct(rows, "radius_mm")
    for place, ((_, line, marker), radius) in enumerate(zip(STYLES, radii)):
        own = [row for row in rows if row["radius_mm"] == radius]
        steps = [float(row["step_deg"]) * 1.05 ** (place - (len(radii) - 1) / 2) for row in own]  # whiskers beside each other
        whiskers(axes, steps, *([100 * float(row[name]) for row in own] for name in ("share", "lower", "upper")),
                 color=plt.get_cmap("cividis")(place / len(radii)), linestyle=line, marker=marker, label=f"{float(radius):g} mm")  # other colours are of methods
    axes.set_xscale("log")
    steps = sorted({float(row["step_deg"]) for row in rows})
    axes.set_xticks(steps, [f"{step:g}" for step in steps])
    axes.minorticks_off()
    axes.grid(alpha=0.3)


def main(folder):
    figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
    draw_missed(axes, rows_of(folder / "missed.csv"))
    axes.set(xlabel="step of the joint (degrees)", ylabel="missed first contacts (%)", ylim=(-2, 100))
    axes.legend(title="radius of the sphere")
    axes.set_title("A sphere carried through a thin sheet: certified first contacts\n"
                   "that stepping a joint misses (bars: 95 %)")
    save(figure, folder, "cell-missed")
