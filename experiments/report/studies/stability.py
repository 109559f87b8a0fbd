# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons under stress: how many of them methods fail on, and from which level."""
import math

import numpy as np

import chart
from asked import Asked
from looks import in_order, look_of
from names import NAMED
from page import code, level, percent, percent_number, power, smaller, words
from results import distinct, finite, natural, share
from shares import unless_whole
from studies import OUTPUT, Run
from style import curve, draw, plt, rows_of, save

RUN = Run(4, "polygons under stress",
          full=[["stability", "--output", OUTPUT]], quick=[["stability", "--samples", "12", "--output", OUTPUT]],
          tiny=["stability", "--methods", "filtered,fast", "--axes", "aspect,origin,small,rounding", "--samples", "2", "--no-pictures"])
TITLE = "Polygons under stress"

# What is made worse: the title of each axis, and what its levels are.
AXES = {"aspect": ("slivers", "length / width"),
        "parallel": ("near-parallel edges", "angle, radians"),
        "duplicate": ("near-duplicate vertices", "distance / size"),
        "collinear-exact": ("straight side, exactly", "vertices on it"),
        "collinear-rounded": ("straight side, rounded", "vertices on it"),
        "origin": ("away from the origin", "distance / size"),
        "small": ("small numbers", "binary exponent"),
        "large": ("large numbers", "binary exponent"),
        "mixed": ("mixed exponents", "binary orders between axes"),
        "off-plane": ("a vertex off the plane", "ulps"),
        "vertices": ("many vertices", "vertices"),
        "chain-input": ("chain of rotations,\nagainst exact on its end", "steps"),
        "chain-motion": ("chain of rotations,\nagainst the motion meant", "steps"),
        "pose-input": ("chain of pose products,\nagainst exact on its end", "steps"),
        "pose-motion": ("chain of pose products,\nagainst the motion meant", "steps"),
        "rounding": ("rounding direction", "mode"),
        "flush": ("subnormals flushed", "mode")}
WIDTH, LEFT, RIGHT, ROW, BAR = 360, 4, 300, 34, 13  # of the drawing of stress
MODES = {"rounding", "flush"}  # axes whose levels are not in an order
NEARNESSES = {"one-double": "radius at the exact distance, or one double off",
              "close": "radius off by 2⁻³⁰ of the distance",
              "ample": "radius off by a quarter of the distance"}


BEYOND = ("small", "large", "mixed")  # axes on which products leave the doubles: fast.h promises nothing there
STAND_IN = "-motion"  # axes on which filtered and exact stand for the motion of doubles, and err as that does


class Data:
    def __init__(self, study):
        rows = study.rows("failures.csv", axis=str, level=str, nearness=str, test=str, method=str, failed_samples=natural, samples=natural,
                          wrong_answers=natural, answers=natural)
        self.all_tests = rows
        self.rows = [row for row in rows if row["test"] == "contact"]
        self.first = [row for row in study.rows("first-failure.csv", axis=str, nearness=str, test=str, method=str, first_failure=str,
                                                failed_samples=natural, samples=natural) if row["test"] == "contact"]
        self.onset = study.rows("onset.csv", origin_distance=finite, method=str, offset_exponent=int, failed_triangles=natural,
                                triangles=natural, wrong_answers=natural, answers=natural, rate=share)
        self.methods = distinct(self.rows, "method")
        self.axes = distinct(self.rows, "axis", AXES)

    def failed(self, method, nearness, axes=None):
        """Polygons that the method was wrong about, and all: on these axes, otherwise on those whose sizes `fast` promises. Without axes
        whose truth is another one."""
        own = [row for row in self.rows if row["method"] == method and row["nearness"] == nearness and row["axis"] not in MODES
               and not row["axis"].endswith(STAND_IN) and (row["axis"] in axes if axes else row["axis"] not in BEYOND)]
        return sum(row["failed_samples"] for row in own), sum(row["samples"] for row in own)

    def first_failure(self, axis, nearness, method):
        """The level, "" where none failed; None where it was not asked."""
        return next((row["first_failure"] for row in self.first
                     if (row["axis"], row["nearness"], row["method"]) == (axis, nearness, method)), None)


