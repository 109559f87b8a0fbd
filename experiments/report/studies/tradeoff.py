# SPDX-License-Identifier: GPL-3.0-or-later
"""Run time and error of methods near contact."""
import math

import numpy as np
from matplotlib.legend_handler import HandlerTuple
from matplotlib.lines import Line2D
from matplotlib.path import Path as MarkerPath
from matplotlib.textpath import TextPath

from asked import by_method
from looks import asks_the_question, by_group, in_order, look_of
from names import OWN_TEST, PLACEMENTS, TITLES
from noise import TOO_NOISY, is_steady
from page import bar, code, multiple, percent, power, smaller, words
from results import distinct, finite, natural
from results import number as any_number
from shares import unless_whole
from studies import OUTPUT, Run
from studies.near_edge import SCALE, TICKS, UNIT, place
from style import curve, draw, plt, rows_of, save

RUN = Run(5, "run time against error", full=[["tradeoff", "--output", OUTPUT]],
          quick=[["tradeoff", "--samples", "12", "--queries", "300", "--repetitions", "11", "--output", OUTPUT]],
          tiny=["tradeoff", "--methods", "fast,filtered,exact,interval", "--families", "u", "--samples", "2", "--queries", "2",
                "--repetitions", "1", "--no-pictures"])
TITLE = "What being right costs"
NAMES = {"planar": "planar", "rotated": "rotated"}


class Data:
    def __init__(self, study):
        self.front = [row for row in study.rows("front.csv", measure=str, family=str, placement=str, method=str, nanoseconds=finite,
                                                lower_quartile_ns=finite, upper_quartile_ns=finite,
                                                error=any_number, lower=any_number, upper=any_number, samples=natural, front=str)
                      if row["family"] == "all"]
        self.bands = [row for row in study.rows("bands.csv", family=str, placement=str, threshold=str, test=str, method=str, samples=natural,
                                                wrong=natural, unsure=natural, lift=natural, answers=natural)
                      if row["family"] == "all" and row["test"] == "contact"]
        self.timings = study.rows("timings.csv", family=str, placement=str, balls=str, question=str, method=str, lower_quartile_ns=finite, median_ns=finite,
                                  upper_quartile_ns=finite)
        self.placements = distinct(self.front, "placement", PLACEMENTS)
        self.methods = distinct(self.front, "method")

    def rate(self, method, placement):
        """The row of not-right answers; None where the method gives no final answer."""
        return next((row for row in self.front if (row["measure"], row["method"], row["placement"]) == ("not-right", method, placement)), None)

    def reach(self, method, placement):
        """The largest offset with an answer that is not right, in u x size; None where the method gives no final answer."""
        return next((row["error"] for row in self.front if (row["measure"], row["method"], row["placement"]) == ("reach", method, placement)), None)

    def nanoseconds(self, method, placement, balls, which="median_ns"):
        """The mean over families of the medians, or quartiles, of a question about contact; None where it was not timed."""
        times = [row[which] for row in self.timings if
                 (row["method"], row["placement"], row["balls"], row["question"]) == (method, placement, balls, "contact")]
        return sum(times) / len(times) if times else None

    def ratio(self, method, placement, balls):
        """To fast; None where one was not timed."""
        own, fast = (self.nanoseconds(m, placement, balls) for m in (method, "fast"))
        return own / fast if own and fast else None

    def is_noisy(self, method, placement, balls):
        """Whether the times of the method, or those of fast, vary too much to quote their ratio."""
        return not all(is_steady(*(self.nanoseconds(m, placement, balls, f"{which}_quartile_ns") for which in ("lower", "upper"))) for m in (method, "fast"))


def asked(study):
    """Final answers."""
    rows = [row for row in Data(study).bands if asks_the_question(row["method"], row["placement"])]
    polygons = {}
    for row in rows:
        polygons[row["method"]] = polygons.get(row["method"], 0) + row["samples"]
    return by_method(rows, polygons, "polygons")


def range_of(numbers):
    low, high = min(numbers), max(numbers)
    return f"{low:,}" if low == high else f"{low:,} to {high:,}"


def times(data, method, placement, balls):
    """Of the time of fast."""
    ratio = data.ratio(method, placement, balls)
    return "not timed" if ratio is None else TOO_NOISY if data.is_noisy(method, placement, balls) else multiple(ratio)


