# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of `touchstone cell missed`, of missed.csv.

Same data, same bytes: nothing here depends on the time or on chance."""
import csv

from pictures.style import STYLES, plt, save


def draw_missed(axes, rows):
    """Shares by step, a curve a radius."""
    radii = list(dict.fromkeys(row["radius_mm"] for row in rows))
    for place, ((_, line, marker), radius) in enumerate(zip(STYLES, radii)):
        color = plt.get_cmap("cividis")(place / len(radii))  # colours of STYLES are of methods
        own = [row for row in rows if row["radius_mm"] == radius]
        steps = [float(row["step_deg"]) * 1.05 ** (place - (len(radii) - 1) / 2) for row in own]  # whiskers beside each other
        shares = [100 * float(row["share"]) for row in own]
        low = [s - 100 * float(row["lower"]) for s, row in zip(shares, own)]
        high = [100 * float(row["upper"]) - s for s, row in zip(shares, own)]
        axes.errorbar(steps, shares, yerr=[low, high], color=color, linestyle=line, marker=marker, markersize=4,
                      capsize=2, label=f"{float(radius):g} mm")
    axes.set_xscale("log")
    steps = sorted({float(row["step_deg"]) for row in rows})
    axes.set_xticks(steps, [f"{step:g}" for step in steps])
    axes.minorticks_off()
    axes.grid(alpha=0.3)


def main(folder):
    with open(folder / "missed.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
    draw_missed(axes, rows)
    axes.set_xlabel("step of the joint (degrees)")
    axes.set_ylabel("missed first contacts (%)")
    axes.set_ylim(-2, 100)
    axes.legend(title="radius of the sphere")
    axes.set_title("A sphere carried through a thin sheet: certified first contacts\n"
                   "that stepping a joint misses (bars: 95 %)")
    save(figure, folder, "cell-missed")