def asked(study):
    data = Data(study)
    counts = {}
    for method in data.methods:
        rows = [row for row in data.rows if row["method"] == method and not row["axis"].endswith(STAND_IN)]
        polygons = sum(row["samples"] for row in rows if row["nearness"] == rows[0]["nearness"])
        counts[method] = Asked(sum(row["answers"] for row in rows), sum(row["wrong_answers"] for row in rows), polygons, "polygons")
    return counts


SAID = {"aspect": ("slivers {} times as long as wide", level), "origin": ("polygons {} sizes from the origin", level),
        "small": ("coordinates of about {}", lambda text: power("2", text)), "large": ("coordinates of about {}", lambda text: power("2", text))}


def onsets(data):
    """In words, at each distance from the origin."""
    for distance in distinct(data.onset, "origin_distance"):
        seen = []
        for method in ("fast", "thesis", "filtered"):
            own = [row for row in data.onset if row["origin_distance"] == distance and row["method"] == method]
            wrong = [row["offset_exponent"] for row in own if row["failed_triangles"]]
            if own:
                seen.append(f"{code(method)} from {power('2', max(wrong))} on" if wrong else f"{code(method)} nowhere")
        place = "at the origin" if distance == 0 else f"{level(f'{distance:.0e}'.replace('e+0', 'e'))} sizes away"
        yield f"{place}, wrong answers of {words(seen)}"


def told(study):
    data = Data(study)
    failed, beyond = ({method: data.failed(method, "ample", axes) for method in data.methods} for axes in (None, BEYOND))
    return {
        "data": data, "ample": NEARNESSES["ample"], "failures": smaller(study.folder, "failures"), "onset": smaller(study.folder, "onset"),
        "first_failures": [said.format(shown(found)) for axis, (said, shown) in SAID.items() if (found := data.first_failure(axis, "close", "fast"))],
        "stress": stress_drawing(data),
        "beyond": [f"{code(method)} {percent(wrong / samples) if wrong else 'none'}" for method, (wrong, samples) in beyond.items() if samples],
        "failed": [f"{code(method)} {percent(wrong / samples) if wrong else 'none'}" for method, (wrong, samples) in failed.items()],
        "onsets": list(onsets(data))}


def stress_drawing(data):
    """How many polygons within the promised range methods are wrong about, with the radius far from contact; empty where nothing was
    asked."""
    drawn, said = "", []
    methods = [method for method in in_order(data.methods) if data.failed(method, "ample")[1]]
    for i, method in enumerate(methods):
        failed, polygons = data.failed(method, "ample")
        share, top = failed / polygons, ROW * i + 4
        shown = f"{percent_number(share)} %" if failed else "none"
        about = f", {NAMED[method]}" if method in NAMED else ""
        drawn += (chart.text(LEFT, top + 10, method + about, "start") + f'<rect x="{LEFT}" y="{top + 15}" width="{RIGHT - LEFT}" height="{BAR}" opacity=".25"/>'
                  f'<rect x="{LEFT}" y="{top + 15}" width="{share * (RIGHT - LEFT):.1f}" height="{BAR}" fill="{look_of(method).colour}" stroke="none"/>'
                  + chart.text(RIGHT + 6, top + 26, shown, "start", 'font-weight="600"'))
        said.append(f"{method} {shown}")
    return chart.part(WIDTH, ROW * len(methods) + 4, f"Polygons under stress with a wrong answer: {', '.join(said)}.", drawn) if methods else ""


MAPPED = ("close", "ample")  # nearnesses; within one double nearly all fail


def panels(names, height=2.0):
    """One panel an axis, and a free one for the legend; unused ones are hidden."""
    columns = min(6, len(names) + 1)
    lines = math.ceil((len(names) + 1) / columns)
    figure, grid = plt.subplots(lines, columns, figsize=(2.45 * columns, height * lines + 0.6), squeeze=False,
                                layout="constrained")
    flat = list(grid.flat)
    for axes in flat[len(names):]:
        axes.set_axis_off()
    return figure, flat


