# SPDX-License-Identifier: GPL-3.0-or-later
"""Others' engines on the cases of `touchstone regress`."""
import dataclasses

from names import ENGINES
from readings.asked import Asked
from results import maybe, natural


@dataclasses.dataclass(frozen=True)
class Outcomes:
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


# Of the engines of the tables.
OWN = ("filtered", "fast", "fast-float", "thesis")


def families_of(rows):
    return list(dict.fromkeys(row["family"] for row in rows))


def rows_by_engine(rows, numbers="doubles"):
    """Of those among the engines of the tables, in their order: about questions in doubles, or those in floats."""
    return {engine: own for engine in ENGINES if (own := [row for row in rows if (row["method"], row["numbers"]) == (engine, numbers)])}


def rows_of(study):
    return study.rows("outcomes.csv", method=str, numbers=str, family=str, wrong=natural, unsure=natural, cases=natural,
                      first_offset_exponent=maybe(natural))


def cases_of(rows):
    """Of each method, in all families: in doubles, and as many in floats."""
    return sum(row["cases"] for row in rows if (row["method"], row["numbers"]) == (rows[0]["method"], "doubles"))


def polygons_of(study, rows):
    return len(families_of(rows)) * study.run["samples_done"]


def asked(study):
    """Of the questions in doubles. The balls of a family share polygons. `filtered` is what the study compares with, and `exact` is asked where another
    differs: so it was tested only if the method exact was asked too."""
    rows = [row for row in rows_of(study) if row["numbers"] == "doubles"]
    polygons = polygons_of(study, rows)
    methods = dict.fromkeys(row["method"] for row in rows)

    def asked_of(method):
        own = [row for row in rows if row["method"] == method]
        return Asked(cases_of(rows), sum(row["wrong"] for row in own), polygons, "polygons", sum(row["unsure"] for row in own))

    return {method: asked_of(method) for method in methods if method != "filtered" or "exact" in methods}
