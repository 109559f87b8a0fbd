# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone tradeoff`: run time against error."""
from names import PLACEMENTS
from page import bar, code, count, counted, multiple, percent, picture, smaller, table, words
from readings.tradeoff import Data, asked

TITLE = "What being right costs"
NAMES = {"lattice-frame": "planar", "rotated": "rotated"}


def range_of(numbers):
    low, high = min(numbers := list(numbers)), max(numbers)
    return count(low) if low == high else f"{count(low)} to {count(high)}"


def times(ratio):
    return "not timed" if ratio is None else multiple(ratio)


def finding(study):
    data = Data(study)
    parts = []
    for method in ("filtered", "exact"):
        if method in data.methods and all(data.ratio(method, p, b) for p in data.placements for b in ("near", "anywhere")):
            parts.append(f"{code(method)} took " + words(
                f"{words((times(data.ratio(method, p, balls)) for p in data.placements), 'to')} {where}"
                for balls, where in (("anywhere", "with balls anywhere"), ("near", "with balls within 8 doubles of contact"))))
    if not parts:
        return "<b>What being right costs</b> was not measured: neither filtered nor exact was timed beside fast."
    return f"<b>What being right costs.</b> Of the time of {code('fast')} on the same questions (planar to rotated polygons): " + "; ".join(parts) + "."


def rates_table(data):
    rows = []
    for method in data.methods:
        cells = []
        for placement in data.placements:
            row = data.rate(method, placement)
            cells.append("no final answer" if row is None else bar(row["error"], percent(row["error"])) if row["error"] else
                         f"0 <small>(&lt; {percent(row['upper'])})</small>")
        for balls in ("near", "anywhere"):
            cells += [times(data.ratio(method, placement, balls)) for placement in data.placements]
        rows.append([code(method), *cells])
    heads = [f"not right, {NAMES[p]}" for p in data.placements]
    heads += [f"time {where}, {NAMES[p]}" for where in ("near contact", "anywhere") for p in data.placements]
    return table("Final answers within 8 doubles of contact that are wrong or “don’t know” (where none was: the 95 % limit "
                 f"after Hoeffding, of some {range_of(row['samples'] for row in data.front)} polygons), and the time of a "
                 "question as a multiple of fast’s.", ["method", *heads], rows, range(1, len(heads) + 1))


MEASURES = {
    "not-right": ("Wrong or undecided answers within 8 doubles of contact, against the time of a question",
                  "share of answers that are not right"),
    "distance": ("Error of the distance, against the time of a whole answer", "error of the distance, in units of its last "
                                                                              "place"),
}


def front_picture(study, data, measure):
    path = smaller(study.folder, f"front-{measure}")
    rows = [row for row in data.front if row["measure"] == measure]
    if path is None or not rows:
        return ""
    parts = []
    for placement in data.placements:
        on = [row["method"] for row in rows if row["placement"] == placement and row["front"] == "on"]
        perhaps = [row["method"] for row in rows if row["placement"] == placement and row["front"] == "within-noise"]
        parts.append(f"{PLACEMENTS[placement]}: on the front {words(map(code, on)) if on else 'no method for certain'}"
                     + (f", {len(perhaps)} more within timing noise" if perhaps else ""))
    about, axis = MEASURES[measure]
    return picture(path, f"Two scatter plots, exactly planar and rotated polygons: {axis} against nanoseconds per question, a "
                         "point for each of "
                   f"{len({row['method'] for row in rows})} methods; methods on the Pareto front are ringed.",
                   f"{about}; a colour for each kind of method, a marker for each method of a kind. Lower is more often right, "
                   f"further left is faster; a method is on the front if every method at least as accurate is slower. <b>"
                   f"Result:</b> {'; '.join(parts)}.")


def chapter(study):
    data = Data(study)
    text = f"""<p>All {len(data.methods)} methods are asked the same questions in one run,
{counted(study.run['samples_asked'], 'polygons')} of each family and threshold for the errors, and take turns on the same
lists of distinct questions for the times. Times on a shared machine are noisy: their quartiles are
drawn, and the front names the methods that noise may keep from it.</p>"""
    return text + front_picture(study, data, "not-right") + rates_table(data) + front_picture(study, data, "distance")