def rate(data, method, placement):
    row = data.rate(method, placement) if asks_the_question(method, placement) else None
    return "" if row is None else bar(row["error"], percent(row["error"])) if row["error"] else f"0 <small>(&lt; {percent(row['upper'])})</small>"


def reach(data, method, placement):
    found = data.reach(method, placement) if asks_the_question(method, placement) else None
    return "" if found is None else power("2", round(math.log2(found))) if found else "none"


def on_front(rows, placement):
    """In words, with those that noise may keep from it."""
    on, perhaps = ([row["method"] for row in rows if (row["placement"], row["front"]) == (placement, front)] for front in ("on", "within-noise"))
    return (f"{PLACEMENTS[placement]}: on the front {words(map(code, on)) if on else 'no method for certain'}"
            + (f", {len(perhaps)} more within timing noise" if perhaps else ""))


def told(study):
    data = Data(study)
    first = data.placements[0]
    rows = [row for row in data.front if row["measure"] == "not-right" and asks_the_question(row["method"], row["placement"])]
    return {
        "data": data, "first": NAMES[first], "never": [code(row["method"]) for row in rows if row["placement"] == first and not row["error"]],
        "front": smaller(study.folder, "front-not-right"), "drawn": len({row["method"] for row in rows}),
        "on_front": [on_front(rows, placement) for placement in data.placements] if rows else [],
        "heads": ["method", *(f"not right, {NAMES[p]}" for p in data.placements), *(f"furthest, {NAMES[p]}" for p in data.placements),
                  *(f"time {where}, {NAMES[p]}" for where in ("near contact", "anywhere") for p in data.placements)],
        "rates": [[code(m), *(rate(data, m, p) for p in data.placements), *(reach(data, m, p) for p in data.placements), *(times(data, m, p, balls) for balls in ("near", "anywhere") for p in data.placements)]
                  for m in data.methods],
        "samples": range_of([row["samples"] for row in data.front])}


MEASURES = {
    "not-right": (f"answers not right within {UNIT} of contact", "contact near the threshold"),
    "reach": (f"the furthest answer from contact that is not right, in {UNIT}", "contact near the threshold"),
    "distance": ("error of the distance: 99 %, units in the last place", "the whole answer near the threshold"),
    "point": ("error of the closest point: 99 %, units in the last place", "the whole answer near the threshold"),
}
SUBJECTS = {"not-right": "wrong answers", "reach": "how far from contact answers are wrong", "distance": "the error of the distance", "point": "the error of the closest point"}
COUNTED = ("not-right", "reach")  # measures that are 0 for a method that was never wrong
STRIP = 16  # how far below the least share that was seen those methods stand of which none was
ROUNDED = 0.5  # the most by which a correctly rounded number is off, in units in the last place


def handles(methods):
    return [Line2D([], [], color=look_of(m).colour, marker=look_of(m).marker, linestyle="", markersize=5, label=m) for m in in_order(methods)]


def strip_of(rows):
    """The height of the strip of methods that were never wrong; None where errors are not counted."""
    if rows[0]["measure"] not in COUNTED:
        return None
    return min((float(row["error"]) for row in rows if float(row["error"]) > 0), default=1) / STRIP


class Spot:
    """Where a method stands in a picture, and what is known of it beyond that."""

    def __init__(self, row, strip):
        self.method, self.front = row["method"], row["front"]
        self.through = " (through a pipe)" if row.get("through") == "pipe" else ""
        self.x = float(row["nanoseconds"])
        self.quartiles = float(row["lower_quartile_ns"]), float(row["upper_quartile_ns"])
        error, lower, upper = float(row["finite_error"]), float(row["lower"]), float(row["upper"])
        self.not_finite, self.error = float(row["not_finite"]), float(row["error"])
        self.samples = int(row["samples"])
        if row["measure"] in COUNTED:
            self.never = error == 0
            self.y = self.level = strip if self.never else error
            self.whisker = None if self.never or lower == upper else (max(lower, strip * STRIP**0.6), upper)
        else:  # lower is the median, upper the worst that was seen
            self.never = upper == 0 and self.not_finite == 0
            self.y = self.level = max(error, ROUNDED)
            self.whisker = None if self.never else (self.y, max(upper, ROUNDED))
        self.in_strip = self.never and strip is not None

    @property
    def name(self):
        of = f" (0 of {self.samples:,})" if self.in_strip else ""
        overflow = f" ({unless_whole(self.not_finite, f'{100 * self.not_finite:.2g}')} % overflow)" if self.not_finite > 0 else ""
        return self.method + of + self.through + overflow


