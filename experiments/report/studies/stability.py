# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons under stress: how many of them methods fail on, and from which level."""
import math

import numpy as np

from asked import Asked
from looks import BLUE, ORANGE, RED, in_order
from page import bar, code, count, escaped, level, percent, power, smaller, words
from results import distinct, finite, maybe, natural, number, share
from shares import unless_whole
from studies import OUTPUT, Run
from style import GREY, curve, draw, plt, rows_of, save

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
MODES = {"rounding", "flush"}  # axes whose levels are not in an order
# Signs that are computed with plain and with fused products.
SIGNS = {"orientation": "on which side of a line in the plane a point is: (b − a) × (c − a)",
         "side": "on which side of an edge the foot is: ((b − a) × (c − a)) · n",
         "line": "whether an edge's line comes within the radius: |(c − a) × (b − a)|² − r² |b − a|²",
         "plane": "whether the plane does: ((c − a) · n)² − r² n · n"}
NEARNESSES = {"one-double": "radius at the exact distance, or one double off",
              "close": "radius off by 2⁻³⁰ of the distance",
              "ample": "radius off by a quarter of the distance"}


STAND_IN = "-motion"  # axes on which filtered and exact stand for the motion of doubles, and err as that does


class Data:
    def __init__(self, study):
        rows = study.rows("failures.csv", axis=str, level=str, nearness=str, test=str, method=str, failed_samples=natural, samples=natural,
                          wrong_answers=natural, answers=natural)
        self.all_tests = rows
        self.rows = [row for row in rows if row["test"] == "contact"]
        self.first = [row for row in study.rows("first-failure.csv", axis=str, nearness=str, test=str, method=str, first_failure=str,
                                                failed_samples=natural, samples=natural) if row["test"] == "contact"]
        self.tightness = [row for row in study.rows("tightness.csv", stage=str, quantity=str, axis=str, observations=natural,
                                                    exceeded=natural, max=maybe(number)) if row["axis"] == "all"]
        self.onset = study.rows("onset.csv", origin_distance=finite, method=str, offset_exponent=int, failed_triangles=natural,
                                triangles=natural, wrong_answers=natural, answers=natural, rate=share)
        self.contraction = study.rows("contraction.csv", sign=str, family=str, trials=natural, plain_wrong=natural, plain_lower=share,
                                      plain_upper=share, fused_wrong=natural, fused_lower=share, fused_upper=share)
        self.methods = distinct(self.rows, "method")
        self.axes = distinct(self.rows, "axis", AXES)

    def failed(self, method, nearness):
        """Polygons that the method was wrong about, and all; without axes whose truth is another one."""
        own = [row for row in self.rows if row["method"] == method and row["nearness"] == nearness and row["axis"] not in MODES
               and not row["axis"].endswith(STAND_IN)]
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


def contraction_row(row):
    """What a compiler does that fuses a product and a sum into one rounding."""
    def wrong(compiled):
        share = row[f"{compiled}_wrong"] / row["trials"]
        limits = f"{percent(row[f'{compiled}_lower'])} to {percent(row[f'{compiled}_upper'])}"
        return bar(share, f"{percent(share) if share else '0'} <small>({limits})</small>")

    return [escaped(SIGNS[row["sign"]]), escaped(row["family"]), count(row["trials"]), wrong("plain"), wrong("fused")]


def told(study):
    data = Data(study)
    failed = {method: data.failed(method, "ample") for method in data.methods}
    return {
        "data": data, "ample": NEARNESSES["ample"], "failures": smaller(study.folder, "failures"), "onset": smaller(study.folder, "onset"),
        "first_failures": [said.format(shown(found)) for axis, (said, shown) in SAID.items() if (found := data.first_failure(axis, "close", "fast"))],
        "failed": [f"{code(method)} {percent(wrong / samples) if wrong else 'none'}" for method, (wrong, samples) in failed.items()],
        "onsets": list(onsets(data)), "contraction": [contraction_row(row) for row in data.contraction]}


# Where products underflow, bounds have an absolute part, which a line cannot show.
UNDERFLOWING = ("small", "mixed", "flush")
CONDITIONED = ["vertex", "along", "beyond", "line", "front", "plane", "side", "above"]
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