def short(name):
    return level({"1000": "1e3", "10000": "1e4"}.get(name, name))


def label_levels(axes, names):
    step = math.ceil(len(names) / 5)
    shown = list(range(0, len(names), step))
    if shown[-1] != len(names) - 1:
        if len(names) - 1 - shown[-1] < step:
            shown.pop()
        shown.append(len(names) - 1)
    axes.set_xticks(shown, [short(names[i]) for i in shown], fontsize=7.5)
    axes.set_xlim(-0.3, len(names) - 0.7)


def legend_in(axes, source, extra=()):
    handles, labels = source.get_legend_handles_labels()
    axes.legend([*handles, *(h for h, _ in extra)], [*labels, *(text for _, text in extra)], loc="center left",
                frameon=False, fontsize=9)


def span(name, levels):
    """An axis in words, and its mildest and worst level."""
    title, unit = AXES[name]
    return f"{title}: {unit} from {short(levels[0])} to {short(levels[-1])}".replace("\n", " ")


def draw_failures(folder, rows):
    """A map a method and nearness: a row an axis, its levels from mild to bad."""
    rows = [row for row in rows if row["test"] == "contact" and row["axis"] not in MODES and row["nearness"] in MAPPED]
    failing = [row for row in rows if float(row["rate"]) > 0]
    names, methods = (distinct(failing, key, distinct(rows, key)) for key in ("axis", "method"))
    methods, never = in_order(methods), [method for method in distinct(rows, "method") if method not in methods]
    unseen = [AXES[name][0].replace("\n", " ") for name in distinct(rows, "axis") if name not in names]
    levels = {name: distinct([row for row in rows if row["axis"] == name], "level") for name in names}
    if not names:
        return
    figure, grid = plt.subplots(len(MAPPED), len(methods), figsize=(4.4 + 1.9 * len(methods), len(MAPPED) * (0.24 * len(names) + 0.7) + 0.7),
                                sharex=True, sharey=True, squeeze=False, layout="constrained")
    shares = {(row["nearness"], row["method"], row["axis"], row["level"]): float(row["rate"]) for row in rows}
    colours = plt.get_cmap("YlOrRd").with_extremes(under="#ffffff")
    for line, nearness in zip(grid, MAPPED):
        for axes, method in zip(line, methods):
            for y, name in enumerate(names):
                edges = np.linspace(0, 1, len(levels[name]) + 1)
                values = np.array([[shares.get((nearness, method, name, level), np.nan) for level in levels[name]]])
                axes.pcolormesh(edges, [y - 0.42, y + 0.42], values, cmap=colours, vmin=1e-9, vmax=1, edgecolors="#bbbbbb", linewidth=0.3)
                for left, right, value in zip(edges, edges[1:], values[0]):
                    if value > 0:
                        axes.annotate(unless_whole(value, f"{100 * value:.0f}", 0), ((left + right) / 2, y), ha="center", va="center", fontsize=4.5,
                                      color="white" if value > 0.6 else "black")
            axes.set(ylim=(len(names) - 0.5, -0.5), xlim=(0, 1))
            axes.set_xticks([0, 1], ["first level", "last"], fontsize=7.5)
            for label, side in zip(axes.get_xticklabels(), ("left", "right")):
                label.set_ha(side)
            axes.set_yticks(range(len(names)), [span(name, levels[name]) for name in names], fontsize=7.5)
            axes.tick_params(length=0)
            axes.spines[:].set_visible(False)
        line[0].set_title(f"{NEARNESSES[nearness]}:", loc="right", x=-0.08, fontsize=8.5)
        for axes, method in zip(line, methods):
            axes.set_title(method, fontsize=8.5)
    said = "Polygons with a wrong answer, % (empty: none)." + (f" Nothing wrong at all: {', '.join(never)}." if never else "")
    figure.suptitle(said + (f"\nNo method was wrong under: {', '.join(unseen)}." if unseen else ""), x=0.01, ha="left", fontsize=9)
    save(figure, folder, "failures")


LEAST, MOST = -18.0, 17.0  # where errors of 0 and of infinity stand, as exponents of ten


