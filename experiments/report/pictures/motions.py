# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of `touchstone motions`: a grazing pass, and what each method says of it.

Same data, same bytes: nothing here depends on the time or on chance."""
import csv
import math
import textwrap

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Circle, Patch
from matplotlib.patches import Polygon as Outline

from looks import in_order, look_of
from pictures.style import STYLES, plt, save

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
    axes.annotate("", to, from_, arrowprops={"arrowstyle": "->", "color": STYLES[0][0]})
    for place, line in ((from_, ":"), (center, "-"), (to, ":")):
        axes.add_patch(Circle(place, center[1], fill=False, edgecolor=STYLES[0][0], linestyle=line))
    axes.plot(*center, ".", color=STYLES[0][0])
    axes.plot(0, 0, "o", color=STYLES[2][0], markersize=4)
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
        look = look_of(method)
        offsets, errors = zip(*timed[method])
        axes.plot(offsets, [max(error, lowest) for error in errors], color=look.colour, linestyle=look.line, marker=look.marker,
                  markersize=3, linewidth=1, label=method)
    axes.set_xscale("log", base=2)
    axes.set_yscale("log", base=2)
    axes.set_ylim(lowest / 2, 2)
    axes.set_yticks([lowest, *(2.0**k for k in range(-50, 1, 10))], ["0", *(f"$2^{{{k}}}$" for k in range(-50, 0, 10)), "1"])
    axes.axhline(lowest, color="#000000", linewidth=1, label=f"0 throughout: {', '.join(exact)}" if exact else None)
    axes.set_ylabel("error of the time")
    axes.set_xlabel("radius less its threshold, in sizes")
    axes.set_title("error of the time, as way in sizes of the polygon")
    axes.grid(color="#dddddd", linewidth=0.5)
    axes.legend(fontsize=7, ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.2), frameon=False)


def main(folder):
    with open(folder / "pass.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    with open(folder / "pass-scene.csv", newline="") as file:
        spots = [(row["what"], float(row["x"]), float(row["y"])) for row in csv.DictReader(file)]
    methods = list(dict.fromkeys(row["method"] for row in rows))
    offsets = sorted({float(row["offset"]) for row in rows})
    figure = plt.figure(figsize=(11, 8), layout="constrained")
    grid = figure.add_gridspec(2, 2, height_ratios=[1, 1.15])
    draw_scene(figure.add_subplot(grid[0, 0]), spots)
    draw_times(figure.add_subplot(grid[0, 1]), rows, methods)
    draw_verdicts(figure.add_subplot(grid[1, :]), rows, methods, offsets)
    save(figure, folder, "grazing-pass")
