# SPDX-License-Identifier: GPL-3.0-or-later
"""filtered against exact."""
from results import natural
from values.latex import count, decimal, never, percent

STAGES = ["double", "permanent", "double-double", "fixed-integer", "unlimited"]


def values(study):
    rows = study.rows("soak.csv", family=str, cases=natural, differences=natural, **{stage: natural for stage in STAGES})
    cases, differences = (sum(row[name] for row in rows) for name in ("cases", "differences"))
    if differences:
        raise ValueError(f"{differences} answers of filtered differ from those of exact")
    decisions = sum(row[stage] for row in rows for stage in STAGES)
    yield "families", str(len({row["family"] for row in rows}))
    yield "cases", count(cases)
    yield "differences", str(differences)
    yield "limit", decimal(never(cases))
    yield "unlimited-share", percent(sum(row["unlimited"] for row in rows) / decisions)


def tables(study):
    return ()
