# SPDX-License-Identifier: GPL-3.0-or-later
"""Moving balls: wrong answers to whether they touch, the errors of their times, and what steps miss."""
import math
import textwrap

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Circle, Patch
from matplotlib.patches import Polygon as Outline

from asked import by_method
from looks import BLUE, RED, in_order
from page import bar, code, count, number, percent, share_of_size, smaller, upper_limit
from results import distinct, finite, maybe, natural, share
from results import number as any_number
from shares import percents
from studies import OUTPUT, Run, steps
from studies.regress import ENGINES
from style import curve, plt, rows_of, save

RUN = Run(10, "moving balls near their thresholds",
          full=[["motions", "--output", OUTPUT]], quick=[["motions", "--samples", "8", "--passes", "2000", "--output", OUTPUT]],
          tiny=["motions", "--methods", "exact,filtered,fast,cgal-epeck-distance", "--vertices", "6", "--samples", "1", "--passes", "100",
                "--repetitions", "1", "--no-pictures"])
TITLE = "Moving balls: contact on the way"

# How the ball moves, and what one of the threshold radius does.
WAYS = {"across": "passes across the way to its closest point", "along": "moves along an edge", "through": "falls through the plane",
        "start": "starts near the polygon", "end": "ends near the polygon", "anywhere": "moves anywhere"}
EVENTS = {("graze", "face"): "grazes a face", ("graze", "edge"): "grazes an edge", ("graze", "vertex"): "grazes a vertex",
          ("start", "face"): "starts at a face", ("start", "edge"): "starts at an edge", ("start", "vertex"): "starts at a vertex",
          ("end", "face"): "ends at a face", ("end", "edge"): "ends at an edge", ("end", "vertex"): "ends at a vertex"}
NO_SWEEP = ["ode", "embree-fast", "boost-geometry"]


class Data:
    def __init__(self, study):
        rows = study.rows("ways.csv", way=str, method=str, samples=natural, failed=natural, answers=natural, missed=natural,
                          invented=natural, unsure=natural, furthest=maybe(finite), timed=natural, correctly_rounded=natural,
                          median_ulps=maybe(any_number), worst_ulps=maybe(any_number), median_size=maybe(any_number), worst_size=maybe(any_number))
        self.methods = distinct(rows, "method")
        self.ways = [way for way in distinct(rows, "way") if way != "all"]
        self.at = {(row["way"], row["method"]): row for row in rows}
        self.thresholds = study.rows("thresholds.csv", event=str, feature=str, method=str, offset=finite, trials=natural,
                                     missed=natural, invented=natural, rate=share)

    def all(self, method):
        return self.at["all", method]

    def furthest(self, method, event, feature):
        """The largest share of the size by which a radius with a wrong answer is off such a threshold; None without one."""
        return max((abs(row["offset"]) for row in self.thresholds if row["method"] == method and row["event"] == event and
                    row["feature"] == feature and row["missed"] + row["invented"]), default=None)


def asked(study):
    """Whether the ball touches."""
    data = Data(study)
    rows = [dict(data.all(method), wrong=data.all(method)["missed"] + data.all(method)["invented"]) for method in data.methods]
    return by_method(rows, {row["method"]: row["samples"] for row in rows}, "motions")


ENGINE_HEADS = ["engine", "", "wrong motions", "missed contacts", "invented contacts", "largest offset of a wrong answer", "times rounded correctly",
                "worst time, of the size"]


def engine_lines(data):
    """The cells of a line for each engine, under the heads ENGINE_HEADS, for a page of Markdown."""
    def share_of(part, whole):
        return percents(part, whole, ".0f" if 100 * part / whole >= 9.5 else ".2g")

    lines = []
    for engine in data.methods:
        row = data.all(engine)
        samples, timed = row["samples"], row["timed"]
        wrong = share_of(row["failed"], samples) if row["failed"] else f"0 of {samples:,} (< {100 * upper_limit(samples):.2g} %)"
        offset = "none" if row["furthest"] is None else f"2^-{round(-math.log2(row['furthest']))}" if row["furthest"] else "at offset 0 alone"
        lines.append([engine, ENGINES[engine], wrong, f"{row['missed']:,}", f"{row['invented']:,}", offset,
                      share_of(row["correctly_rounded"], timed) if timed else "no time", f"{row['worst_size']:.2g}" if timed else ""])
    return lines


def failed(row):
    """A share of motions, with its limit where none failed."""
    if not row["failed"]:
        return f"0 of {count(row['samples'])} (&lt; {percent(upper_limit(row['samples']))})"
    return bar(row["failed"] / row["samples"], percent(row["failed"] / row["samples"]))


def offset(share):
    return "none" if share is None else "at 0" if share == 0 else share_of_size(share)


def method_row(row):
    timed = row["timed"]
    return [code(row["method"]), failed(row), count(row["missed"]), count(row["invented"]), offset(row["furthest"]),
            percent(row["correctly_rounded"] / timed) if timed else "no time",
            *(number(row[name], 2) if timed else "" for name in ("worst_ulps", "worst_size"))]


def told(study):
    data = Data(study)
    every = [data.all(method) for method in data.methods]
    share_failed = lambda row: percent(row["failed"] / row["samples"])
    events = [event for event in EVENTS if any((row["event"], row["feature"]) == event for row in data.thresholds)]
    return {
        "most": max(row["samples"] for row in every), "never": [code(row["method"]) for row in every if not row["failed"]],
        "wrong": [f"{code(row['method'])} {share_failed(row)}" for row in every if row["failed"]], "by_method": [method_row(row) for row in every],
        "ways": ["method", *(WAYS[way] for way in data.ways)], "events": ["method", *(EVENTS[event] for event in events)],
        "by_way": [[code(m), *(share_failed(row) if row["failed"] else "0" for row in (data.at[way, m] for way in data.ways))] for m in data.methods],
        "by_threshold": [[code(m), *(offset(data.furthest(m, *event)) for event in events)] for m in data.methods],
        "drawn": smaller(study.folder, "grazing-pass"), "steps": steps.told(study), "absent": [code(name) for name in NO_SWEEP if name not in data.methods]}


