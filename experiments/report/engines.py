# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of engines, from the rows of standing.csv of `touchstone regress`: in pages of Markdown and in the report."""
from names import ENGINES


def share_and_first(rows, polygons):
    """Of these rows together: wrong answers in per cent, and the largest offset at which one was found. Balls share polygons,
    so where none is wrong the limit is of polygons about which an answer is."""
    wrong, cases = sum(int(row["wrong"]) for row in rows), sum(int(row["cases"]) for row in rows)
    first = min((int(row["first_offset_exponent"]) for row in rows if row["first_offset_exponent"]), default=None)
    if wrong == 0:
        return f"0 of {cases:,} (< {100 * (1 - 0.05 ** (1 / polygons)):.2g} % of polygons)", "none"
    return f"{100 * wrong / cases:.2g} %", "at tangency alone" if first is None else f"2^-{first}"


def families_of(rows):
    return list(dict.fromkeys(row["family"] for row in rows))


def rows_by_engine(rows):
    """Of those among the engines of the tables, in their order."""
    return {engine: own for engine in ENGINES if (own := [row for row in rows if row["method"] == engine])}


OVERALL = ["engine", "", "wrong answers", "largest relative offset of one", "families with one"]


def overall(rows, polygons):
    """The cells of a line for each engine, under the heads OVERALL. `polygons`: of all families."""
    families = families_of(rows)
    return [[engine, ENGINES[engine], *share_and_first(own, polygons),
             f"{sum(int(row['wrong']) > 0 for row in own)} of {len(families)}"]
            for engine, own in rows_by_engine(rows).items()]


def by_family(rows):
    """The heads, and a line for each engine: in each family wrong answers, and the largest offset of one."""
    families, lines = families_of(rows), []
    for engine, own in rows_by_engine(rows).items():
        here = {row["family"]: row for row in own}
        lines.append([engine, *("0" if here[family]["wrong"] == "0" else
                                f"{here[family]['wrong']}, {share_and_first([here[family]], 1)[1]}" for family in families)])
    return ["engine", *families], lines
