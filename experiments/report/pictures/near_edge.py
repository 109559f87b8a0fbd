# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of `touchstone near-edge`: rates and maps.

Same data, same bytes: nothing here depends on the time or on chance."""
import csv
import math

import matplotlib.colors
import numpy as np
from matplotlib.patches import Patch

from looks import in_order, look_of
from names import DISTANCES, OWN_TEST, PLACEMENTS, THRESHOLDS, TITLES
from pictures.style import draw, plt, save


def place(offset):
    """Where an offset stands on the axis: evenly up to 8 doubles, by powers of two beyond."""
    size = abs(offset)
    return math.copysign(size if size <= 8 else 8 + 0.7 * math.log2(size / 8), offset)


EVEN_STEPS = "even steps from −8 to 8 (shaded), powers of 2 beyond, so curves bend there"


def shade_even_steps(axes):
    axes.axvspan(place(-8), place(8), color="#f2f2f2", linewidth=0, zorder=-1)


class Rates:
    def __init__(self, path):
        self.curves, self.methods, self.families = {}, [], []
        with open(path, newline="") as file:
            for row in csv.DictReader(file):
                if row["method"] not in self.methods:
                    self.methods.append(row["method"])
                if row["family"] not in self.families:
                    self.families.append(row["family"])
                key = tuple(row[name] for name in ("family", "placement", "threshold", "test", "method"))
                curve = self.curves.setdefault(key, [])
                curve.append([int(row["offset"])] + [100 * float(row[name]) for name in ("rate", "lower", "upper")])

    def draw(self, axes, family, placement, threshold, test, markers=True):
        for method in in_order(self.methods):
            look = look_of(method)
            curve = self.curves.get((family, placement, threshold, test, method))
            if curve is None:
                continue
            offset, rate, lower, upper = np.array(curve).T
            x = [place(k) for k in offset]
            axes.fill_between(x, lower, upper, color=look.colour, alpha=0.15, linewidth=0)
            axes.plot(x, rate, color=look.colour, linestyle=look.line, linewidth=1.2, label=method,
                      marker=look.marker if markers else None, markersize=2.5)
        ticks = [-2**32, -2**16, -8, 0, 8, 2**16, 2**32]
        axes.set_xticks([place(k) for k in ticks], ["$-2^{32}$", "$-2^{16}$", "−8", "0", "8", "$2^{16}$", "$2^{32}$"])
        axes.set_ylim(-3, 103)
        axes.grid(color="#dddddd", linewidth=0.5)
        axes.axvline(0, color="#888888", linewidth=0.6)
        shade_even_steps(axes)

    def thresholds(self, placement):
        return [t for t in THRESHOLDS if any(key[:3] == ("all", placement, t) for key in self.curves)]

    def legend(self, figure, below):
        """Under the title, which ends `below` inches below the top: the methods of the panel with most of them, since an engine may
        lack a test."""
        handles, labels = max((axes.get_legend_handles_labels() for axes in figure.axes), key=lambda pair: len(pair[1]))
        if labels:
            figure.legend(handles, labels, loc="upper left", ncol=min(8, len(labels)), frameon=False,
                          bbox_to_anchor=(0, 1 - below / figure.get_figheight()))


def axis_label(threshold):
    moved = "a centre coordinate" if threshold.startswith("foot") else "the radius"
    return f"offset of {moved},\nin doubles"


def decided_at(threshold):
    """The test of a threshold: the final answer where the radius crosses it, else the foot's, which an ample ball hides from that."""
    return OWN_TEST[threshold] if threshold.startswith("foot") else "contact"


def draw_rates(rates, folder, placement):
    thresholds = rates.thresholds(placement)
    figure, grid = plt.subplots(1, len(thresholds), figsize=(2.6 * len(thresholds), 3.7), sharex=True, sharey=True, squeeze=False,
                                layout="constrained")
    for axes, threshold in zip(grid[0], thresholds):
        test = decided_at(threshold)
        rates.draw(axes, "all", placement, threshold, test)
        axes.set_title(f"{TITLES[threshold]}:\n{'final answer' if test == 'contact' else 'is the foot inside?'}")
        axes.set_xlabel(axis_label(threshold))
    grid[0][0].set_ylabel("wrong answers, %")
    figure.supxlabel(EVEN_STEPS, fontsize=8)
    figure.suptitle(f"Wrong answers near thresholds: {PLACEMENTS[placement]}; all families; bands: 95 % limits\n\n", x=0.01, ha="left")
    rates.legend(figure, 0.25)
    save(figure, folder, f"rates-{placement}")