def staircase(spots, time):
    """The least error that was seen of those that need at most so much time, by the time of each."""
    corners, least = [], math.inf
    for spot in sorted(spots, key=lambda s: (time(s), s.level)):
        if spot.level < least and math.isfinite(spot.error):
            least = spot.level
            corners.append((time(spot), least))
    return corners


def heights(corners, x):
    """Of a staircase at each x; NaN before its first corner."""
    y = np.full(len(x), np.nan)
    for begin, height in corners:
        y[x >= begin] = height
    return y


def draw_band(axes, spots):
    """Grey: the staircase by medians, and between those by lower and by upper quartiles."""
    ends = [spot.quartiles for spot in spots]
    x = np.geomspace(min(low for low, _ in ends) / 2, 2 * max(high for _, high in ends), 2000)
    best, worst = (heights(staircase(spots, lambda s, k=k: s.quartiles[k]), x) for k in (0, 1))
    worst = np.where(np.isnan(worst), 1e30, worst)  # nobody is surely as fast
    known = ~np.isnan(best)
    axes.fill_between(x[known], best[known], worst[known], color="#dddddd", linewidth=0, zorder=0)
    corners = staircase(spots, lambda s: s.x)
    axes.step(*zip(*corners, (x[-1], corners[-1][1])), where="post", color="#777777", linewidth=1, zorder=0.5)


DOWN = MarkerPath([(0, 0), (0, -1), (-0.2, -0.75), (0, -1), (0.2, -0.75)], [MarkerPath.MOVETO, MarkerPath.LINETO, MarkerPath.MOVETO, MarkerPath.LINETO, MarkerPath.LINETO])
UP = MarkerPath(-DOWN.vertices, DOWN.codes)


def arrow(x, y, colour, size, path):
    """From a mark of a size, three times as long."""
    return Line2D([x], [y], color=colour, linestyle="", marker=path, markersize=6 * size, markerfacecolor="none", markeredgewidth=0.8, zorder=1.5)


# A circle in pieces, for what is perhaps on the front.
PIECES = MarkerPath.make_compound_path(*(MarkerPath.arc(a, a + 35) for a in range(0, 360, 60)))


def ring(x, y, front, size):
    """A circle about a point on the front; in pieces, where it is perhaps."""
    return Line2D([x], [y], color="#444444", linestyle="", marker="o" if front == "on" else PIECES, markersize=size,
                  markerfacecolor="none", markeredgewidth=0.8, zorder=2.5)


def draw_front(axes, rows, every, size, whiskers):
    """The limits of the axes are set before: where nobody is as fast, the band reaches the top. `rows` are those of `every`
    that stand in this panel."""
    strip = strip_of(every)
    spots = [Spot(row, strip) for row in rows]
    draw_band(axes, spots)
    for spot in spots:
        colour, marker = look_of(spot.method).colour, look_of(spot.method).marker
        here, pale = size if spot.front != "off" else 0.7 * size, 1 if spot.front != "off" else 0.45
        axes.plot(spot.quartiles, [spot.y, spot.y], color=colour, linewidth=1, alpha=pale, zorder=1)
        if whiskers and spot.whisker:
            axes.plot([spot.x, spot.x], spot.whisker, color=colour, linewidth=0.8, alpha=0.5 * pale, zorder=1)
        if spot.never and not spot.in_strip:
            axes.add_line(arrow(spot.x, spot.y, colour, here, DOWN))
        elif spot.not_finite > 0 and rows[0]["measure"] not in COUNTED:
            axes.add_line(arrow(spot.x, spot.y, colour, here, UP))
        axes.plot(spot.x, spot.y, marker, color=colour, markersize=here, zorder=3 if spot.front != "off" else 2, alpha=pale,
                  markerfacecolor="white" if spot.never else colour)
        if spot.front != "off":
            axes.add_line(ring(spot.x, spot.y, spot.front, 1.9 * size))
    axes.set(xscale="log", yscale="log")
    axes.minorticks_off()
    axes.grid(color="#eeeeee", linewidth=0.5)
    return spots


