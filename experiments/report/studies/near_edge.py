# SPDX-License-Identifier: GPL-3.0-or-later
"""Random polygons, double by double: wrong answers at thresholds, and the furthest from them."""
import csv
import math

import matplotlib.colors
import numpy as np
from matplotlib.patches import Patch

import reach
from asked import by_method
from looks import in_order, look_of
from names import DISTANCES, NAMED, OWN_TEST, PLACEMENTS, THRESHOLDS, TITLES, of_method
from page import bar, code, count, escaped, percent, percent_number, power, smaller, upper_limit
from results import distinct, finite, maybe, natural, share
from studies import NEAR_EDGE, OUTPUT, Run
from style import curve, draw, plt, rows_of, save

RUN = Run(2, "random polygons, double by double", first=True,
          full=[[*NEAR_EDGE, "--output", OUTPUT]], quick=[[*NEAR_EDGE, "--samples", "60", "--search", "8", "--output", OUTPUT]],
          tiny=["near-edge", "--methods", "filtered,fast,thesis", "--families", "u", "--samples", "4", "--search", "2", "--no-pictures"])
TITLE = "Random polygons, double by double"


CONTACT = ("face", "edge", "vertex", "tangent")  # thresholds of the radius, which the final answer crosses


def final_test(threshold):
    """Of the test that is decided at a threshold: the final answer, or where an ample ball hides the foot, the foot's."""
    return "contact" if threshold in CONTACT else OWN_TEST[threshold]


class Data:
    def __init__(self, study):
        rates = study.rows("rates.csv", family=str, placement=str, threshold=str, test=str, method=str, offset=int, failures=natural,
                           trials=natural)
        self.rates = [row for row in rates if row["family"] == "all"]
        bands = study.rows("bands.csv", family=str, placement=str, threshold=str, test=str, method=str, samples=natural,
                           failures=natural, trials=natural, rate=share)
        self.families = len({row["family"] for row in bands} - {"all"})
        self.bands = [row for row in bands if row["family"] == "all"]
        self.worst = [] if not (study.folder / "worst.csv").exists() else study.rows(
            "worst.csv", threshold=str, origin_distance=natural, method=str, samples=natural, sampled_share=maybe(finite),
            climbed_share=maybe(finite))
        self.methods = distinct(self.bands, "method")
        self.thresholds = distinct(self.bands, "threshold", THRESHOLDS)
        self.placements = distinct(self.bands, "placement", PLACEMENTS)

    def within_one_double(self, method, threshold):
        """Failures and answers of the test that is decided there."""
        rows = [row for row in self.rates if row["method"] == method and row["threshold"] == threshold and abs(row["offset"]) <= 1 and
                row["test"] == final_test(threshold)]
        return sum(row["failures"] for row in rows), sum(row["trials"] for row in rows)

    def samples(self, threshold):
        return sum(row["samples"] for row in self.bands if row["threshold"] == threshold and row["test"] == final_test(threshold) and
                   row["method"] == self.methods[0])

    def furthest(self, method, distance, names=("sampled_share", "climbed_share")):
        """Of wrong final answers, as a share of the polygon's size, of random samples and of the search; 0 where none was seen."""
        return max((row[name] or 0 for row in self.worst for name in names if row["method"] == method and
                    row["origin_distance"] == distance and row["threshold"] in CONTACT), default=0)

    @property
    def distances(self):
        return distinct(self.worst, "origin_distance", DISTANCES)


def asked(study):
    """Final answers, at all offsets. A sample has the same outline at all thresholds and in both placements."""
    data = Data(study)
    outlines = max(row["samples"] for row in data.bands)
    return by_method([dict(row, answers=row["trials"], wrong=row["failures"]) for row in data.bands if row["test"] == "contact"],
                     dict.fromkeys(data.methods, outlines), "outlines")


def at_contact(data, method):
    """Wrong final answers and all, with the radius within one double of its threshold."""
    counts = [data.within_one_double(method, t) for t in data.thresholds if t in CONTACT]
    return sum(wrong for wrong, _ in counts), sum(of for _, of in counts)


def ranges(data):
    """Of the methods that a sentence names and that were wrong: from the mildest threshold to the worst."""
    for method in data.methods:
        rates = [wrong / of for wrong, of in (data.within_one_double(method, t) for t in data.thresholds) if of]
        if method in NAMED and max(rates) > 0:
            low, high = percent(min(rates)), percent(max(rates))
            yield f"{of_method(method)} " + (high if low == high else f"{escaped(percent_number(min(rates)))} to {high}")


def rates_row(data, threshold):
    cells = []
    for method in data.methods:
        failures, trials = data.within_one_double(method, threshold)
        cells.append("not asked" if not trials else bar(failures / trials, percent(failures / trials)) if failures else
                     f"0 of {count(trials)} (polygons: &lt; {percent(upper_limit(data.samples(threshold)))})")
    return [f"{TITLES[threshold]}: {'contact?' if threshold in CONTACT else 'foot inside?'}", *cells]


def rates_picture(study, data, placement):
    fast = [row for row in data.rates if (row["placement"], row["method"], row["test"]) == (placement, "fast", "contact") and row["threshold"] in CONTACT]
    far = [abs(row["offset"]) for row in fast if row["failures"]]
    at_once = [row for row in fast if row["offset"] == 0]
    return {"path": smaller(study.folder, f"rates-{placement}"), "placement": PLACEMENTS[placement],
            "doubles": power("2", round(math.log2(max(far)))) if far and at_once else "",
            "at_once": sum(row["failures"] for row in at_once) / sum(row["trials"] for row in at_once) if at_once else None}


