# SPDX-License-Identifier: GPL-3.0-or-later
"""Others' engines on the cases of `touchstone regress`."""
from names import ENGINES
from readings.regress import Standing, polygons_of, rows_by_engine, rows_of
from values.latex import count, escaped, never, percent, table

OWN = ("filtered", "fast", "thesis")


def standings(study):
    return {engine: Standing.of(rows) for engine, rows in rows_by_engine(rows_of(study)).items()}


def values(study):
    others = {engine: standing for engine, standing in standings(study).items() if engine not in OWN}
    rows = rows_of(study)
    if any(row["wrong"] for row in rows if row["method"] in ("exact", "filtered")):
        raise ValueError("exact, filtered and the truth of regress differ")
    polygons = polygons_of(study, rows)
    never_wrong = [engine for engine, standing in others.items() if not standing.wrong]
    yield "count", str(len(others))
    yield "cases", count(max(standing.cases for standing in others.values()))
    yield "polygons", count(polygons)
    yield "limit", percent(never(polygons))
    yield "never-wrong-count", str(len(never_wrong))
    yield "never-wrong", ", ".join(rf"\method{{{escaped(engine)}}}" for engine in never_wrong) or "none"


def tables(study):
    rows = [[rf"\method{{{engine}}}", escaped(ENGINES[engine]), percent(s.wrong / s.cases) if s.wrong else "none",
             s.first_offset(lambda exponent: f"$2^{{-{exponent}}}$")] for engine, s in standings(study).items()]
    yield "engines", table("llrr", ["engine", "", "wrong", "coarsest offset"], rows)
