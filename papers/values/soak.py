# SPDX-License-Identifier: GPL-3.0-or-later
"""filtered against exact."""
from shares import upper_limit
from studies.soak import STAGES, asked, rows_of
from values.latex import count, decimal, percent


def values(study):
    rows = [row for row in rows_of(study) if row["family"] != "all"]
    certified = asked(study)["filtered"]
    if certified.wrong:
        raise ValueError(f"{certified.wrong} answers of filtered differ from those of exact")
    whole = sum(row["cases"] for row in rows if row["way"] == "answer")
    yield "whole", count(whole)
    yield "whole-limit", decimal(upper_limit(whole))
    yield "families", str(len({row["family"] for row in rows}))
    yield "cases", count(certified.trials)
    yield "differences", str(certified.wrong)
    yield "limit", decimal(upper_limit(certified.trials))
    questions = sum(row[stage] for row in rows for stage in STAGES)
    yield "unlimited-share", percent(sum(row["unlimited"] for row in rows) / questions)