def obstacles(axes, spots):
    """Boxes, in pixels, that names must not cover: marks, their lines, and the front by medians."""
    to_pixels, scale = axes.transData.transform, axes.figure.dpi / 72

    def line(begin, end, width=1):
        (x0, y0), (x1, y1) = to_pixels(begin), to_pixels(end)
        return min(x0, x1) - width, min(y0, y1) - width, max(x0, x1) + width, max(y0, y1) + width

    marks = [line((s.x, s.y), (s.x, s.y), (4 if s.front == "off" else 6) * scale) for s in spots]
    lines = [line((s.quartiles[0], s.y), (s.quartiles[1], s.y)) for s in spots]
    lines += [line((s.x, s.whisker[0]), (s.x, s.whisker[1])) for s in spots if s.whisker]
    corners = staircase(spots, lambda s: s.x)
    for (x0, y0), (x1, y1) in zip(corners, [*corners[1:], (axes.get_xlim()[1], corners[-1][1])]):
        lines += [line((x0, y0), (x1, y0)), line((x1, y0), (x1, y1))]
    return marks + lines


def apart(box, other):
    return box[2] <= other[0] or other[2] <= box[0] or box[3] <= other[1] or other[3] <= box[1]


def crosses(begin, end, boxes):
    """Whether the line between two points meets a box, to a twentieth of its length."""
    points = [tuple(b + k / 20 * (e - b) for b, e in zip(begin, end)) for k in range(21)]
    return any(not apart((*point, *point), box) for point in points for box in boxes)


def name_spots(axes, spots, named, size):
    """Draws a name, in letters of `size` points, beside each of the `named` spots: on a side, and as far up or down, where it covers
    nothing; the line to the spot crosses no earlier name if that can be. Returns those that have no room for theirs. The figure
    has been drawn."""
    scale, frame, taken, without_room = axes.figure.dpi / 72, axes.get_window_extent().padded(-3), obstacles(axes, spots), []
    names = []
    for spot in sorted(named, key=lambda s: (s.front != "on", s.front == "off", s.x)):
        x, y = axes.transData.transform((spot.x, spot.y))
        length, height = TextPath((0, 0), spot.name, size=size).get_extents().width * scale, 1.2 * size * scale
        boxes = [(x + dx, y + dy * height - height / 2, x + dx + length, y + dy * height + height / 2)
                 for reach in range(13) for dx in (8 * scale, -8 * scale - length, -length / 2) for dy in (reach / 2, -reach / 2)]
        free = [box for box in boxes if frame.x0 < box[0] and box[2] < frame.x1 and frame.y0 < box[1] and box[3] < frame.y1
                and all(apart(box, other) for other in taken + names)]
        if not free:
            without_room.append(spot)
            continue
        box = next((box for box in free if not crosses(((box[0] + box[2]) / 2, (box[1] + box[3]) / 2), (x, y), names)), free[0])
        names.append(box)
        middle = (box[1] + box[3]) / 2
        to_spot = {"arrowstyle": "-", "linewidth": 0.4, "color": "#999999", "shrinkA": 0, "shrinkB": 3} if abs(middle - y) > height else None
        axes.annotate(spot.name, (spot.x, spot.y), xytext=((box[0] - x) / scale, (middle - y) / scale), textcoords="offset points",
                      va="center", fontsize=size, color=look_of(spot.method).colour, arrowprops=to_spot)
    return without_room


def symbols(measure, rows):
    """Legend lines, as pairs, for what is not a plain measured point."""
    def marker(shape, size=5, **more):
        return Line2D([], [], color="#444444", linestyle="", marker=shape, markersize=size, **more)

    spots = [Spot(row, strip_of(rows)) for row in rows]
    lines = [((marker("o"), ring([], [], "on", 9.5)), "on the front"),
             ((marker("o"), ring([], [], "within-noise", 9.5)), "perhaps: within noise"),
             (Line2D([], [], color="#444444", linewidth=1), "quartiles of the time")]
    never = [spot.samples for spot in spots if spot.never and not spot.in_strip]
    if never:
        open_marker = (arrow([], [], "#444444", 3, DOWN), marker("o", markerfacecolor="white"))
        lines.append((open_marker, f"all correctly rounded:\n{range_of(never)} polygons"))
    if measure not in COUNTED and any(spot.not_finite > 0 for spot in spots):
        lines.append(((arrow([], [], "#444444", 3, UP), marker("o")), "of finite answers;\nothers overflow"))
    return lines


