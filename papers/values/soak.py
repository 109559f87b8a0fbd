# SPDX-License-Identifier: GPL-3.0-or-later
"""filtered against exact."""
from results import natural
from values.latex import count, decimal, never, percent

STAGES = ["double", "permanent", "double-double", "fixed-integer", "unlimited"]


def values(study):
    rows = [row for row in study.rows("soak.csv", family=str, way=str, cases=natural, differences=natural, **{stage: natural for stage in STAGES})
            if row["family"] != "all"]
    cases, differences = study.run["samples_done"], sum(row["differences"] for row in rows)
    if differences:
        raise ValueError(f"{differences} answers of filtered differ from those of exact")
    decisions = sum(row[stage] for row in rows for stage in STAGES)
    whole = sum(row["cases"] for row in rows if row["way"] == "answer")
    yield "whole", count(whole)
    yield "whole-limit", decimal(never(whole))
    yield "families", str(len({row["family"] for row in rows}))
    yield "cases", count(cases)
    yield "differences", str(differences)
    yield "limit", decimal(never(cases))
    yield "unlimited-share", percent(sum(row["unlimited"] for row in rows) / decisions)


def tables(study):
    return ()
