# SPDX-License-Identifier: GPL-3.0-or-later
"""All methods at a glance: how often wrong, how far from contact, how slow."""
from chapters.tradeoff import times
from names import DISTANCES
from page import bar, code, count, percent, share_of_size, table
from readings import near_edge, meshes, tradeoff


def near_cell(row):
    return "" if row is None else bar(row["error"], percent(row["error"])) if row["error"] else f"0 of {count(row['samples'])}"


def table_of(found):
    """Of the methods that real input, or else random polygons, are asked by."""
    real = meshes.asked(found["meshes"]) if "meshes" in found else {}
    edge = near_edge.Data(found["near-edge"]) if "near-edge" in found else None
    cost = tradeoff.Data(found["tradeoff"]) if "tradeoff" in found else None
    methods = list(real) or (edge.methods if edge else cost.methods if cost else [])
    if not methods:
        return ""
    columns = []  # head, and what makes a cell
    if real:
        columns.append(("wrong on faces of real machines", lambda m: bar(real[m].wrong / real[m].answers, percent(real[m].wrong / real[m].answers))
                        if real[m].wrong else f"0 of {count(real[m].answers)}"))
    if cost and "rotated" in cost.placements:
        columns.append(("wrong on random polygons, within 8 doubles", lambda m: near_cell(cost.rate(m, "rotated"))))
    if edge and edge.distances:
        for distance in (edge.distances[0], edge.distances[-1]):
            columns.append((f"furthest wrong answer, polygon {DISTANCES[distance]}", lambda m, d=distance: "" if m not in edge.methods else
                            share_of_size(edge.furthest(m, d, near_edge.CONTACT)) if edge.furthest(m, d, near_edge.CONTACT) else "none found"))
    if cost and "rotated" in cost.placements:
        for balls, where in (("anywhere", "anywhere"), ("near", "near contact")):
            columns.append((f"time, balls {where}", lambda m, b=balls: "" if cost.ratio(m, "rotated", b) is None else times(cost.ratio(m, "rotated", b))))
    return "<section><h2>All methods at a glance</h2>" + table(
        f"Shares of wrong answers (the longer the bar, the more); furthest wrong answer as a share of the polygon's size; time "
        f"as a multiple of that of {code('fast')}. "
        'What each is: <a href="#methods">the methods</a>. Empty: not asked in that study.',
        ["method", *(head for head, _ in columns)], [[code(m), *(cell(m) for _, cell in columns)] for m in methods], range(1, len(columns) + 1)) + "</section>"
