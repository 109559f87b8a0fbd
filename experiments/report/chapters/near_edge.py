# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone near-edge`: random polygons, double by double."""
import math

from names import DISTANCES, NAMED, PLACEMENTS, TITLES, of_method
from page import (bar, code, count, counted, escaped, percent, percent_number, picture, power, rounded, share_of_size, smaller, table,
                  upper_limit, words)
from readings.near_edge import CONTACT, Data, asked

TITLE = "Random polygons, double by double"


def ranges(data, method):
    rates = [failures / trials for failures, trials in (data.within_one_double(method, t) for t in data.thresholds) if trials]
    return min(rates), max(rates)


def from_to(low, high):
    return percent(low) if percent(low) == percent(high) else f"{escaped(percent_number(low))} to {percent(high)}"


def finding(study):
    data = Data(study)
    text = "<b>Random polygons</b>"
    named = [method for method in data.methods if method in NAMED and ranges(data, method)[1] > 0]
    text += (f" of {counted(data.families, 'families', 'family')}, within one double of a threshold; wrong answers, from the "
             "mildest threshold to the worst: "
             + words(f"{of_method(m)} {from_to(*ranges(data, m))}" for m in named) + "." if named else ": no wrong answer within one double.")
    if data.distances:
        near, far = data.distances[0], data.distances[-1]
        parts = []
        for method in named:
            here, there = (data.furthest(method, d, CONTACT) for d in (near, far))
            if there:
                parts.append(f"{code(method)} {share_of_size(here) if here else 'none'} and {share_of_size(there)}")
        if parts:
            text += (f" The furthest wrong ones from contact that a search found, in shares of the polygon’s size, with the "
                     f"polygon {DISTANCES[near]} and {DISTANCES[far]}: {words(parts)}.")
    return text


def rates_table(data):
    rows = []
    for threshold in data.thresholds:
        cells = []
        for method in data.methods:
            failures, trials = data.within_one_double(method, threshold)
            cells.append("not asked" if not trials else bar(failures / trials, percent(failures / trials)) if failures else
                         f"0 of {count(trials)} (polygons: &lt; {percent(upper_limit(data.samples(threshold)))})")
        rows.append([f"{TITLES[threshold]}: {'contact?' if threshold in CONTACT else 'foot inside?'}", *cells])
    return table("Wrong answers within one double of each threshold, exactly planar and rotated polygons together. In "
                 "brackets: the upper 95 % limit of the share of polygons.", ["threshold and question", *(code(m) for m in data.methods)], rows,
                 range(1, len(data.methods) + 1))


def furthest_table(data):
    rows = []
    for name, thresholds in (("final answer", CONTACT), ("is the foot inside?", ("foot-edge", "foot-vertex"))):
        for distance in data.distances:
            shares = [data.furthest(m, distance, thresholds) for m in data.methods]
            rows.append([f"{name}, polygon {DISTANCES[distance]}", *(share_of_size(s) if s else "none found" for s in shares)])
    return table("The furthest wrong answers, of random samples and of a search that moves coordinates to make them worse: "
                 "offset from the threshold, as a share of the polygon's size, rounded up to a power of two.",
                 ["question", *(code(m) for m in data.methods)], rows, range(1, len(data.methods) + 1))


def rates_picture(study, data, placement):
    path = smaller(study.folder, f"rates-{placement}")
    if path is None:
        return ""
    methods = words(data.methods)
    at = {m: [row for row in data.rates if row["placement"] == placement and row["method"] == m and row["threshold"] in CONTACT and
              row["test"] == "contact"] for m in data.methods}
    far = [abs(row["offset"]) for row in at.get("fast", []) if row["failures"]]
    at_once = [row for row in at.get("fast", []) if row["offset"] == 0]
    follows = (f" <b>What follows:</b> with the double nearest to the exact distance as the radius, {code('fast')} is wrong in "
               f"{percent(sum(row['failures'] for row in at_once) / sum(row['trials'] for row in at_once))}; single wrong "
               f"answers were seen as far as {power('2', round(math.log2(max(far))))} doubles of the radius from contact, for "
               "coordinates may round much more coarsely than the radius." if far and at_once else "")
    return picture(path, f"Curves of the share of wrong answers of {methods} against the offset from the threshold in doubles, "
                         "for "
                   f"{PLACEMENTS[placement]}; a panel for each threshold.",
                   f"{PLACEMENTS[placement].capitalize()}. Above, the test whose threshold is crossed, below, the final "
                   f"answer; in the middle of each panel is the threshold. Each method has a colour, a line and a marker of "
                   f"its own; bands are 95 % limits.{follows}")