def height_of(error):
    value = float(error)
    if value == 0:
        return LEAST
    return MOST if math.isinf(value) else min(max(math.log10(value), LEAST + 1), MOST - 1)


def draw_errors(folder, rows, quantity):
    rows = [row for row in rows if row["quantity"] == quantity]
    names, methods = distinct(rows, "axis"), distinct(rows, "method")
    if not names:
        return
    figure, flat = panels(names)
    for i, (axes, name) in enumerate(zip(flat, names)):
        levels = distinct([row for row in rows if row["axis"] == name], "level")
        for method in in_order(methods):
            own = [row for row in rows if row["axis"] == name and row["method"] == method]
            for key, width, label in (("relative_median", 1.4, method), ("relative_max", 0.6, None)):
                curve(axes, method, [levels.index(row["level"]) for row in own], [height_of(row[key]) for row in own], marker=bool(label),
                      linewidth=width, markersize=3, label=label)
        axes.set_title(AXES[name][0], fontsize=8.5)
        axes.set_xlabel(AXES[name][1], fontsize=8)
        axes.set_ylim(LEAST - 1, MOST + 1)
        axes.set_yticks([LEAST, -16, -8, 0, 8, MOST], ["0", "$10^{-16}$", "$10^{-8}$", "1", "$10^{8}$", "not finite"])
        if i % 6:
            axes.tick_params(labelleft=False)
        axes.grid(color="#dddddd", linewidth=0.5)
        label_levels(axes, levels)
    legend_in(flat[len(names)], flat[0], [(plt.Line2D([], [], color="k", linewidth=1.4, marker="o", markersize=3), "median"),
                                          (plt.Line2D([], [], color="k", linewidth=0.6), "largest")])
    about = {"distance": "of the distance", "point": "of the closest point, to its largest coordinate"}[quantity]
    figure.suptitle(f"Relative error {about}, against the correctly rounded exact one", x=0.01, ha="left")
    save(figure, folder, f"errors-{quantity}")


def draw_onset(folder, rows):
    distances = distinct(rows, "origin_distance")
    methods = distinct([row for row in rows if int(row["failed_triangles"])], "method", distinct(rows, "method"))
    never = [method for method in distinct(rows, "method") if method not in methods]
    figure, grid = plt.subplots(1, len(distances) + 1, figsize=(11, 3.8), layout="constrained", squeeze=False,
                                width_ratios=[1] * len(distances) + [0.35])
    for axes, distance in zip(grid[0], distances):
        for method in in_order(methods):
            own = [row for row in rows if row["origin_distance"] == distance and row["method"] == method]
            wrong = [-int(row["offset_exponent"]) for row in own if int(row["failed_triangles"])]
            own = [row for row in own if wrong and -int(row["offset_exponent"]) >= min(wrong) - 1]  # at 0 curves would cover each other
            curve(axes, method, [-int(row["offset_exponent"]) for row in own], *([100 * float(row[key]) for row in own] for key in ("rate", "lower", "upper")),
                  markersize=3)
        axes.set_title("triangles at the origin" if float(distance) == 0 else f"triangles $10^{{{round(math.log10(float(distance)))}}}$ sizes away")
        axes.set_xlabel("offset of the radius from the distance, $2^{-k}$ of it: k")
        axes.grid(color="#dddddd", linewidth=0.5)
    grid[0][0].set_ylabel("triangles with a wrong\ncontact at either offset, %")
    grid[0][-1].set_axis_off()
    legend_in(grid[0][-1], grid[0][0])
    figure.suptitle("Where wrong signs begin: a ball above a triangle's face, radius off by $2^{-k}$ to either side; bands: 95 % limits.\n"
                    "A curve begins at the last offset at which its method is never wrong." + (f" Never wrong at any offset: {', '.join(never)}." if never else ""), x=0.01, ha="left")
    save(figure, folder, "onset")


def main(folder):
    failures, errors = rows_of(folder / "failures.csv"), rows_of(folder / "errors.csv")
    draw([(draw_failures, folder, failures),
          *((draw_errors, folder, errors, quantity) for quantity in ("distance", "point")),
          (draw_onset, folder, rows_of(folder / "onset.csv"))])
