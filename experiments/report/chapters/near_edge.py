# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone near-edge`: random polygons, double by double."""
import math

from chapters import reach
from names import DISTANCES, NAMED, PLACEMENTS, TITLES, of_method
from page import (bar, code, count, counted, escaped, folded, percent, percent_number, picture, power, rounded, smaller, table,
                  upper_limit, words)
from readings.near_edge import CONTACT, Data, asked

TITLE = "Random polygons, double by double"


def at_contact(data, method):
    """Wrong final answers and all, with the radius within one double of its threshold."""
    counts = [data.within_one_double(method, t) for t in data.thresholds if t in CONTACT]
    return sum(wrong for wrong, _ in counts), sum(of for _, of in counts)


def furthest_sentence(data):
    """About the methods that were wrong at all."""
    near, far = data.distances[0], data.distances[-1]
    shares = {m: (data.furthest(m, near, CONTACT), data.furthest(m, far, CONTACT)) for m in data.methods}
    said = words(f"{code(m)} {reach.length(a) if a else 'none'} and {reach.length(b) if b else 'none'}" for m, (a, b) in shares.items() if a or b)
    if not said:
        return "a search found no wrong answer away from contact."
    return (f"the furthest wrong answers that a search found, on a polygon of 1 m, with it {DISTANCES[near]} and "
            f"{DISTANCES[far]}: {said}.")


def from_to(low, high):
    return percent(low) if percent(low) == percent(high) else f"{escaped(percent_number(low))} to {percent(high)}"


def finding(study):
    data = Data(study)
    ranges = {}
    for method in data.methods:
        rates = [wrong / of for wrong, of in (data.within_one_double(method, t) for t in data.thresholds) if of]
        if method in NAMED and max(rates) > 0:
            ranges[method] = from_to(min(rates), max(rates))
    text = f"Of {counted(data.families, 'families', 'family')} of polygons, within one double of a threshold"
    if not ranges:
        return text + ", no answer was wrong."
    return text + "; wrong answers, from the mildest threshold to the worst: " + words(f"{of_method(m)} {range_}" for m, range_ in ranges.items()) + "."


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
    return picture(path, f"Curves of the share of wrong answers of {methods} against the offset from the threshold in doubles, for "
                         f"{PLACEMENTS[placement]}; a panel for each threshold.",
                   f"{PLACEMENTS[placement].capitalize()}. In the middle of each panel is the threshold; bands are 95 % limits.{follows}")


def map_picture(study):
    """About the reflex vertex, where methods differ most."""
    spot = "reflex-vertex"
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
    return picture(path, "Maps about the reflex vertex of an L: one pixel for each double of two coordinates of the ball's centre, a column "
                         "for each method, rows for the foot and the final answer, and for distances from the origin.",
                   f"The plane about the reflex vertex of an L, one pixel a double. Without colour: right. Orange: says inside (or contact) "
                   f"where it is not; blue: says outside (or "
                   f"none){'; yellow: confuses inside and boundary' if confused else ''}. <b>What "
                   f"follows:</b> wrong of {count(pixels)} pixels in {len(names)} maps: {found}.")


def head(path):
    with open(path, encoding="utf-8") as file:
        return file.readline().strip().split(",")


def chapter(study):
    data = Data(study)
    polygons = max(asked(study).values(), key=lambda a: a.trials).trials
    text = f"""<p>{count(polygons)} random polygons of {counted(data.families, 'families', 'family')} (triangles, convex,
stars, combs, spirals, Koch curves, letters), some exactly planar on an integer lattice, some rotated so that their vertices
are rounded to doubles. For each, the exact distance from the ball's centre is computed; then the radius is set to the double
nearest to it and moved double by double, from 1 to 2³² of them, to either side (<i>face</i>, <i>edge</i>, <i>vertex</i>:
what is nearest). Likewise the centre is moved so that its foot crosses an edge or passes a vertex.</p>"""
    text += "".join(rates_picture(study, data, placement) for placement in data.placements if placement == "rotated" or len(data.placements) == 1)
    if data.distances:
        text += f"<p>How far: {furthest_sentence(data)}</p>{reach.picture(data)}"
    return text + folded("Wrong answers within one double of each threshold, and a map of them", rates_table(data) + map_picture(study))
