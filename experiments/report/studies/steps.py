# SPDX-License-Identifier: GPL-3.0-or-later
"""What discrete steps of a moving ball miss, and what the exact sweep costs beside them: a part of the study motions."""
import math

from looks import look_of
from noise import TOO_NOISY, is_steady
from page import bar, count, multiple, percent, rounded, share_of_size, smaller, upper_limit
from results import distinct, finite, maybe, natural, share
from style import STYLES, plt, rows_of, save, whiskers


class Data:
    def __init__(self, study):
        self.misses = study.rows("steps.csv", radius=finite, steps=natural, passes=natural, contacts=natural, missed=natural, rate=share, lower=share,
                                 upper=share)
        self.radii = distinct(self.misses, "radius")
        self.steps = distinct(self.misses, "steps")
        self.passes = self.misses[0]["passes"]
        self.at = {(row["radius"], row["steps"]): row for row in self.misses}
        self.cost = {} if not (study.folder / "steps-cost.csv").exists() else {
            row["asked"]: row for row in study.rows("steps-cost.csv", asked=str, median_ns=finite, lower_quartile_ns=finite, upper_quartile_ns=finite, lower_quartile_ratio=maybe(finite),
                                                 median_ratio=maybe(finite), upper_quartile_ratio=maybe(finite))}

    def cost_of(self, steps):
        return self.cost[f"{steps} step{'' if steps == 1 else 's'}"]


def has_steady_ratio(row):
    """Whether it has a ratio that may be quoted."""
    return bool(row["median_ratio"]) and is_steady(row["lower_quartile_ratio"], row["upper_quartile_ratio"])


def missed(row):
    if not row["missed"]:
        return f"0 (&lt; {percent(upper_limit(row['contacts']))})" if row["contacts"] else ""
    return bar(row["rate"], percent(row["rate"]))


def misses_row(data, radius, shown):
    ball = f"radius {share_of_size(radius)} of the size" if radius else "a point"
    return [ball, count(data.at[radius, shown[0]]["contacts"]), *(missed(data.at[radius, n]) for n in shown)]


def cost_row(name, row):
    return [name, f"{rounded(row['median_ns'])} ns" if is_steady(row["lower_quartile_ns"], row["upper_quartile_ns"]) else TOO_NOISY,
            "1" if not row["median_ratio"] else multiple(row["median_ratio"]) if has_steady_ratio(row) else TOO_NOISY]


def told(study):
    data = Data(study)
    shown = data.steps[::2]
    beaten = [n for n in data.steps if data.cost and has_steady_ratio(data.cost_of(n)) and data.cost_of(n)["median_ratio"] > 1]
    return {"data": data, "small": next(radius for radius in data.radii if radius), "large": data.radii[-3], "many": data.steps[-4], "few": data.steps[2],
            "beaten": beaten[0] if beaten else 0, "drawn": smaller(study.folder, "steps"),
            "heads": ["the ball", "contacts", *(f"{count(n)} step{'s' if n > 1 else ''}" for n in shown)],
            "misses": [misses_row(data, radius, shown) for radius in data.radii], "costs": [cost_row(name, row) for name, row in data.cost.items()]}


def draw_misses(axes, rows):
    """Shares by steps, a curve a radius."""
    radii = distinct(rows, "radius")
    for place, ((_, line, marker), radius) in enumerate(zip(STYLES, radii)):
        own = [row for row in rows if row["radius"] == radius]
        name = f"$2^{{{int(math.log2(float(radius)))}}}$" if float(radius) else "0 (a point)"
        whiskers(axes, [int(row["steps"]) for row in own], *([100 * float(row[each]) for row in own] for each in ("rate", "lower", "upper")),
                 color=str(0.75 * place / len(radii)), linestyle=line, marker=marker, label=name)  # greys: colours are of methods
    axes.set(ylabel="missed contacts (%)", ylim=(-2, 102))
    axes.legend(title="radius, in sizes", fontsize=8, loc="upper left", bbox_to_anchor=(1, 1))
    axes.set_title("contacts that steps over one size of the polygon miss (bars: 95 %)")


def draw_cost(axes, rows):
    """Medians, with the quartiles as bars."""
    steps, colour = [row for row in rows if row["asked"].split()[0].isdigit()], look_of("filtered").colour
    whiskers(axes, [int(row["asked"].split()[0]) for row in steps],
             *([float(row[f"{part}_ns"]) for row in steps] for part in ("median", "lower_quartile", "upper_quartile")),
             color=colour, linestyle=":", marker="o", label="filtered, in steps until one touches")
    for (_, line, _), row in zip(STYLES, [row for row in rows if row not in steps]):
        axes.axhline(float(row["median_ns"]), color=colour, linestyle=line, label=row["asked"] + ", without steps")
    axes.set(yscale="log", ylabel="nanoseconds per motion")
    axes.legend()
    axes.set_title("time per motion: medians (bars: quartiles)")


def draw(folder):
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    draw_misses(left, rows_of(folder / "steps.csv"))
    draw_cost(right, rows_of(folder / "steps-cost.csv"))
    for axes in (left, right):
        axes.set_xscale("log", base=2)
        axes.set_xlabel("steps")
        axes.grid(alpha=0.3)
    save(figure, folder, "steps")