def draw_conditions(folder, rows, stage, words):
    rows = [row for row in rows if row["stage"] == stage and row["axis"] not in UNDERFLOWING]
    names = distinct(rows, "quantity", ["height", *CONDITIONED, "across"])
    if not names:
        return
    columns = min(4, len(names))
    least_error = 1e-40 if stage == "double-double" else 1e-20
    lines = math.ceil(len(names) / columns)
    figure, grid = plt.subplots(lines, columns, figsize=(2.75 * columns, 2.6 * lines + 0.9), squeeze=False, layout="constrained")
    for axes in list(grid.flat)[len(names):]:
        axes.set_axis_off()
    for i, (axes, name) in enumerate(zip(grid.flat, names)):
        every = [(float(row["condition"]), float(row["relative_error"])) for row in rows if row["quantity"] == name]
        points = np.array([(x, y) for x, y in every if least_error < y < 1e8 and x < (1e60 if stage == "double-double" else 1e22)])
        exact = sum(y == 0 for _, y in every)
        constant = next(float(row["constant"]) for row in rows if row["quantity"] == name)
        if len(points):
            axes.plot(*points.T, ".", color=BLUE, markersize=3, alpha=0.4, rasterized=True, zorder=2,
                      markeredgewidth=0)
            low, high = min(0.5, points[:, 0].min()), max(1e3, points[:, 0].max() * 3)
            axes.plot([low, high], [constant * low, constant * high], color=RED, linewidth=1.2, zorder=3)
            axes.axhline(1, color=GREY, linewidth=0.8, linestyle="--", zorder=1)
            axes.set(xscale="log", yscale="log", xlim=(low, high),
                     ylim=(least_error, 1e4 if stage == "double-double" else 1e9))
        axes.set_title(f"{name}  ({len(points)} points; {exact} exact)")
        axes.grid(color="#eeeeee", linewidth=0.5)
        if i >= len(names) - columns:
            axes.set_xlabel("condition number")
        if i % columns == 0:
            axes.set_ylabel("relative error")
    figure.suptitle(f"Error against condition number, {words}", x=0.01, ha="left", fontsize=10)
    figure.supxlabel("Points: single signs. Red: the bound. Dashed: an error as large as the value. Left out: points beyond the frame, and axes whose products "
                     "underflow.", fontsize=8, x=0.01, ha="left")
    save(figure, folder, f"conditions-{stage}")


CONDITIONS = {"maxima": "signs in doubles; condition: product of the largest components / |value|",
              "permanent": "signs in doubles; condition: permanent / |value|",
              "double-double": "signs in double-doubles; condition: product of the largest components / |value|",
              "frame": "in the frame of a prepared polygon; condition: size / |value|"}


IN_WORDS = {"maxima": "doubles", "permanent": "sharper doubles", "double-double": "double-doubles", "frame": "prepared polygon",
            "fast-planarity": "fast (stated, not proved)"}
QUANTITIES = {"vertex": "vertex against ball", "along": "foot before an edge", "beyond": "foot beyond an edge", "line": "edge's line against ball",
              "normal": "normal", "front": "above or below the plane", "plane": "plane against ball", "side": "foot beside an edge",
              "above": "foot above a vertex", "height": "height above the plane", "across": "foot across an edge"}


def draw_tightness(folder, rows):
    rows = [row for row in rows if int(row["observations"]) > 0]
    total = [row for row in rows if row["axis"] == "all"]
    if not total:
        return
    keys = [(row["stage"], row["quantity"]) for row in total]
    axes_names = [name for name in distinct(rows, "axis") if name != "all"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(13, 0.26 * len(keys) + 1.9), width_ratios=[1, 1.15],
                                         layout="constrained")
    y = np.arange(len(keys))
    median, most, largest = (np.array([max(float(row[key]), 1e-12) for row in total]) for key in
                             ("median", "quantile_99", "max"))
    left.hlines(y, median, largest, color=GREY, linewidth=1)
    left.plot(median, y, "o", color=BLUE, markersize=4, label="median")
    left.plot(most, y, "s", color=ORANGE, markersize=4, label="99 %")
    left.plot(largest, y, "^", color=RED, markersize=5, label="largest")
    left.axvline(1, color="k", linewidth=1)
    left.set(xscale="log", xlim=(5e-13, 3))
    left.set_yticks(y, [f"{IN_WORDS[stage]}: {QUANTITIES.get(name, name)}" for stage, name in keys])
    left.set(ylim=(len(keys) - 0.5, -0.5), xlabel="observed error / bound (the bound: 1; below $10^{-12}$ shown there)")
    left.grid(axis="x", color="#dddddd", linewidth=0.5)
    left.legend(loc="lower left", frameon=False, ncol=3, bbox_to_anchor=(0, 1))

    table = np.full((len(keys), len(axes_names)), np.nan)
    for row in rows:
        if row["axis"] != "all":
            cell = keys.index((row["stage"], row["quantity"])), axes_names.index(row["axis"])
            table[cell] = np.nanmax([table[cell], float(row["max"])])
    image = right.imshow(np.log10(np.where(table > 0, np.maximum(table, 1e-8), np.nan)), aspect="auto", cmap="viridis", vmin=-8, vmax=0)
    for place in np.argwhere(table == 0):
        right.annotate("0", place[::-1], ha="center", va="center", fontsize=6)
    right.set_xticks(range(len(axes_names)), [AXES[name][0].replace("\n", " ") for name in axes_names], rotation=60, ha="right")
    right.set_yticks(y, [])
    right.set_title("largest observed error / bound on each axis (0: no error; blank: not observed)")
    bar = figure.colorbar(image, ax=right, ticks=[-8, -6, -4, -2, 0])
    bar.set_ticklabels(["$10^{-8}$ or less", "$10^{-6}$", "$10^{-4}$", "$10^{-2}$", "1"])
    figure.suptitle("How tight the bounds on rounding errors are", x=0.01, ha="left")
    save(figure, folder, "tightness")


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
    conditions = rows_of(folder / "conditions.csv")
    draw([(draw_failures, folder, failures),
          *((draw_errors, folder, errors, quantity) for quantity in ("distance", "point")),
          *((draw_conditions, folder, conditions, stage, words) for stage, words in CONDITIONS.items()),
          (draw_tightness, folder, rows_of(folder / "tightness.csv")),
          (draw_onset, folder, rows_of(folder / "onset.csv"))])
