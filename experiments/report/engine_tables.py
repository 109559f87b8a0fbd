# SPDX-License-Identifier: GPL-3.0-or-later
"""The cells of tables of engines, in pages of Markdown and in the report."""
import math

from names import ENGINES
from readings.regress import Outcomes, families_of, rows_by_engine
from shares import unless_whole


def power(exponent):
    return f"2^-{exponent}"


OVERALL = ["engine", "", "wrong answers", "largest relative offset of one", "families with one", "wrong answers, asked in floats",
           "largest relative offset of one"]


def overall(rows, polygons):
    """The cells of a line for each engine, under the heads OVERALL. `polygons`: of all families; balls share them, so where
    no answer is wrong the limit is of polygons about which one is."""
    def share(outcomes):
        return unless_whole(outcomes.wrong / outcomes.cases, f"{100 * outcomes.wrong / outcomes.cases:.2g}") + " %"

    families, in_floats, lines = families_of(rows), rows_by_engine(rows, "floats"), []
    for engine, own in rows_by_engine(rows).items():
        s, floats = Outcomes.of(own), Outcomes.of(in_floats[engine])
        wrong = share(s) if s.wrong else f"0 of {s.cases:,} (< {100 * (1 - 0.05 ** (1 / polygons)):.2g} % of polygons)"
        lines.append([engine, ENGINES[engine], wrong, s.first_offset(power), f"{s.failed_families} of {len(families)}",
                      share(floats) if floats.wrong else "none", floats.first_offset(power)])
    return lines


MOVING = ["engine", "", "wrong motions", "missed contacts", "invented contacts", "largest offset of a wrong answer", "times rounded correctly",
          "worst time, of the size"]


def moving(data):
    """The cells of a line for each engine, under the heads MOVING. `data`: readings.motions.Data."""
    def percent(part, whole):
        value = 100 * part / whole
        return unless_whole(part / whole, f"{value:.0f}" if value >= 9.5 else f"{value:.2g}") + " %"

    lines = []
    for engine in data.methods:
        row = data.all(engine)
        samples, timed = row["samples"], row["timed"]
        wrong = percent(row["failed"], samples) if row["failed"] else f"0 of {samples:,} (< {100 * (1 - 0.05 ** (1 / samples)):.2g} %)"
        offset = "none" if row["furthest"] is None else power(round(-math.log2(row["furthest"]))) if row["furthest"] else "at offset 0 alone"
        lines.append([engine, ENGINES[engine], wrong, f"{row['missed']:,}", f"{row['invented']:,}", offset,
                      percent(row["correctly_rounded"], timed) if timed else "no time", f"{row['worst_size']:.2g}" if timed else ""])
    return lines


def by_family(rows):
    """The heads, and a line for each engine: in each family wrong answers in doubles, and the largest offset of one."""
    families, lines = families_of(rows), []
    for engine, own in rows_by_engine(rows).items():
        here = {row["family"]: Outcomes.of([row]) for row in own}
        lines.append([engine, *(f"{here[family].wrong}, {here[family].first_offset(power)}" if here[family].wrong else "0"
                                for family in families)])
    return ["engine", *families], lines