MAPS = {"vertex": "a vertex of an L", "reflex-vertex": "the reflex vertex of an L"}


def map_picture(study, spot):
    path = smaller(study.folder, f"maps-{spot}")
    names = [name for name in sorted(p.name for p in study.folder.glob(f"map-{spot}-*.csv"))]
    if path is None or not names:
        return ""
    methods = [m for m in ("filtered", "fast", "fast-float", "thesis", "thesis-signed") if m in head(study.folder / names[0])]
    wrong = dict.fromkeys(methods, 0)
    pixels, confused = 0, False
    for name in names:
        rows = study.rows(name, **dict.fromkeys(methods, str))
        pixels += len(rows)
        confused |= any(row[method] == "b" for row in rows for method in methods)
        for method in methods:
            wrong[method] += sum(row[method] != "=" for row in rows)
    found = words(f"{code(m)} {percent(wrong[m] / pixels) if wrong[m] else 'none'}" for m in methods)
    return picture(path, f"Maps about {MAPS[spot]}: one pixel for each double of two coordinates of the ball's centre, a row "
                         "for the truth and "
                   "for each method, columns for the foot and the final answer at three distances from the origin.",
                   f"The plane about {MAPS[spot]}, one pixel a double. Grey and white: right. Orange: says inside (or contact) "
                   f"where it is not; blue: says outside (or "
                   f"none){'; yellow: confuses inside and boundary' if confused else ''}. <b>What "
                   f"follows:</b> wrong of {count(pixels)} pixels in {len(names)} maps: {found}.")


def head(path):
    with open(path, encoding="utf-8") as file:
        return file.readline().strip().split(",")


def onset_picture(study, data):
    path = smaller(study.folder, "onset")
    if path is None or not data.worst:
        return ""
    far = data.distances[-1]
    at = {m: (data.furthest(m, 0, CONTACT), data.furthest(m, far, CONTACT)) for m in data.methods}
    said = words(f"{code(m)} {share_of_size(a) if a else 'none'} and {share_of_size(b)}" for m, (a, b) in at.items() if b)
    return picture(path, "Curves of the share of wrong answers against the offset from the threshold as a share of the "
                         "polygon's size, a row for "
                   "each threshold, a column for each distance from the origin.",
                   f"Where errors begin: offsets as shares of the polygon's size, for polygons ever further from the origin. "
                   f"Marks on the axis: the furthest wrong answer that a search found. <b>What follows:</b> with the polygon "
                   f"at the origin and {DISTANCES[far]}, the furthest wrong final answers were at: {said}.")


def chapter(study):
    data = Data(study)
    polygons = max(asked(study).values(), key=lambda a: a.trials).trials
    text = f"""<p>{count(polygons)} random polygons of {counted(data.families, 'families', 'family')} (triangles, convex,
stars, combs, spirals, Koch curves, letters), some exactly planar on an integer lattice, some rotated so that their vertices
are rounded to doubles. For each, the exact distance from the ball's centre is computed; then the radius is set to the double
nearest to it and moved double by double, from 1 to 2³² of them, to either side (<i>face</i>, <i>edge</i>, <i>vertex</i>:
what is nearest). Likewise the centre is moved so that its foot crosses an edge or passes a vertex.</p>"""
    text += rates_table(data)
    text += "".join(rates_picture(study, data, placement) for placement in reversed(data.placements))
    text += "".join(map_picture(study, spot) for spot in MAPS)
    if data.worst:
        text += furthest_table(data) + onset_picture(study, data)
    return text
