# SPDX-License-Identifier: GPL-3.0-or-later
"""Random polygons near their thresholds: wrong answers by clearance, and the furthest from contact."""
import csv
import math

import matplotlib.colors
import numpy as np
from matplotlib.patches import Patch

import reach
from asked import by_method
from looks import in_order, look_of
from names import DISTANCES, NAMED, OWN_TEST, PLACEMENTS, THRESHOLDS, TITLES, of_method
from page import bar, code, count, escaped, level, percent, percent_number, power, smaller
from results import distinct, finite, maybe, natural, share
from studies import NEAR_EDGE, OUTPUT, Run
from style import curve, draw, plt, rows_of, save

RUN = Run(2, "random polygons near their thresholds", first=True,
          full=[[*NEAR_EDGE, "--output", OUTPUT]], quick=[[*NEAR_EDGE, "--samples", "60", "--search", "8", "--output", OUTPUT]],
          tiny=["near-edge", "--methods", "filtered,fast,thesis", "--families", "u", "--samples", "4", "--search", "2", "--no-pictures"])
TITLE = "Random polygons near their thresholds"


CONTACT = ("face", "edge", "vertex", "tangent")  # thresholds of the radius, which the final answer crosses
NEAR = 1  # u x size
# What polygons there are: families and placement, first those about which the contract and every method ask the same question.
KINDS = {"planar": "exactly planar", "triangles": "rotated triangles", "loops": "rotated loops"}
LAW = (-8, -4, -2, -1, 0, 1, 2, 3)  # exponents of offsets


def final_test(threshold):
    """Of the test that is decided at a threshold: the final answer, or where an ample ball hides the foot, the foot's."""
    return "contact" if threshold in CONTACT else OWN_TEST[threshold]


class Data:
    def __init__(self, study):
        self.rates = study.rows("rates.csv", family=str, placement=str, threshold=str, test=str, method=str, offset=finite, failures=natural,
                                trials=natural, lift=natural)
        self.properties = study.rows("properties.csv", **{"property": str, "from": finite, "to": finite}, threshold=str, method=str, offset=finite,
                                     failures=natural, trials=natural)
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

    def answers(self, method, threshold, kind):
        """The rows of the test that is decided there, each with its sign: rotated loops are all rotated polygons but triangles."""
        family = "triangle" if kind == "triangles" else "all"
        placement = "rotated" if kind != "planar" else "lattice-frame" if threshold == "tangent" else "planar"
        return [(row, -1 if row["family"] == "triangle" and kind == "loops" else 1) for row in self.rates
                if (row["method"], row["threshold"], row["placement"], row["test"]) == (method, threshold, placement, final_test(threshold))
                and (row["family"] == family or kind == "loops" and row["family"] == "triangle")]

    def near(self, method, threshold, kind="planar", is_near=lambda offset: offset <= NEAR):
        """Failures, answers, and answers that only the contract's lift makes wrong, at such offsets."""
        rows = [(row, sign) for row, sign in self.answers(method, threshold, kind) if is_near(abs(row["offset"]))]
        return tuple(sum(sign * row[name] for row, sign in rows) for name in ("failures", "trials", "lift"))

    def last(self, method, threshold, kind="planar"):
        """The largest offset with a failure, to either side; None if there is none."""
        seen = [abs(row["offset"]) for row, sign in self.answers(method, threshold, kind) if row["failures"] and sign > 0]
        return max(seen, default=None)

    def by_range(self, name, method, threshold, is_near):
        """By the ranges of a property: its ends, failures and answers."""
        sums = {}
        for row in self.properties:
            if (row["property"], row["method"], row["threshold"]) == (name, method, threshold) and is_near(abs(row["offset"])):
                sum_ = sums.setdefault((row["from"], row["to"]), [0, 0])
                sum_[0] += row["failures"]
                sum_[1] += row["trials"]
        return sums

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
    """Final answers, at all offsets."""
    data = Data(study)
    own = [row for row in data.bands if row["test"] == "contact"]
    return by_method([dict(row, answers=row["trials"], wrong=row["failures"]) for row in own],
                     {method: sum(row["samples"] for row in own if row["method"] == method) for method in data.methods}, "polygons")


def at_contact(data, method):
    """Wrong final answers and all about exactly planar polygons, with the radius within u x size of its threshold."""
    counts = [data.near(method, t) for t in data.thresholds if t in CONTACT]
    return sum(wrong for wrong, _, _ in counts), sum(of for _, of, _ in counts)


def ranges(data):
    """Of the methods that a sentence names and that were wrong: from the mildest threshold to the worst."""
    for method in data.methods:
        rates = [wrong / of for wrong, of, _ in (data.near(method, t) for t in data.thresholds) if of]
        if method in NAMED and max(rates) > 0:
            low, high = percent(min(rates)), percent(max(rates))
            yield f"{of_method(method)} " + (high if low == high else f"{escaped(percent_number(min(rates)))} to {high}")


def rates_row(data, threshold, kind):
    cells = []
    for method in data.methods:
        failures, trials, lift = data.near(method, threshold, kind)
        cells.append("not asked" if not trials else (bar(failures / trials, percent(failures / trials)) if failures else f"0 of {count(trials)}")
                     + (f"<br><small>lift {percent(lift / trials)}</small>" if lift else ""))
    return [f"{TITLES[threshold]}: {'contact?' if threshold in CONTACT else 'foot inside?'}", KINDS[kind], *cells]