def draw_families(rates, folder, placement):
    families = [family for family in rates.families if family != "all"]
    thresholds = rates.thresholds(placement)
    figure, grid = plt.subplots(len(thresholds), len(families), figsize=(1.5 * len(families) + 0.8, 1.5 * len(thresholds) + 0.9),
                                sharex=True, sharey=True, squeeze=False, layout="constrained")
    for row, threshold in enumerate(thresholds):
        for column, family in enumerate(families):
            axes = grid[row][column]
            rates.draw(axes, family, placement, threshold, OWN_TEST[threshold], markers=False)
            axes.set_xticks([place(k) for k in (-2**32, 0, 2**32)], ["$-2^{32}$", "0", "$2^{32}$"])
            if row == 0:
                axes.set_title(family)
        grid[row][0].set_ylabel(f"{TITLES[threshold]}:\n{OWN_TEST[threshold]} test, %", fontsize=7.5)
    figure.supxlabel("offset of the radius (or of a centre coordinate), in doubles: " + EVEN_STEPS, fontsize=9)
    figure.suptitle(f"Wrong answers by family: {PLACEMENTS[placement]}\n\n", x=0.01, ha="left")
    rates.legend(figure, 0.25)
    save(figure, folder, f"rates-{placement}-families")


# What a pixel can be: letter of the verdict, colour, words for the foot and for the contact. Right pixels keep the shade
# of the truth.
WRONG = {"+": ("#D55E00", "wrong: says inside", "wrong: says contact"),
         "-": ("#0072B2", "wrong: says outside", "wrong: says none"),
         "b": ("#F0E442", "wrong: inside and boundary confused", ""),
         "?": ("#CC79A7", "says nothing", "says nothing")}
TRUTH = {"i": ("#c9c9c9", "right: inside", ""), "c": ("#c9c9c9", "", "right: contact"),
         "o": ("#f7f7f7", "right: outside", ""), "n": ("#f7f7f7", "", "right: none"), "b": ("#000000", "right: boundary", "")}