def set_limits(axes, rows):
    """All spots are seen, though not the whole of their lines; room for names, and for the strip."""
    strip = strip_of(rows)
    spots = [Spot(row, strip) for row in rows]
    low, high = min(s.y for s in spots), max(s.y for s in spots)
    limits = (low / 3, 2 * max(high, 1)) if rows[0]["measure"] in COUNTED else (low / 30, max(30 * high, 30))
    axes.set_ylim(*limits)
    axes.set_xlim(min(s.quartiles[0] for s in spots) / 1.3, max(s.quartiles[1] for s in spots) * 1.3)
    if strip is None:
        return
    edge = strip * STRIP**0.5
    axes.axhspan(limits[0], edge, color="#eef6f2", linewidth=0, zorder=-1)
    axes.axhline(edge, color="#777777", linewidth=0.8, zorder=-0.5)
    base, step = (2, 8) if rows[0]["measure"] == "reach" else (10, 1)
    first = math.ceil(math.log(edge, base) / step) * step
    ticks = [float(base)**k for k in range(first, max(round(math.log(max(high, 1), base)), first) + 1, step)]
    axes.set_yticks([strip, *ticks], ["none\nwrong", *("1" if t == 1 else f"${base}^{{{round(math.log(t, base))}}}$" for t in ticks)])


def legend(figure, measure, rows, **where):
    lines = [*((handle, handle.get_label()) for handle in handles(row["method"] for row in rows)), *symbols(measure, rows)]
    figure.legend(*zip(*lines), frameon=False, handler_map={tuple: HandlerTuple(1, 0)}, **where)


def legend_by_group(figure, measure, rows):
    """A column a group of methods, below the panels."""
    columns = [(title, [(handle, handle.get_label()) for handle in handles(methods)])
               for title, methods in by_group(row["method"] for row in rows).items()]
    columns.append(("signs", symbols(measure, rows)))
    for number, (title, lines) in enumerate(columns):
        figure.legend(*zip(*lines), title=title, loc="upper left", bbox_to_anchor=(0.01 + 0.98 * number / len(columns), 0.235), frameon=False, fontsize=8.5,
                      title_fontproperties={"size": 9, "weight": "bold"}, alignment="left", labelspacing=0.3, handler_map={tuple: HandlerTuple(1, 0)})


def draw_pooled(rows, folder, measure):
    placements = distinct(rows, "placement", PLACEMENTS)
    figure, grid = plt.subplots(1, len(placements), figsize=(6.2 * len(placements), 7.6), sharex=True, sharey=True, squeeze=False)
    figure.subplots_adjust(left=0.08, right=0.99, top=0.92, bottom=0.3, wspace=0.05)
    drawn = []
    for axes, placement in zip(grid[0], placements):
        spots = draw_front(axes, [row for row in rows if row["placement"] == placement], rows, 6, True)
        axes.set(title=PLACEMENTS[placement], xlabel=f"nanoseconds a question: {MEASURES[measure][1]}")
        drawn.append((axes, spots))
    for axes in grid.flat:
        set_limits(axes, rows)
    grid[0][0].set_ylabel(MEASURES[measure][0])
    figure.suptitle(f"Run time against {SUBJECTS[measure]}: all families of polygons together", x=0.01, ha="left")
    legend_by_group(figure, measure, rows)
    figure.canvas.draw()
    for axes, spots in drawn:
        name_spots(axes, spots, [s for s in spots if s.front != "off" or s.not_finite > 0 or s.never], 8)
    save(figure, folder, f"front-{measure}")