def map_picture(study):
    """About the reflex vertex, where methods differ most."""
    path = smaller(study.folder, "maps-reflex-vertex")
    names = sorted(p.name for p in study.folder.glob("map-reflex-vertex-*.csv"))
    if path is None or not names:
        return None
    with open(study.folder / names[0], encoding="utf-8") as file:
        head = file.readline().strip().split(",")
    methods = [m for m in ("filtered", "fast", "fast-float", "thesis", "thesis-signed") if m in head]
    pixels = [row for name in names for row in study.rows(name, **dict.fromkeys(methods, str))]
    wrong = {m: sum(row[m] != "=" for row in pixels) for m in methods}
    return {"path": path, "files": len(names), "pixels": len(pixels), "confused": any(row[m] == "b" for row in pixels for m in methods),
            "wrong": [f"{code(m)} {percent(n / len(pixels)) if n else 'none'}" for m, n in wrong.items()]}


def furthest(data):
    """Of the methods that were wrong at all: on a polygon of 1 m, at the least and at the greatest distance from the origin."""
    for method in data.methods:
        shares = [data.furthest(method, data.distances[end]) for end in (0, -1)]
        if any(shares):
            yield f"{code(method)} " + " and ".join(reach.length(share) if share else "none" for share in shares)


def told(study):
    data = Data(study)
    pictures = [rates_picture(study, data, placement) for placement in data.placements if placement == "rotated" or len(data.placements) == 1]
    of_distances = {} if not data.distances else {"near": DISTANCES[data.distances[0]], "far": DISTANCES[data.distances[-1]],
                                                  "furthest": list(furthest(data)), "reach": reach.picture(data)}
    return {"data": data, "families": data.families, "ranges": list(ranges(data)), "polygons": max(a.trials for a in asked(study).values()),
            "pictures": [each for each in pictures if each["path"]], "rates_rows": [rates_row(data, t) for t in data.thresholds],
            "map": map_picture(study), **of_distances}


def place(offset):
    """Where an offset stands on the axis: evenly up to 8 doubles, by powers of two beyond."""
    size = abs(offset)
    return math.copysign(size if size <= 8 else 8 + 0.7 * math.log2(size / 8), offset)


EVEN_STEPS = "even steps from −8 to 8 (shaded), powers of 2 beyond, so curves bend there"


def shade_even_steps(axes):
    axes.axvspan(place(-8), place(8), color="#f2f2f2", linewidth=0, zorder=-1)


class Rates:
    def __init__(self, path):
        rows = rows_of(path)
        self.curves, self.methods, self.families = {}, distinct(rows, "method"), distinct(rows, "family")
        for row in rows:
            key = tuple(row[name] for name in ("family", "placement", "threshold", "test", "method"))
            self.curves.setdefault(key, []).append([int(row["offset"])] + [100 * float(row[name]) for name in ("rate", "lower", "upper")])

    def draw(self, axes, family, placement, threshold, test, markers=True):
        for method in in_order(self.methods):
            points = self.curves.get((family, placement, threshold, test, method))
            if points is not None:
                offset, *shares = np.array(points).T
                curve(axes, method, [place(k) for k in offset], *shares, marker=markers, markersize=2.5)
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


def draw_rates(rates, folder, placement):
    thresholds = rates.thresholds(placement)
    figure, grid = plt.subplots(1, len(thresholds), figsize=(2.6 * len(thresholds), 3.7), sharex=True, sharey=True, squeeze=False,
                                layout="constrained")
    for axes, threshold in zip(grid[0], thresholds):
        test = final_test(threshold)
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


def show_map(axes, letters, name):
    """Where a method is wrong, or the truth alone."""
    axes.imshow(colours(letters["truth"], None if name == "truth" else letters[name]), interpolation="nearest")
    axes.set(xticks=[], yticks=[])
    for spine in axes.spines.values():
        spine.set(visible=True, color="#888888", linewidth=0.5)


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
            show_map(axes, letters, name)
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


def draw_onset(folder):
    """Where errors begin: of random samples, and the furthest that a search found."""
    rates, worst = (rows_of(folder / name) if (folder / name).exists() else [] for name in ("onset.csv", "worst.csv"))
    rates = [row for row in rates if row["family"] == "all"]
    if not rates:
        return
    methods = distinct(rates, "method")
    thresholds = distinct(rates, "threshold", THRESHOLDS)
    figure, grid = plt.subplots(len(thresholds), len(DISTANCES), figsize=(10.5, 1.75 * len(thresholds) + 1.3), sharex=True,
                                sharey=True, squeeze=False, layout="constrained")
    for row, threshold in enumerate(thresholds):
        for column, (distance, words) in enumerate(DISTANCES.items()):
            axes = grid[row][column]
            for method in in_order(methods):
                look = look_of(method)
                here = {"threshold": threshold, "origin_distance": str(distance), "method": method}
                own = [r for r in rates if here.items() <= r.items()]
                curve(axes, method, [-int(r["exponent"]) for r in own], *([100 * float(r[name]) for r in own] for name in ("rate", "lower", "upper")),
                      marker=False)
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
