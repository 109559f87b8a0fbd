# SPDX-License-Identifier: GPL-3.0-or-later
"""Others' engines on the cases of `touchstone regress`."""
from shares import upper_limit
from studies.regress import OWN, Outcomes, polygons_of, rows_by_engine, rows_of
from values.latex import count, escaped, percent, table

PREFIX = "engines"  # of the keys of \val


def outcomes_by_engine(study, numbers="doubles"):
    return {engine: Outcomes.of(rows) for engine, rows in rows_by_engine(rows_of(study), numbers).items()}


def values(study):
    others = {engine: outcomes for engine, outcomes in outcomes_by_engine(study).items() if engine not in OWN}
    rows = rows_of(study)
    asked = {method: sum(row["cases"] for row in rows if row["method"] == method) for method in ("exact", "filtered")}
    if asked["exact"] != asked["filtered"] or any(row["wrong"] for row in rows if row["method"] in asked):
        raise ValueError("exact was not asked everything, or differs from filtered, against the text")
    polygons = polygons_of(study, rows)
    never_wrong = [engine for engine, outcomes in others.items() if not outcomes.wrong]
    yield "count", str(len(others))
    yield "cases", count(max(outcomes.cases for outcomes in others.values()))
    yield "polygons", count(polygons)
    yield "limit", percent(upper_limit(polygons))
    yield "never-wrong-count", str(len(never_wrong))
    yield "never-wrong", ", ".join(rf"\method{{{escaped(engine)}}}" for engine in never_wrong) or "none"


def tables(study):
    in_floats = outcomes_by_engine(study, "floats")

    def cells(outcomes):
        return [percent(outcomes.wrong / outcomes.cases) if outcomes.wrong else "none",
                outcomes.first_offset(lambda exponent: f"$2^{{-{exponent}}}$")]

    rows = [[rf"\method{{{engine}}}", *cells(s), *cells(in_floats[engine])] for engine, s in outcomes_by_engine(study).items()]
    yield "engines", table("lrrrr", ["engine", "wrong", "coarsest offset", "wrong, in floats", "coarsest offset"], rows)
