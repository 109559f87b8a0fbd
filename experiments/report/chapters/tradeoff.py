# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone tradeoff`: run time against error."""
from methods import asks_the_question
from names import PLACEMENTS
from noise import TOO_NOISY
from page import bar, code, count, counted, folded, multiple, percent, picture, smaller, table, words
from readings.tradeoff import Data, asked

TITLE = "What being right costs"
NAMES = {"lattice-frame": "planar", "rotated": "rotated"}


def range_of(numbers):
    low, high = min(numbers := list(numbers)), max(numbers)
    return count(low) if low == high else f"{count(low)} to {count(high)}"


def times(data, method, placement, balls):
    """Of the time of fast."""
    ratio = data.ratio(method, placement, balls)
    return "not timed" if ratio is None else TOO_NOISY if data.is_noisy(method, placement, balls) else multiple(ratio)


def finding(study):
    data = Data(study)
    never = [row["method"] for row in data.front if (row["measure"], row["placement"]) == ("not-right", data.placements[-1]) and not row["error"]
             and asks_the_question(row["method"], row["placement"])]
    return (f"Never wrong on {NAMES[data.placements[-1]]} polygons: {words(map(code, never))}." if never else
            f"Every method was wrong on {NAMES[data.placements[-1]]} polygons.")


def rates_table(data):
    rows = []
    for method in data.methods:
        cells = []
        for placement in data.placements:
            row = data.rate(method, placement) if asks_the_question(method, placement) else None
            cells.append("" if row is None else bar(row["error"], percent(row["error"])) if row["error"] else
                         f"0 <small>(&lt; {percent(row['upper'])})</small>")
        for balls in ("near", "anywhere"):
            cells += [times(data, method, placement, balls) for placement in data.placements]
        rows.append([code(method), *cells])
    heads = [f"not right, {NAMES[p]}" for p in data.placements]
    heads += [f"time {where}, {NAMES[p]}" for where in ("near contact", "anywhere") for p in data.placements]
    return folded("The rate and the time of every method", table("Final answers within 8 doubles of contact that are wrong or “don’t know” (where none was: the 95 % limit "
                 f"after Hoeffding, of {range_of(row['samples'] for row in data.front)} polygons), and the time of a "
                 "question as a multiple of fast’s. Empty: the method gives no final answer, or is asked about unlifted triangles, which is "
                 "another question.", ["method", *heads], rows, range(1, len(heads) + 1)))


def front_picture(study, data):
    path = smaller(study.folder, "front-not-right")
    rows = [row for row in data.front if row["measure"] == "not-right" and asks_the_question(row["method"], row["placement"])]
    if path is None or not rows:
        return ""
    parts = []
    for placement in data.placements:
        on = [row["method"] for row in rows if row["placement"] == placement and row["front"] == "on"]
        perhaps = [row["method"] for row in rows if row["placement"] == placement and row["front"] == "within-noise"]
        parts.append(f"{PLACEMENTS[placement]}: on the front {words(map(code, on)) if on else 'no method for certain'}"
                     + (f", {len(perhaps)} more within timing noise" if perhaps else ""))
    return picture(path, "Two scatter plots, exactly planar and rotated polygons: the share of answers that are not right against nanoseconds per "
                         f"question, a point for each of {len({row['method'] for row in rows})} methods; methods on the Pareto front are ringed.",
                   "Wrong or undecided answers within 8 doubles of contact, against the time of a question; vertical lines are 95 % limits. Lower is more "
                   "often right, further left is faster. At the foot stand methods of which no wrong answer was seen, with the number of polygons. A "
                   "method is on the front (ringed) if every method at least as accurate is slower, quartiles apart; with a broken ring, noise may keep "
                   f"it from there. Grey: the front by medians and by quartiles. {code('filtered')} uses a hierarchy where polygons have many "
                   f"edges, and {code('fast')} scans them all. Left out: methods that answer about another shape. <b>Result:</b> {'; '.join(parts)}.")


def chapter(study):
    data = Data(study)
    text = f"""<p>All {len(data.methods)} methods are asked the same questions in one run,
{counted(study.run['samples_asked'], 'polygons')} of each family and threshold for the errors, and take turns on the same
lists of distinct questions for the times. Times on a shared machine are noisy: their quartiles are
drawn, and the front names the methods that noise may keep from it.</p>"""
    return text + front_picture(study, data) + rates_table(data)
