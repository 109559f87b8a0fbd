# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of the paper, in its type and measures, drawn with what draws those of the studies."""
import csv

from looks import in_order, look_of
from names import DISTANCES, TITLES
from pictures import near_edge, stability, tradeoff
from pictures.style import plt, save

WIDTH = 6.1  # inches of text
plt.rcParams.update({"pdf.fonttype": 42})
TYPE = {"font.size": 8, "axes.titlesize": 8, "legend.fontsize": 7.5}


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


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
        rates.draw(axes, "all", "rotated", threshold, "contact")
        axes.set_title(TITLES[threshold])
        axes.set_xlabel("offset of the radius, in doubles")
        axes.set_xticks([near_edge.place(k) for k in (-2**32, -2**16, 0, 2**16, 2**32)],
                        ["$-2^{32}$", "$-2^{16}$", "0", "$2^{16}$", "$2^{32}$"])
    grid[0].set_ylabel("wrong answers, %")
    above(figure, grid[0], 5)
    save(figure, output, "near-edge", ("pdf",))


def draw_map(study, output):
    panels = [("fast", 0), ("thesis", 0), ("thesis-signed", 0), ("thesis-signed", 1000)]
    figure, grid = plt.subplots(1, len(panels), figsize=(WIDTH, 1.95), layout="constrained")
    for axes, (method, distance) in zip(grid, panels):
        letters = near_edge.read_map(study / f"map-reflex-vertex-foot-{distance}.csv")
        axes.imshow(near_edge.colours(letters["truth"], letters[method]), interpolation="nearest")
        axes.set_xticks([])
        axes.set_yticks([])
        for spine in axes.spines.values():
            spine.set(visible=True, color="#888888", linewidth=0.5)
        axes.set_title(f"{method},\n{DISTANCES[distance]}")
    save(figure, output, "map", ("pdf",))


def draw_onset(study, output):
    rows = rows_of(study / "onset.csv")
    distances = stability.distinct(rows, "origin_distance")
    figure, grid = plt.subplots(1, len(distances), figsize=(WIDTH, 2.6), sharey=True, layout="constrained")
    for axes, distance in zip(grid, distances):
        for method in in_order(stability.distinct(rows, "method")):
            look = look_of(method)
            curve = [row for row in rows if row["origin_distance"] == distance and row["method"] == method]
            x = [-int(row["offset_exponent"]) for row in curve]
            rate, lower, upper = ([100 * float(row[key]) for row in curve] for key in ("rate", "lower", "upper"))
            axes.fill_between(x, lower, upper, color=look.colour, alpha=0.15, linewidth=0)
            axes.plot(x, rate, color=look.colour, linestyle=look.line, marker=look.marker, markersize=2.5, linewidth=1, label=method)
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
            (row["measure"], row["family"], row["placement"]) == ("not-right", "all", "rotated")]
    figure, axes = plt.subplots(figsize=(WIDTH, 3.6))
    figure.subplots_adjust(left=0.12, right=0.98, top=0.98, bottom=0.12)
    tradeoff.set_limits(axes, rows)
    spots = tradeoff.draw_front(axes, rows, rows, 4.5, True)
    tradeoff.set_limits(axes, rows)
    figure.canvas.draw()
    if nameless := tradeoff.name_spots(axes, spots, spots, 6):
        raise ValueError(f"the picture of the front has no room for {', '.join(spot.method for spot in nameless)}")
    axes.set_xlabel("nanoseconds a question")
    axes.set_ylabel("answers not right within\n8 doubles of contact")
    save(figure, output, "front", ("pdf",))


FIGURES = {"near-edge": (draw_near_edge, draw_map), "stability": (draw_onset,), "tradeoff": (draw_front,)}


def draw(results, output):
    with plt.rc_context(TYPE):
        for study, drawings in FIGURES.items():
            for drawing in drawings:
                drawing(results / study, output)
