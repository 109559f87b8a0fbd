# SPDX-License-Identifier: GPL-3.0-or-later
"""Others' engines on the cases of `touchstone regress`."""
import dataclasses
import re

from asked import Asked
from page import code, escaped, percent, power, words
from results import distinct, maybe, natural
from shares import percents, upper_limit
from studies import OUTPUT, Run, same

RUN = Run(7, "third-party engines", **same(["regress", "--output", OUTPUT]),
          tiny=["regress", "--methods", "exact,filtered,fast,thesis,cgal-epick-intersect", "--samples", "1"])
TITLE = "Other engines on the same questions"

# The engines of the tables, in their order. Method: what it is.
ENGINES = {
    "filtered": "ours, certified",
    "fast": "ours, plain doubles",
    "fast-float": "ours, plain floats",
    "cgal-epeck-distance": "CGAL's exact kernel, squared distance",
    "cgal-epeck-intersect": "CGAL's exact kernel, do_intersect",
    "cgal-epick-distance": "CGAL's inexact constructions, squared distance",
    "cgal-double-distance": "CGAL over plain doubles, squared distance",
    "cgal-epick-intersect": "CGAL's inexact constructions, do_intersect",
    "cgal-double-intersect": "CGAL over plain doubles, do_intersect",
    "fcl": "FCL, doubles",
    "libccd": "libccd's GJK, doubles",
    "bullet": "Bullet, doubles",
    "bullet-defaults": "Bullet, doubles, within its own contact threshold",
    "bullet-float": "Bullet, its default build in floats",
    "ode": "ODE, doubles, each triangle both ways round",
    "embree-fast": "Embree's culling in floats, then our doubles",
    "thesis": "the thesis of 2008",
}


@dataclasses.dataclass(frozen=True)
class Outcomes:
    """An engine in some families together."""
    wrong: int
    cases: int
    first: int | None  # exponent k of 2^-k, the largest offset of a wrong answer but 0
    failed_families: int

    @classmethod
    def of(cls, rows):
        exponents = [row["first_offset_exponent"] for row in rows if row["first_offset_exponent"] is not None]
        return cls(sum(row["wrong"] for row in rows), sum(row["cases"] for row in rows), min(exponents, default=None),
                   sum(row["wrong"] > 0 for row in rows))

    def first_offset(self, power):
        """In words; `power` shows an exponent."""
        return "none" if not self.wrong else "at offset 0 alone" if self.first is None else power(self.first)


# Of the engines of the tables.
OWN = ("filtered", "fast", "fast-float", "thesis")


def families_of(rows):
    return distinct(rows, "family")


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
    methods = distinct(rows, "method")

    def asked_of(method):
        own = [row for row in rows if row["method"] == method]
        return Asked(cases_of(rows), sum(row["wrong"] for row in own), polygons, "polygons", sum(row["unsure"] for row in own))

    return {method: asked_of(method) for method in methods if method != "filtered" or "exact" in methods}


def offset(exponent):
    return f"2^-{exponent}"


OVERALL = ["engine", "", "wrong answers", "largest relative offset of one", "families with one", "wrong answers, asked in floats",
           "largest relative offset of one"]


def overall(rows, polygons):
    """The cells of a line for each engine, under the heads OVERALL. `polygons`: of all families; balls share them, so where
    no answer is wrong the limit is of polygons about which one is."""
    families, in_floats, lines = families_of(rows), rows_by_engine(rows, "floats"), []
    for engine, own in rows_by_engine(rows).items():
        s, floats = Outcomes.of(own), Outcomes.of(in_floats[engine])
        wrong = percents(s.wrong, s.cases) if s.wrong else f"0 of {s.cases:,} (< {100 * upper_limit(polygons):.2g} % of polygons)"
        lines.append([engine, ENGINES[engine], wrong, s.first_offset(offset), f"{s.failed_families} of {len(families)}",
                      percents(floats.wrong, floats.cases) if floats.wrong else "none", floats.first_offset(offset)])
    return lines


def by_family(rows):
    """The heads, and a line for each engine: in each family wrong answers in doubles, and the largest offset of one."""
    families, lines = families_of(rows), []
    for engine, own in rows_by_engine(rows).items():
        here = {row["family"]: Outcomes.of([row]) for row in own}
        lines.append([engine, *(f"{here[family].wrong}, {here[family].first_offset(offset)}" if here[family].wrong else "0"
                                for family in families)])
    return ["engine", *families], lines


def in_page(text):
    """2^-28 as 2⁻²⁸, and 5 % on one line."""
    return re.sub(r"2\^(-\d+)", lambda match: power("2", match[1]), escaped(text)).replace(" %", "\u00a0%")


def told(study):
    rows = rows_of(study)
    lines, (families, by_family_) = overall(rows, polygons_of(study, rows)), by_family(rows)
    outcomes = {engine: Outcomes.of(own) for engine, own in rows_by_engine(rows).items()}
    wrong = sorted((s.wrong / s.cases, engine) for engine, s in outcomes.items() if engine not in OWN and s.wrong)
    return {
        "cases": cases_of(rows), "wrong": len(wrong), "never": [code(engine) for engine, s in outcomes.items() if engine not in OWN and not s.wrong],
        "span": words([f"{percent(share)} ({code(name)})" for share, name in dict.fromkeys((wrong[0], wrong[-1]))], "to") if wrong else "",
        "heads": OVERALL[:1] + ["what it is"] + OVERALL[2:],
        "engines": [[code(name), escaped(what), *map(in_page, cells)] for name, what, *cells in lines],
        "has_kernels": {"cgal-epick-distance", "cgal-double-distance"} <= set(outcomes),
        "absent": [code(engine) for engine in ENGINES if engine not in outcomes], "families": families, "of_each": rows[0]["cases"],
        "by_family": [[code(name), *(in_page(cell.replace("at offset 0 alone", "at 0")) for cell in cells)] for name, *cells in by_family_]}
