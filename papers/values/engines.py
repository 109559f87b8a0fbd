# SPDX-License-Identifier: GPL-3.0-or-later
"""Others' engines on the cases of `touchstone regress`."""
from engines import families_of, rows_by_engine
from names import ENGINES
from results import maybe, natural
from values.latex import count, escaped, never, percent, table

OWN = ("filtered", "fast", "thesis")


def rows_of(study):
    return study.rows("standing.csv", method=str, family=str, wrong=natural, cases=natural,
                      first_offset_exponent=maybe(natural))


def of_engines(study):
    """(engine, wrong, cases, exponent of the coarsest wrong offset or None, families with a wrong answer)."""
    for engine, rows in rows_by_engine(rows_of(study)).items():
        exponents = [row["first_offset_exponent"] for row in rows if row["first_offset_exponent"] is not None]
        yield (engine, sum(row["wrong"] for row in rows), sum(row["cases"] for row in rows), min(exponents, default=None),
               sum(row["wrong"] > 0 for row in rows))


def values(study):
    entries = list(of_engines(study))
    others = [entry for entry in entries if entry[0] not in OWN]
    rows = rows_of(study)
    polygons = len(families_of(rows)) * study.run["samples_done"]
    if any(row["wrong"] for row in rows if row["method"] in ("exact", "filtered")):
        raise ValueError("exact, filtered and the truth of regress differ")
    never_wrong = [engine for engine, wrong, *_ in others if wrong == 0]
    yield "count", str(len(others))
    yield "cases", count(entries[0][2])
    yield "polygons", count(polygons)
    yield "limit", percent(never(polygons))
    yield "never-wrong-count", str(len(never_wrong))
    yield "never-wrong", ", ".join(rf"\method{{{escaped(engine)}}}" for engine in never_wrong) or "none"


def tables(study):
    rows = []
    for engine, wrong, cases, exponent, failed in of_engines(study):
        first = f"$2^{{-{exponent}}}$" if exponent is not None else "at tangency alone" if wrong else "none"
        share = percent(wrong / cases) if wrong else "none"
        rows.append([rf"\method{{{engine}}}", escaped(ENGINES[engine]), share, first])
    yield "engines", table("llrr", ["engine", "", "wrong", "coarsest offset"], rows)