def read_map(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    names, cells = rows[0][2:], np.array(rows[1:])
    size = int(cells[-1, 0]) + 1
    return {name: cells[:, 2 + i].reshape(size, -1) for i, name in enumerate(names)}


def colours(truth, verdicts):
    picture = np.zeros(truth.shape + (3,))
    for letter, (colour, _, _) in TRUTH.items():
        picture[truth == letter] = matplotlib.colors.to_rgb(colour)
    if verdicts is not None:
        for letter, (colour, _, _) in WRONG.items():
            picture[verdicts == letter] = matplotlib.colors.to_rgb(colour)
    return picture


SPOTS = {"face": ("a point inside an L", "the centre straight above it"),
         "edge": ("the middle of an edge of an L", "the centre straight above it (foot); beyond the edge, which is nearest (final answer)"),
         "vertex": ("a vertex of an L", "the centre straight above it (foot); beyond the vertex, which is nearest (final answer)"),
         "reflex-vertex": ("the reflex vertex of an L", "the centre straight above it (foot); above the notch, where both edges are\n"
                           "equally near (final answer: a reflex vertex is nearest only to what is straight above or below)")}
# Rows that all look like the truth, or, since all centres round to one float, are of one colour.
TELLS_NOTHING = ("truth", "exact", "filtered", "fast-float")
TESTS = {"foot": "foot", "contact": "final answer"}
LEAST_TOLD = 0.01  # a map far from the origin is drawn if fast is wrong in so much of it


def draw_maps(folder, spot):
    columns = [(test, distance, words) for test in TESTS for distance, words in DISTANCES.items()
               if (folder / f"map-{spot}-{test}-{distance}.csv").exists()]
    if not columns:
        return
    maps = [read_map(folder / f"map-{spot}-{test}-{distance}.csv") for test, distance, _ in columns]
    names = [name for name in maps[0] if name not in TELLS_NOTHING] or ["truth"]
    telling = [distance == 0 or "fast" not in letters or (letters["fast"] != "=").mean() >= LEAST_TOLD for (_, distance, _), letters in zip(columns, maps)]
    left_out = [column for column, tells in zip(columns, telling) if not tells]
    columns, maps = ([each for each, tells in zip(list_, telling) if tells] for list_ in (columns, maps))
    dpi, pixels_a_double = 150, 3
    size = maps[0]["truth"].shape[0]
    side = size * pixels_a_double / dpi
    gap, left, top, bottom = 0.12, 1.3, 1.2 + 0.2 * bool(left_out), 1.15
    width = left + max(len(names), 3) * (side + gap)  # the title and the legend need so much
    height = top + len(columns) * (side + gap) + bottom
    figure = plt.figure(figsize=(width, height))
    for row, ((test, _, words), letters) in enumerate(zip(columns, maps)):
        for column, name in enumerate(names):
            axes = figure.add_axes([(left + column * (side + gap)) / width,
                                    1 - (top + (row + 1) * side + row * gap) / height, side / width, side / height])
            verdicts = None if name == "truth" else letters[name]
            axes.imshow(colours(letters["truth"], verdicts), interpolation="nearest")
            axes.set_xticks([])
            axes.set_yticks([])
            for spine in axes.spines.values():
                spine.set(visible=True, color="#888888", linewidth=0.5)
            if row == 0:
                axes.set_title(name)
            if column == 0:
                axes.set_ylabel(f"{TESTS[test]},\n{words}", fontsize=9)
            if row == len(columns) - 1 and column == 0:
                axes.set_xlabel(f"{size} doubles", fontsize=8.5)
    about, middle = SPOTS[spot]
    figure.text(0.1 / width, 1 - 0.12 / height, f"About {about}: {size} x {size} doubles,\n"
                "one pixel a double of either coordinate of the centre", va="top", fontsize=11)
    aside = f"\nNot drawn: {len(left_out)} maps farther from the origin, since fast is wrong in less than {100 * LEAST_TOLD:.0f} % of each." if left_out else ""
    figure.text(0.1 / width, 1 - 0.52 / height, f"In the middle: {middle}{aside}", va="top", fontsize=9)
    for i, test in enumerate(dict.fromkeys(test for test, _, _ in columns)):
        parts = [(WRONG if name != "truth" else TRUTH, part) for (its_test, _, _), letters in zip(columns, maps)
                 for name, part in letters.items() if its_test == test and name in ("truth", *names)]
        entries = [(colour, words[list(TESTS).index(test)]) for kind in (TRUTH, WRONG)
                   for letter, (colour, *words) in kind.items()
                   if any(its_kind is kind and (part == letter).any() for its_kind, part in parts)]
        figure.legend(handles=[Patch(facecolor=colour, edgecolor="#888888", label=words) for colour, words in entries if words],
                      title=TESTS[test], loc="lower left", ncol=2, frameon=False, fontsize=8, title_fontsize=8.5,
                      alignment="left", bbox_to_anchor=(0.62 * i, 0))
    save(figure, folder, f"maps-{spot}", ("png",))


def read_table(path):
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def draw_onset(folder):
    """Where errors begin: of random samples, and the furthest that a search found."""
    rates = [row for row in read_table(folder / "onset.csv") if row["family"] == "all"]
    if not rates:
        return
    worst = read_table(folder / "worst.csv")
    methods = list(dict.fromkeys(row["method"] for row in rates))
    thresholds = [t for t in THRESHOLDS if any(row["threshold"] == t for row in rates)]
    figure, grid = plt.subplots(len(thresholds), len(DISTANCES), figsize=(10.5, 1.75 * len(thresholds) + 1.3), sharex=True,
                                sharey=True, squeeze=False, layout="constrained")
    for row, threshold in enumerate(thresholds):
        for column, (distance, words) in enumerate(DISTANCES.items()):
            axes = grid[row][column]
            for method in in_order(methods):
                look = look_of(method)
                here = {"threshold": threshold, "origin_distance": str(distance), "method": method}
                curve = [r for r in rates if here.items() <= r.items()]
                x = [-int(r["exponent"]) for r in curve]
                rate, lower, upper = ([100 * float(r[name]) for r in curve] for name in ("rate", "lower", "upper"))
                axes.fill_between(x, lower, upper, color=look.colour, alpha=0.15, linewidth=0)
                axes.plot(x, rate, color=look.colour, linestyle=look.line, linewidth=1.2, label=method)
                furthest = [float(r["climbed_share"]) for r in worst if here.items() <= r.items() and r["climbed_share"]]
                if furthest:
                    axes.plot(math.log2(max(furthest)), 0, marker=look.marker, markersize=5, color=look.colour, clip_on=False,
                              linestyle="none", zorder=5)
            axes.set_xticks([-60, -50, -40, -30, -20, -10, 0], [f"$2^{{{k}}}$" if k else "1" for k in (-60, -50, -40, -30, -20, -10, 0)])
            axes.set_ylim(-3, 103)
            axes.grid(color="#dddddd", linewidth=0.5)
            if row == 0:
                axes.set_title(words)
            if row == len(thresholds) - 1:
                axes.set_xlabel("offset to either side, share of the size")
        test = "foot test" if threshold.startswith("foot") else "final answer"
        grid[row][0].set_ylabel(f"{TITLES[threshold]}:\n{test} wrong, %", fontsize=8)
    samples = max(int(row["samples"]) for row in rates)
    figure.suptitle(f"How far from a threshold methods are wrong: {samples} random samples a panel and method, bands: 95 % limits;\n"
                    "marks: the furthest wrong answer that a search by moving coordinates found\n\n", x=0.01, ha="left")
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper right", ncol=min(4, len(labels)), frameon=False, bbox_to_anchor=(1, 1 - 0.42 / figure.get_figheight()))
    save(figure, folder, "onset")


def main(folder):
    rates = Rates(folder / "rates.csv")
    placements = [placement for placement in PLACEMENTS if rates.thresholds(placement)]
    draw([*((draw_families, rates, folder, placement) for placement in placements), (draw_onset, folder),
          *((draw_rates, rates, folder, placement) for placement in placements), *((draw_maps, folder, spot) for spot in SPOTS)])
