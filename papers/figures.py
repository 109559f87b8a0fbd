# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of the paper, in its type and measures, drawn with what draws those of the studies."""
import json
import math

import numpy as np

from looks import in_order
from names import DISTANCES, TITLES
from results import distinct
from studies import near_edge, tradeoff
from studies.soak import COLOURS as STAGE_COLOURS
from style import curve, plt, rows_of, save

WIDTH = 6.1  # inches of text
plt.rcParams.update({"pdf.fonttype": 42})
TYPE = {"font.size": 8, "axes.titlesize": 8, "legend.fontsize": 7.5}


def above(figure, axes, columns):
    """The legend, in room that is made for it."""
    handles, labels = axes.get_legend_handles_labels()
    lines = -(-len(labels) // columns)
    figure.legend(handles, labels, loc="upper center", ncol=columns, frameon=False)
    figure.suptitle("\n" * lines, fontsize=TYPE["legend.fontsize"])


def draw_near_edge(study, output):
    rates = near_edge.Rates(study / "rates.csv")
    thresholds = ["face", "edge", "vertex"]
    figure, grid = plt.subplots(1, len(thresholds), figsize=(WIDTH, 2.5), sharey=True, layout="constrained")
    for axes, threshold in zip(grid, thresholds):
        rates.draw(axes, "all", "planar", threshold, "contact")
        axes.set(title=TITLES[threshold], xlabel=r"offset of the radius, in $u \cdot$ size")
    grid[0].set_ylabel("wrong answers, %")
    above(figure, grid[0], 5)
    save(figure, output, "near-edge", ("pdf",))


def draw_map(study, output):
    panels = [("fast", 0), ("thesis", 0), ("thesis-signed", 0), ("thesis-signed", 1000)]
    figure, grid = plt.subplots(1, len(panels), figsize=(WIDTH, 1.95), layout="constrained")
    for axes, (method, distance) in zip(grid, panels):
        letters = near_edge.read_map(study / f"map-reflex-vertex-foot-{distance}.csv")
        near_edge.show_map(axes, letters, method)
        axes.set_title(f"{method},\n{DISTANCES[distance]}")
    save(figure, output, "map", ("pdf",))


def draw_onset(study, output):
    rows = rows_of(study / "onset.csv")
    distances = distinct(rows, "origin_distance")
    figure, grid = plt.subplots(1, len(distances), figsize=(WIDTH, 2.6), sharey=True, layout="constrained")
    for axes, distance in zip(grid, distances):
        for method in in_order(distinct(rows, "method")):
            own = [row for row in rows if row["origin_distance"] == distance and row["method"] == method]
            curve(axes, method, [-int(row["offset_exponent"]) for row in own],
                  *([100 * float(row[key]) for row in own] for key in ("rate", "lower", "upper")), markersize=2.5, linewidth=1)
        axes.set_title("at the origin" if float(distance) == 0 else "$10^6$ sizes away")
        axes.set_xlabel("radius off by $2^{-k}$ of the distance: $k$")
        axes.grid(color="#dddddd", linewidth=0.5)
    grid[0].set_ylabel("triangles with a\nwrong answer, %")
    above(figure, grid[0], 5)
    save(figure, output, "onset", ("pdf",))


# Variants that stand beside what they vary, and one whose time is that of asking another program.
NOT_IN_FRONT = {"bullet-float", "thesis-0.9999", "thesis-1", "thesis-atan2", "thesis-newell", "thesis-closed", "cgal-double-distance",
                "cgal-double-intersect", "cgal-epick-distance"}


def draw_front(study, output):
    rows = [row for row in rows_of(study / "front.csv") if row["method"] not in NOT_IN_FRONT and
            (row["measure"], row["family"], row["placement"]) == ("not-right", "all", "planar")]
    figure, axes = plt.subplots(figsize=(WIDTH, 3.6))
    figure.subplots_adjust(left=0.12, right=0.98, top=0.98, bottom=0.12)
    tradeoff.set_limits(axes, rows)
    spots = tradeoff.draw_front(axes, rows, rows, 4.5, True)
    tradeoff.set_limits(axes, rows)
    figure.canvas.draw()
    if nameless := tradeoff.name_spots(axes, spots, spots, 6):
        raise ValueError(f"the picture of the front has no room for {', '.join(spot.method for spot in nameless)}")
    axes.set(xlabel="nanoseconds a question", ylabel=r"answers not right within $u \cdot$ size of contact")
    save(figure, output, "front", ("pdf",))


def draw_question(output):
    """A ball over a U, seen obliquely: its foot, and the nearest edge."""
    outline = np.array([(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)], float)
    centre, radius = np.array([1.42, 2.1, 0.95]), 1.1
    turn, tilt = math.radians(-62), math.radians(30)
    right = np.array([-math.sin(turn), math.cos(turn), 0])
    up = np.array([-math.sin(tilt) * math.cos(turn), -math.sin(tilt) * math.sin(turn), math.cos(tilt)])

    def seen(point):
        point = np.append(point, 0)[:3] if len(point) == 2 else point
        return point @ right, point @ up

    figure, axes = plt.subplots(figsize=(0.8 * WIDTH, 2.5), layout="constrained")
    axes.add_patch(plt.Polygon([seen(p) for p in outline], facecolor="#e8e8e8", edgecolor="#333333", linewidth=1.2))
    foot, nearest = np.array([*centre[:2], 0]), np.array([1, centre[1], 0])
    axes.add_patch(plt.Circle(seen(centre), radius, facecolor="#56B4E933", edgecolor="#0072B2", linewidth=1.2))
    around = [seen(foot + math.sqrt(radius**2 - centre[2] ** 2) * np.array([math.cos(a), math.sin(a), 0])) for a in np.linspace(0, 2 * math.pi, 80)]
    axes.plot(*zip(*around), color="#0072B2", linewidth=0.8, linestyle=":")
    for end, style in ((foot, "--"), (nearest, "-")):
        axes.plot(*zip(seen(centre), seen(end)), color="#D55E00" if end is nearest else "#333333", linewidth=1, linestyle=style)
    for point, words, offset in ((centre, "$c$", (4, 3)), (foot, "$q$", (5, -9)), (nearest, "closest point", (-62, -11))):
        axes.plot(*seen(point), "o", color="black", markersize=3)
        axes.annotate(words, seen(point), xytext=offset, textcoords="offset points")
    axes.annotate("$d$", seen((centre + nearest) / 2), xytext=(-9, 2), textcoords="offset points", color="#D55E00")
    axes.annotate("$r$", seen(centre + np.array([0, 0, radius / 2])), xytext=(-9, 2), textcoords="offset points", color="#0072B2")
    axes.plot(*zip(seen(centre), seen(centre + radius * up)), color="#0072B2", linewidth=0.8)
    axes.annotate("polygon", seen((2.5, 0.4)), ha="center", va="center")
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.autoscale_view()
    save(figure, output, "question", ("pdf",))


TIMED = {"fast": "fast", "filtered": "filtered", "EPICK": "cgal-epick", "EPECK": "cgal-epeck"}


def draw_nearness(study, output):
    contests = [c for c in json.loads((study / "bench.json").read_text())["contests"] if c["family"] == "nearness"]
    exponents = [-int(c["name"].removeprefix("2^-")) for c in contests]
    figure, (above_, below) = plt.subplots(2, 1, figsize=(0.85 * WIDTH, 3.4), height_ratios=[2.2, 1], sharex=True, layout="constrained")
    for name, method in TIMED.items():
        times = [next(c["nanoseconds"] for c in contest["contestants"] if c["name"] == name) for contest in contests]
        curve(above_, method, exponents, *([t[each] for t in times] for each in ("median", "lower_quartile", "upper_quartile")), shade=0.2,
              markersize=3, label=name)
    above_.set(yscale="log", ylabel="nanoseconds a query")
    above_.grid(color="#dddddd", linewidth=0.5)
    above_.legend(frameon=False, ncol=4, loc="lower center", bbox_to_anchor=(0.5, 1))
    foot = np.zeros(len(contests))
    for stage, colour in STAGE_COLOURS.items():
        share = np.array([contest["shares"][stage] for contest in contests])
        below.bar(exponents, share, bottom=foot, color=colour, width=1.4, label=stage)
        foot += share
    below.set_ylabel("decided by")
    below.set_yticks([0, 1], ["0", "all"])
    below.set_xticks([-52, -40, -30, -20, -10, 0], [f"$2^{{{k}}}$" if k else "1" for k in (-52, -40, -30, -20, -10, 0)])
    below.set_xlabel("distance of the radius from contact, as a share of it")
    below.legend(frameon=False, ncol=5, loc="upper center", bbox_to_anchor=(0.5, -0.45))
    save(figure, output, "nearness", ("pdf",))


FIGURES = {"near-edge": (draw_near_edge, draw_map), "stability": (draw_onset,), "tradeoff": (draw_front,), "bench": (draw_nearness,)}


def draw(results, output):
    with plt.rc_context(TYPE):
        draw_question(output)
        for study, drawings in FIGURES.items():
            for drawing in drawings:
                drawing(results / study, output)