COLOURS = {"touches, rightly": "#ffffff", "misses, rightly": "#dddddd", "misses a contact": "#0072B2", "invents a contact": "#E69F00",
           "cannot tell": "#F0E442"}


def verdict(row):
    if row["contact"] == "":
        return 4
    if row["contact"] == row["truth"]:
        return 0 if row["truth"] == "1" else 1
    return 2 if row["truth"] == "1" else 3


def draw_scene(axes, spots):
    """The plane of the way and of the direction to the centre; the polygon as it lies before and behind it."""
    at = {}
    for what, x, y in spots:
        at.setdefault(what, []).append((x, y))
    for what, points in at.items():
        if what.startswith("loop"):
            axes.add_patch(Outline(points, facecolor="#dddddd", edgecolor="#555555", linewidth=2))
    (from_,), (to,), (center,) = at["from"], at["to"], at["center"]
    axes.annotate("", to, from_, arrowprops={"arrowstyle": "->", "color": BLUE})
    for place, line in ((from_, ":"), (center, "-"), (to, ":")):
        axes.add_patch(Circle(place, center[1], fill=False, edgecolor=BLUE, linestyle=line))
    axes.plot(*center, ".", color=BLUE)
    axes.plot(0, 0, "o", color=RED, markersize=4)
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.set_title("the ball of the threshold radius grazes the polygon (grey), seen from its side;\nlengths in sizes of the polygon")


def draw_verdicts(axes, rows, methods, offsets):
    right = [method for method in methods if all(verdict(row) < 2 for row in rows if row["method"] == method)]
    wrong = [method for method in methods if method not in right]
    names = ["all of the others", *wrong] if right else wrong
    methods, said = right[:1] + wrong, ", ".join(right)
    grid = np.full((len(methods), len(offsets)), np.nan)
    for row in (row for row in rows if row["method"] in methods):
        grid[methods.index(row["method"]), offsets.index(float(row["offset"]))] = verdict(row)
    axes.imshow(grid, cmap=ListedColormap(list(COLOURS.values())), vmin=-0.5, vmax=4.5, aspect="auto", interpolation="nearest")
    axes.set_yticks(range(len(methods)), names)
    shown = [o for o in offsets if o == 0 or abs(o) in (2.0**-4, 2.0**-16, 2.0**-28, 2.0**-40)]
    axes.set_xticks([offsets.index(o) for o in shown],
                    ["0" if o == 0 else f"${'-' if o < 0 else ''}2^{{{int(math.log2(abs(o)))}}}$" for o in shown])
    for y in range(len(methods) - 1):
        axes.axhline(y + 0.5, color="#ffffff", linewidth=1.5)
    axes.axvline(offsets.index(0.0), color="#888888", linewidth=0.6)
    axes.set_xlabel("radius less its threshold, in sizes: to the left the ball misses, to the right it touches")
    axes.set_title("does it touch?" + (textwrap.fill(f" Right throughout: {said}", 125) if right else ""))
    axes.legend(handles=[Patch(facecolor=colour, edgecolor="#888888", label=label) for label, colour in COLOURS.items()],
                loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=5, frameon=False, fontsize=8)


def draw_times(axes, rows, methods):
    """Errors of 0 stand at the foot."""
    lowest = 2.0**-60
    timed = {method: [(float(row["offset"]), float(row["time_error"])) for row in rows
                      if row["method"] == method and row["time_error"] != "" and float(row["offset"]) > 0] for method in methods}
    exact = [method for method, own in timed.items() if own and not any(error for _, error in own)]
    timed = {method: own for method, own in timed.items() if own and method not in exact}
    for method in in_order(timed):
        offsets, errors = zip(*timed[method])
        curve(axes, method, offsets, [max(error, lowest) for error in errors], markersize=3, linewidth=1)
    axes.set_xscale("log", base=2)
    axes.set_yscale("log", base=2)
    axes.set_ylim(lowest / 2, 2)
    axes.set_yticks([lowest, *(2.0**k for k in range(-50, 1, 10))], ["0", *(f"$2^{{{k}}}$" for k in range(-50, 0, 10)), "1"])
    axes.axhline(lowest, color="#000000", linewidth=1, label=f"0 throughout: {', '.join(exact)}" if exact else None)
    axes.set(ylabel="error of the time", xlabel="radius less its threshold, in sizes",
             title="error of the time, as way in sizes of the polygon")
    axes.grid(color="#dddddd", linewidth=0.5)
    axes.legend(fontsize=7, ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.2), frameon=False)


def draw_pass(folder):
    rows = rows_of(folder / "pass.csv")
    spots = [(row["what"], float(row["x"]), float(row["y"])) for row in rows_of(folder / "pass-scene.csv")]
    methods = distinct(rows, "method")
    offsets = sorted({float(row["offset"]) for row in rows})
    figure = plt.figure(figsize=(11, 8), layout="constrained")
    grid = figure.add_gridspec(2, 2, height_ratios=[1, 1.15])
    draw_scene(figure.add_subplot(grid[0, 0]), spots)
    draw_times(figure.add_subplot(grid[0, 1]), rows, methods)
    draw_verdicts(figure.add_subplot(grid[1, :]), rows, methods, offsets)
    save(figure, folder, "grazing-pass")


def main(folder):
    if (folder / "pass.csv").exists():  # a seed may have no such pass
        draw_pass(folder)
    steps.draw(folder)
