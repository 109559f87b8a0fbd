# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of `touchstone tradeoff`: tradeoff.py FOLDER draws the fronts and rates of the CSV files there.

Same data, same bytes: nothing here depends on the time or on chance."""
import csv
import math
import pathlib
import sys

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.transforms import ScaledTranslation

from near_edge import OWN_TEST, PLACEMENTS, TITLES, place
from style import STYLES, plt, save

# A colour a kind of method, a marker a method of it.
KINDS = [("thesis", "#D55E00", "thesis, variants"), ("fast", "#0072B2", "fast, scalars"), ("cgal", "#009E73", "CGAL's kernels"),
         ("interval", "#CC79A7", "intervals"), ("", "#000000", "exact")]
MARKERS = "os^vDPX*<>"
MEASURES = {
    "not-right": ("answers not right within 8 doubles of contact", "contact near the threshold"),
    "distance": ("error of the distance: 99 %, units in the last place", "the whole answer near the threshold"),
    "point": ("error of the closest point: 99 %, units in the last place", "the whole answer near the threshold"),
}
ROUNDED = 0.5  # the most by which a correctly rounded number is off, in units in the last place
BEYOND = 1e20  # where an error that is not finite is drawn


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def kind_of(method):
    return next(i for i, (prefix, _, _) in enumerate(KINDS) if method.startswith(prefix))


class Looks:
    """Colour and marker of each method, in the order of the data."""

    def __init__(self, methods):
        self.methods = sorted(dict.fromkeys(methods), key=kind_of)
        self.looks, counts = {}, {}
        for method in self.methods:
            kind = kind_of(method)
            marker = MARKERS[counts.get(kind, 0) % len(MARKERS)]
            counts[kind] = counts.get(kind, 0) + 1
            self.looks[method] = (KINDS[kind][1], marker)

    def handles(self, methods):
        return [Line2D([], [], color=self.looks[m][0], marker=self.looks[m][1], linestyle="", markersize=5, label=m)
                for m in self.methods if m in methods]


class Spot:
    """Where a method stands in a picture, and what is known of it beyond that."""

    def __init__(self, row):
        self.method, self.on_front = row["method"], row["on_front"] == "1"
        self.x, error = float(row["nanoseconds"]), float(row["error"])
        lower, upper = float(row["lower"]), float(row["upper"])
        if row["measure"] == "not-right":
            self.never = error == 0
            self.y = upper if self.never else error
            self.whisker = None if self.never else (lower, upper)
        else:  # lower is the median, upper the worst that was seen
            self.never = upper == 0
            self.y = min(max(error, ROUNDED), BEYOND)
            self.whisker = None if self.never else (self.y, min(max(upper, ROUNDED), BEYOND))


def draw_front(axes, rows, looks, size, whiskers):
    spots = [Spot(row) for row in rows]
    below = axes.transData + ScaledTranslation(0, -size / 72, axes.figure.dpi_scale_trans)
    for spot in spots:
        colour, marker = looks.looks[spot.method]
        if whiskers and spot.whisker:
            axes.plot([spot.x, spot.x], spot.whisker, color=colour, linewidth=0.8, alpha=0.5, zorder=1)
        axes.plot(spot.x, spot.y, marker, color=colour, markersize=size, zorder=3 if spot.on_front else 2,
                  markerfacecolor="white" if spot.never else colour)
        if spot.never:
            axes.plot(spot.x, spot.y, marker=11, color=colour, markersize=0.7 * size, transform=below, clip_on=False)
    front = sorted((spot.x, spot.y) for spot in spots if spot.on_front)
    if front:
        axes.step(*zip(*front), where="post", color="#777777", linewidth=1, zorder=0)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.minorticks_off()
    axes.grid(color="#dddddd", linewidth=0.5)
    return spots


def name_front(axes, spots, looks):
    """The names of those on the front beside them, where nothing else stands."""
    to_pixels, dpi = axes.transData.transform, axes.figure.dpi
    width, height = 4.6 * dpi / 72, 10 * dpi / 72  # of a letter of 8 points
    taken = [(x - 7, y - 7, x + 7, y + 7) for x, y in (to_pixels((s.x, s.y)) for s in spots)]
    front = sorted((s for s in spots if s.on_front), key=lambda s: s.x)
    corners = [to_pixels((s.x, s.y)) for s in front]
    for (x0, y0), (x1, y1) in zip(corners, corners[1:]):  # the step
        taken += [(x0, y0 - 1, x1, y0 + 1), (x1 - 1, min(y0, y1), x1 + 1, max(y0, y1))]
    frame = axes.get_window_extent()

    def free(box):
        return (frame.x0 < box[0] and box[2] < frame.x1 and frame.y0 < box[1] and box[3] < frame.y1 and
                all(box[2] <= t[0] or t[2] <= box[0] or box[3] <= t[1] or t[3] <= box[1] for t in taken))

    for spot in front:
        x, y = to_pixels((spot.x, spot.y))
        length = width * len(spot.method)
        boxes = [(x + dx, y + dy * height / 2, x + dx + length, y + (dy / 2 + 1) * height)
                 for dy in (-1, 0, -2, 1, -3, 2, -4, 3, -5, 4, -6, 5) for dx in (10, -10 - length, -length / 2)]
        box = next(filter(free, boxes), boxes[0])
        taken.append(box)
        axes.annotate(spot.method, (spot.x, spot.y), xytext=((box[0] - x) * 72 / dpi, ((box[1] + box[3]) / 2 - y) * 72 / dpi),
                      textcoords="offset points", va="center", fontsize=8, color=looks.looks[spot.method][0])


def explanation(measure, rows, whiskers):
    if measure == "not-right":
        limits = ", with 95 % limits (Hoeffding)" if whiskers else ""
        return (f"Filled: share of answers that are wrong, or \"don't know\"{limits}. Open, with a caret below: none seen; drawn at the "
                "upper 95 % limit.\n"
                "Grey step: the front, by what was seen: no other method is at least as fast and as right.")
    worst = ", the line ends at the worst" if whiskers else ""
    text = (f"Filled: 99 % of the errors are at most this{worst}. At 0.5: correctly rounded in 99 %; open, with a caret below: in "
            "all questions.\n"
            "Grey step: the front. Not here: methods that give no such number, or mostly don't know it.")
    if any(math.isinf(float(row["error"])) for row in rows):
        text += f" At $10^{{{round(math.log10(BEYOND))}}}$: not finite."
    return text


def set_limits(axes, rows):
    """All spots are seen, though not the whole of their lines; room for names."""
    spots = [Spot(row) for row in rows]
    low, high = min(s.y for s in spots), max(s.y for s in spots)
    limits = (low / 3, 2) if rows[0]["measure"] == "not-right" else (low / 30, max(10 * high, 30))
    axes.set_ylim(*limits)
    axes.set_xlim(min(s.x for s in spots) / 1.6, max(s.x for s in spots) * 1.4)


def placements_of(rows):
    return [placement for placement in PLACEMENTS if any(row["placement"] == placement for row in rows)]


def draw_pooled(rows, folder, measure, looks):
    placements = placements_of(rows)
    figure, grid = plt.subplots(1, len(placements), figsize=(5.3 * len(placements) + 1.7, 5.4), sharex=True, sharey=True,
                                squeeze=False)
    figure.subplots_adjust(left=0.07, right=0.855, top=0.87, bottom=0.18, wspace=0.06)
    drawn = []
    for axes, placement in zip(grid[0], placements):
        spots = draw_front(axes, [row for row in rows if row["placement"] == placement], looks, 6, True)
        axes.set_title(PLACEMENTS[placement])
        axes.set_xlabel(f"nanoseconds a question: {MEASURES[measure][1]}")
        drawn.append((axes, spots))
    set_limits(grid[0][0], rows)
    grid[0][0].set_ylabel(MEASURES[measure][0])
    figure.suptitle("Run time against error: all families of polygons together", x=0.01, ha="left")
    figure.text(0.01, 0.02, explanation(measure, rows, True), fontsize=8)
    figure.legend(handles=looks.handles({row["method"] for row in rows}), loc="center right", frameon=False, fontsize=8)
    figure.canvas.draw()
    for axes, spots in drawn:
        name_front(axes, spots, looks)
    save(figure, folder, f"front-{measure}")


def draw_families(rows, folder, measure, looks):
    families, placements = list(dict.fromkeys(row["family"] for row in rows)), placements_of(rows)
    columns = min(5, len(families))
    bands = math.ceil(len(families) / columns)
    lines = bands * len(placements)
    size = (2.4 * max(columns, 4) + 0.8, 1.9 * lines + 2)
    figure, grid = plt.subplots(lines, columns, figsize=size, sharex=True, sharey=True, squeeze=False)
    figure.subplots_adjust(left=0.65 / size[0], right=1 - 0.1 / size[0], top=1 - 1.15 / size[1], bottom=1 / size[1],
                           wspace=0.06, hspace=0.2)
    for axes in grid.flat:
        axes.set_visible(False)
    for i, placement in enumerate(placements):
        for j, family in enumerate(families):
            axes = grid[i * bands + j // columns][j % columns]
            axes.set_visible(True)
            draw_front(axes, [row for row in rows if row["placement"] == placement and row["family"] == family], looks, 4, False)
            axes.set_title(f"{family}, {placement}", fontsize=8, pad=3)
    set_limits(grid[0][0], rows)
    figure.supylabel(MEASURES[measure][0], fontsize=9, x=0.008)
    figure.text(0.5, 0.6 / size[1], f"nanoseconds a question: {MEASURES[measure][1]}", fontsize=9, ha="center")
    figure.text(0.01, 0.12 / size[1], explanation(measure, rows, False), fontsize=7.5)
    figure.suptitle("Run time against error, by family", x=0.01, y=1 - 0.12 / size[1], ha="left", va="top")
    figure.legend(handles=looks.handles({row["method"] for row in rows}), loc="upper left", ncol=7, frameon=False,
                  fontsize=7.5, bbox_to_anchor=(0, 1 - 0.3 / size[1]))
    save(figure, folder, f"front-{measure}-families")


def draw_offsets(rows, folder, placement):
    """Wrong answers by offset: a row a kind of method, a column a threshold."""
    rows = [row for row in rows if row["family"] == "all" and row["placement"] == placement]
    thresholds = [t for t in TITLES if any(row["threshold"] == t for row in rows)]
    kinds = [("thesis",), ("fast",), ("cgal", "interval", "")]
    titles = ["thesis", "fast", "CGAL, intervals, exact"]
    groups = []
    for prefixes in kinds:
        wanted = [i for i, kind in enumerate(KINDS) if kind[0] in prefixes]
        methods = list(dict.fromkeys(row["method"] for row in rows if kind_of(row["method"]) in wanted))
        if methods:
            groups.append((titles[kinds.index(prefixes)], methods))
    curves = {}
    for row in rows:
        curves.setdefault((row["threshold"], row["method"]), []).append(
            (place(int(row["offset"])), 100 * float(row["rate"]), 100 * float(row["lower"]), 100 * float(row["upper"])))
    figure, grid = plt.subplots(len(groups), len(thresholds), figsize=(2.3 * len(thresholds) + 1.9, 2.3 * len(groups) + 0.9),
                                sharex=True, sharey=True, squeeze=False, layout="constrained")
    for number, (line, (title, methods)) in enumerate(zip(grid, groups)):
        for axes, threshold in zip(line, thresholds):
            for method, (colour, style, marker) in zip(methods, STYLES * len(methods)):
                x, rate, lower, upper = np.array(curves[threshold, method]).T
                axes.fill_between(x, lower, upper, color=colour, alpha=0.12, linewidth=0)
                axes.plot(x, rate, color=colour, linestyle=style, linewidth=1.1, marker=marker, markersize=2.2, label=method)
            axes.set_xticks([place(k) for k in (-2**32, -2**16, -8, 0, 8, 2**16, 2**32)],
                            ["$-2^{32}$", "", "−8", "0", "8", "", "$2^{32}$"])
            axes.set_ylim(-3, 103)
            axes.grid(color="#dddddd", linewidth=0.5)
            if number == 0:
                test = "final answer" if not threshold.startswith("foot") else f"{OWN_TEST[threshold]} test"
                axes.set_title(f"{TITLES[threshold]}:\n{test}", fontsize=8.5)
        line[0].set_ylabel(f"{title}:\nwrong answers, %")
        line[-1].legend(loc="center left", bbox_to_anchor=(1.02, 0.5), frameon=False, fontsize=7.5)
    figure.supxlabel("offset of the radius (or of a centre coordinate) from its threshold, in doubles", fontsize=9)
    figure.suptitle(f"Wrong answers near thresholds: {PLACEMENTS[placement]}; all families; bands: 95 % limits", x=0.01, ha="left")
    save(figure, folder, f"offsets-{placement}")


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: tradeoff.py FOLDER")
    folder = pathlib.Path(sys.argv[1])
    front = read(folder / "front.csv")
    errors = read(folder / "errors.csv")
    looks = Looks(row["method"] for row in errors)
    for measure in MEASURES:
        rows = [row for row in front if row["measure"] == measure]
        if not rows:
            continue
        draw_pooled([row for row in rows if row["family"] == "all"], folder, measure, looks)
        draw_families([row for row in rows if row["family"] != "all"], folder, measure, looks)
    for placement in PLACEMENTS:
        if any(row["placement"] == placement for row in errors):
            draw_offsets(errors, folder, placement)


if __name__ == "__main__":
    main()