def draw_families(rows, folder, measure):
    families, placements = distinct(rows, "family"), distinct(rows, "placement", PLACEMENTS)
    columns = min(5, len(families))
    bands = math.ceil(len(families) / columns)
    lines = bands * len(placements)
    size = (2.4 * max(columns, 4) + 0.8, 1.9 * lines + 3)
    figure, grid = plt.subplots(lines, columns, figsize=size, sharex=True, sharey=True, squeeze=False)
    figure.subplots_adjust(left=0.65 / size[0], right=1 - 0.1 / size[0], top=1 - 1.75 / size[1], bottom=0.8 / size[1],
                           wspace=0.06, hspace=0.2)
    for axes in grid.flat:
        axes.set_visible(False)
    for i, placement in enumerate(placements):
        for j, family in enumerate(families):
            axes = grid[i * bands + j // columns][j % columns]
            axes.set_visible(True)
            draw_front(axes, [row for row in rows if row["placement"] == placement and row["family"] == family], rows, 4, False)
            axes.set_title(f"{family}, {placement}", fontsize=8, pad=3)
    for axes in grid.flat:
        set_limits(axes, rows)
    figure.supylabel(MEASURES[measure][0], fontsize=9, x=0.008)
    figure.text(0.5, 0.2 / size[1], f"nanoseconds a question: {MEASURES[measure][1]}", fontsize=9, ha="center")
    figure.suptitle(f"Run time against {SUBJECTS[measure]}, by family", x=0.01, y=1 - 0.12 / size[1], ha="left", va="top")
    legend(figure, measure, rows, loc="upper left", ncol=7, fontsize=7, bbox_to_anchor=(0, 1 - 0.3 / size[1]))
    save(figure, folder, f"front-{measure}-families")


def draw_offsets(rows, folder, placement):
    """Wrong answers by offset: a row a kind of method, a column a threshold."""
    rows = [row for row in rows if row["family"] == "all" and row["placement"] == placement]
    thresholds = distinct(rows, "threshold", TITLES)
    groups, curves = by_group(row["method"] for row in rows), {}
    for row in rows:
        curves.setdefault((row["threshold"], row["method"]), []).append(
            (place(float(row["offset"])), 100 * float(row["rate"]), 100 * float(row["lower"]), 100 * float(row["upper"])))
    figure, grid = plt.subplots(len(groups), len(thresholds), figsize=(2.3 * len(thresholds) + 1.9, 2.3 * len(groups) + 0.9),
                                sharex=True, sharey=True, squeeze=False, layout="constrained")
    for number, (line, (title, methods)) in enumerate(zip(grid, groups.items())):
        for axes, threshold in zip(line, thresholds):
            for method in methods:
                points = curves.get((threshold, method))  # None: it has no such test
                curve(axes, method, *(np.array(points).T if points else ([], [])), shade=0.12, linewidth=1.1, markersize=2.2)
            axes.set_xticks([place(k) for k in TICKS], TICKS.values(), fontsize=6.5)
            axes.set_ylim(-3, 103)
            axes.grid(color="#dddddd", linewidth=0.5)
            if number == 0:
                test = "final answer" if not threshold.startswith("foot") else f"{OWN_TEST[threshold]} test"
                axes.set_title(f"{TITLES[threshold]}:\n{test}", fontsize=8.5)
        line[0].set_ylabel(f"{title}:\nwrong answers, %")
        line[-1].legend(loc="center left", bbox_to_anchor=(1.02, 0.5), frameon=False, fontsize=7.5)
    figure.supxlabel(f"offset of the radius (or of a centre coordinate): {SCALE}", fontsize=9)
    figure.suptitle(f"Wrong answers near thresholds: {PLACEMENTS[placement]}; all families; bands: 95 % limits", x=0.01, ha="left")
    save(figure, folder, f"offsets-{placement}")


def main(folder):
    front = [row for row in rows_of(folder / "front.csv") if asks_the_question(row["method"], row["placement"])]
    errors = rows_of(folder / "errors.csv")
    by_measure = {measure: rows for measure in MEASURES if (rows := [row for row in front if row["measure"] == measure])}
    draw([*((draw_families, [row for row in rows if row["family"] != "all"], folder, measure) for measure, rows in by_measure.items()),
          *((draw_offsets, errors, folder, placement) for placement in distinct(errors, "placement", PLACEMENTS)),
          *((draw_pooled, [row for row in rows if row["family"] == "all"], folder, measure) for measure, rows in by_measure.items())])
