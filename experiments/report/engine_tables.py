# SPDX-License-Identifier: GPL-3.0-or-later
"""The cells of tables of engines, in pages of Markdown and in the report."""
from names import ENGINES
from readings.regress import Outcomes, families_of, rows_by_engine
from shares import unless_whole


def power(exponent):
    return f"2^-{exponent}"


OVERALL = ["engine", "", "wrong answers", "largest relative offset of one", "families with one"]


def overall(rows, polygons):
    """The cells of a line for each engine, under the heads OVERALL. `polygons`: of all families; balls share them, so where
    no answer is wrong the limit is of polygons about which one is."""
    families, lines = families_of(rows), []
    for engine, own in rows_by_engine(rows).items():
        s = Outcomes.of(own)
        share = (unless_whole(s.wrong / s.cases, f"{100 * s.wrong / s.cases:.2g}") + " %" if s.wrong else
                 f"0 of {s.cases:,} (< {100 * (1 - 0.05 ** (1 / polygons)):.2g} % of polygons)")
        lines.append([engine, ENGINES[engine], share, s.first_offset(power), f"{s.failed_families} of {len(families)}"])
    return lines


def by_family(rows):
    """The heads, and a line for each engine: in each family wrong answers, and the largest offset of one."""
    families, lines = families_of(rows), []
    for engine, own in rows_by_engine(rows).items():
        here = {row["family"]: Outcomes.of([row]) for row in own}
        lines.append([engine, *(f"{here[family].wrong}, {here[family].first_offset(power)}" if here[family].wrong else "0"
                                for family in families)])
    return ["engine", *families], lines
