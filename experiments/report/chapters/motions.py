# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone motions`: contact on the way, as methods and engines see it."""
from names import EVENTS, WAYS
from page import bar, code, count, folded, number, percent, picture, share_of_size, smaller, table, upper_limit, words
from readings.motions import Data, asked

TITLE = "Moving balls: contact on the way"
NO_SWEEP = ["ode", "embree-fast", "boost-geometry"]


def failed(row):
    """A share of motions, with its limit where none failed."""
    if not row["failed"]:
        return f"0 of {count(row['samples'])} (&lt; {percent(upper_limit(row['samples']))})"
    return bar(row["failed"] / row["samples"], percent(row["failed"] / row["samples"]))


def offset(share):
    return "none" if share is None else "at 0" if share == 0 else share_of_size(share)


def finding(study):
    data = Data(study)
    never = [code(m) for m in data.methods if not data.all(m)["failed"]]
    wrong = [f"{code(m)} {percent(data.all(m)['failed'] / data.all(m)['samples'])}"
             for m in data.methods if data.all(m)["failed"]]
    text = f"{count(max(data.all(m)['samples'] for m in data.methods))} motions across a threshold of the radius; motions with a wrong answer"
    return text + (f": {words(wrong)}" if wrong else ": none") + (f"; of {words(never)} none." if never and wrong else ".")


def engines_table(data):
    rows = []
    for method in data.methods:
        row = data.all(method)
        timed = row["timed"]
        rows.append([code(method), failed(row), count(row["missed"]), count(row["invented"]),
                     offset(row["furthest"]),
                     percent(row["correctly_rounded"] / timed) if timed else "no time",
                     number(row["worst_ulps"], 2) if timed else "", number(row["worst_size"], 2) if timed else ""])
    return table("Does the ball touch on its way, and when? Motions about which a method is wrong for any radius near the threshold; "
                 "contacts that it misses and invents, of all answers; the largest offset of a wrong one, as a share of the polygon's size. "
                 "Then the times of contacts that it found: how many are the double nearest to the exact time, and the largest "
                 "errors, in units in the last place and as the way in shares of the polygon's size.",
                 ["method", "wrong motions", "missed", "invented", "furthest", "times rounded correctly", "worst, units",
                  "worst, of the size"], rows, range(1, 8))


def ways_table(data):
    rows = [[code(m), *(percent(data.at[way, m]["failed"] / data.at[way, m]["samples"]) if data.at[way, m]["failed"] else "0" for way in data.ways)]
            for m in data.methods]
    return table("Wrong motions by how the ball moves.", ["method", *(WAYS[way] for way in data.ways)], rows, range(1, len(data.ways) + 1))


def thresholds_table(data):
    events = [event for event in EVENTS if any((row["event"], row["feature"]) == event for row in data.thresholds)]
    rows = [[code(m), *(offset(data.furthest(m, *event)) for event in events)] for m in data.methods]
    return table("How near to a threshold a motion must be for a method to be wrong: the largest offset of a wrong answer, as a "
                 "share of the polygon's size, by what a ball of the threshold radius does. Offsets are 0 and 2⁻⁵² to 2⁻⁴, by factors of 16.",
                 ["method", *(EVENTS[event] for event in events)], rows, range(1, len(events) + 1))


def pass_picture(study):
    path = smaller(study.folder, "grazing-pass")
    return "" if path is None else picture(
        path, "A ball passes an edge of a polygon and grazes it; below, a row for each method with its answers as the radius grows across "
              "the threshold, and the errors of its times.",
        "A grazing pass, seen along the edge of the polygon, and what each method says of it as the radius shrinks and grows across its "
        "threshold by shares of the polygon's size. Without colour: right. Blue: a contact that the method misses; orange: one that it "
        "invents. To the right, the errors of the times that it gives for contacts, as way in shares of the size.")


def chapter(study):
    data = Data(study)
    text = f"""<p>A ball moves along a segment past a polygon. For each motion the least double is found with which the ball touches
at all: with it, the ball grazes on its way, or touches just at its start or end. Methods are asked about that radius, and radii off by shares of
the polygon's size, to either side. {code("exact")} says what is right. Third-party engines get triangles: Bullet answers by its convex sweep (after its
static test of the start), FCL at 100 places of the way, by its default solver; libccd and CGAL decide whether the capsule touches, and have no time.
CGAL’s exact kernel is asked where the polygon’s vertices lie in one plane: of other polygons the contract asks about lifted vertices, which the kernel does
not get.</p>"""
    text += folded("By method, way and threshold; a grazing pass, drawn",
                   engines_table(data) + ways_table(data) + thresholds_table(data) + pass_picture(study))
    absent = [name for name in NO_SWEEP if name not in data.methods]
    return text + (f"<p>{words(code(name) for name in absent)} cannot be asked: they have no test of a moving ball. Tight-Inclusion is not in "
                   "this comparison, because Debian has no package of it; it asks about vertices and edges without a radius.</p>" if absent else "")
