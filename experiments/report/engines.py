# SPDX-License-Identifier: GPL-3.0-or-later
"""Engines in the rows of standing.csv of `touchstone regress`: sums over families, and the cells of tables of them, in pages
of Markdown and in the report."""
import dataclasses

from names import ENGINES


@dataclasses.dataclass(frozen=True)
class Standing:
    """An engine in some families together."""
    wrong: int
    cases: int
    first: int | None  # exponent k of 2^-k, the largest offset of a wrong answer but 0
    failed_families: int

    @classmethod
    def of(cls, rows):
        exponents = [int(row["first_offset_exponent"]) for row in rows if row["first_offset_exponent"]]
        return cls(sum(int(row["wrong"]) for row in rows), sum(int(row["cases"]) for row in rows), min(exponents, default=None),
                   sum(int(row["wrong"]) > 0 for row in rows))

    def first_offset(self, power):
        """In words; `power` shows an exponent."""
        return "none" if not self.wrong else "at offset 0 alone" if self.first is None else power(self.first)


def power(exponent):
    return f"2^-{exponent}"


def families_of(rows):
    return list(dict.fromkeys(row["family"] for row in rows))


def rows_by_engine(rows):
    """Of those among the engines of the tables, in their order."""
    return {engine: own for engine in ENGINES if (own := [row for row in rows if row["method"] == engine])}


OVERALL = ["engine", "", "wrong answers", "largest relative offset of one", "families with one"]


def overall(rows, polygons):
    """The cells of a line for each engine, under the heads OVERALL. `polygons`: of all families; balls share them, so where
    no answer is wrong the limit is of polygons about which one is."""
    families, lines = families_of(rows), []
    for engine, own in rows_by_engine(rows).items():
        s = Standing.of(own)
        share = (f"{100 * s.wrong / s.cases:.2g} %" if s.wrong else
                 f"0 of {s.cases:,} (< {100 * (1 - 0.05 ** (1 / polygons)):.2g} % of polygons)")
        lines.append([engine, ENGINES[engine], share, s.first_offset(power), f"{s.failed_families} of {len(families)}"])
    return lines


def by_family(rows):
    """The heads, and a line for each engine: in each family wrong answers, and the largest offset of one."""
    families, lines = families_of(rows), []
    for engine, own in rows_by_engine(rows).items():
        here = {row["family"]: Standing.of([row]) for row in own}
        lines.append([engine, *(f"{here[family].wrong}, {here[family].first_offset(power)}" if here[family].wrong else "0"
                                for family in families)])
    return ["engine", *families], lines