def rates_rows(data):
    return [rates_row(data, threshold, kind) for threshold in data.thresholds for kind in KINDS
            if any(data.near(method, threshold, kind)[1] for method in data.methods)]


def law(data, method):
    """Shares of wrong final answers by the exponent of the clearance in u x size, of exactly planar polygons; None: not asked."""
    def share(threshold, exponent):
        failures, trials, _ = data.near(method, threshold, is_near=lambda offset: offset == 2.0**exponent)
        return failures / trials if trials else None
    return {threshold: [share(threshold, exponent) for exponent in LAW] for threshold in ("face", "edge", "vertex")}


# Of a property: what it is called, and at which threshold and how near it shows.
PROPERTIES = {"thinness": ("the size squared over the area", "face", 2), "tilt": ("the largest component of the normal", "face", 0.5),
              "edge-length": ("the edge’s length over the size", "edge", 0.125), "radius": ("the radius over the size", "face", 0.5)}


def dependence(data, method, name):
    """Of a property: the ends of its ranges, and the share of wrong final answers at one clearance."""
    _, threshold, offset = PROPERTIES[name]
    return [(low, high, failures, trials) for (low, high), (failures, trials)
            in data.by_range(name, method, threshold, lambda clearance: clearance == offset).items()]


THRESHOLD_WORDS = {"face": "a face", "edge": "an edge"}


def range_cells(data, method, name):
    """The ranges and their shares, as many cells as any property has."""
    end = lambda number: level(f"{number:.2g}".replace("e-0", "e-"))
    cells = [f"{f'{end(low)} to ' if low else ''}{end(high)}{'' if low else ' or less'}: {percent(failures / trials) if failures else 'none'}"
             for low, high, failures, trials in dependence(data, method, name)]
    return cells + [""] * (5 - len(cells))


def rates_picture(study, data, placement):
    last = [each for t in CONTACT if (each := data.last("fast", t))] if placement == "planar" else []
    return {"path": smaller(study.folder, f"rates-{placement}"), "placement": PLACEMENTS[placement],
            "last": power("2", round(math.log2(max(last)))) if last else ""}


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
    pictures = [rates_picture(study, data, placement) for placement in data.placements if placement != "lattice-frame"]
    plain = "fast" if "fast" in data.methods else None
    of_distances = {} if not data.distances else {"near": DISTANCES[data.distances[0]], "far": DISTANCES[data.distances[-1]],
                                                  "furthest": list(furthest(data)), "reach": reach.picture(data)}
    return {"data": data, "families": data.families, "ranges": list(ranges(data)), "polygons": max(a.trials for a in asked(study).values()),
            "pictures": [each for each in pictures if each["path"]], "rates_rows": rates_rows(data),
            "vertex_is_right": plain is not None and not data.near(plain, "vertex", is_near=bool)[0],
            "law_heads": [power("2", k) if k else "1" for k in LAW],
            "law": [] if plain is None else [[TITLES[t], *("not asked" if s is None else percent(s) if s else "none" for s in shares)] for t, shares in law(data, plain).items()],
            "properties": [] if plain is None else [[escaped(words_), THRESHOLD_WORDS[t], f"{o:g}", *range_cells(data, plain, name)] for name, (words_, t, o) in PROPERTIES.items()],
            "map": map_picture(study), **of_distances}


def place(offset):
    """Where an offset stands on the axis: powers of two evenly, to either side of 0."""
    return math.copysign(math.log2(abs(offset)) + 10, offset) if offset else 0


TICKS = {-2**32: "$-2^{32}$", -2**16: "$-2^{16}$", -1: "−1", 0: "0", 1: "1", 2**16: "$2^{16}$", 2**32: "$2^{32}$"}
UNIT = "u x size"
LEAST_TRIALS = 10  # of a point that is drawn
SCALE = f"powers of two of {UNIT} to either side of the threshold; u is $2^{{-53}}$, at 0 the radius is the double nearest to the distance"


class Rates:
    def __init__(self, path):
        rows = rows_of(path)
        self.curves, self.methods, self.families = {}, distinct(rows, "method"), distinct(rows, "family")
        for row in rows:
            if int(row["trials"]) < LEAST_TRIALS:
                continue
            key = tuple(row[name] for name in ("family", "placement", "threshold", "test", "method"))
            self.curves.setdefault(key, []).append([float(row["offset"])] + [100 * float(row[name]) for name in ("rate", "lower", "upper")])

    def draw(self, axes, family, placement, threshold, test, markers=True):
        for method in in_order(self.methods):
            points = self.curves.get((family, placement, threshold, test, method))
            if points is not None:
                offset, *shares = np.array(points).T
                curve(axes, method, [place(k) for k in offset], *shares, marker=markers, markersize=2.5)
        axes.set_xticks([place(k) for k in TICKS], TICKS.values(), fontsize=7)
        axes.set_ylim(-3, 103)
        axes.grid(color="#dddddd", linewidth=0.5)
        axes.axvline(0, color="#888888", linewidth=0.6)

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
    return f"offset of {moved},\nin {UNIT}"


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
    figure.supxlabel(SCALE, fontsize=8)
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
    figure.supxlabel(f"offset of the radius (or of a centre coordinate): {SCALE}", fontsize=9)
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
