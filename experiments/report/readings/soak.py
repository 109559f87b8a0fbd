# SPDX-License-Identifier: GPL-3.0-or-later
"""filtered against exact on adversarial cases."""
from readings.asked import Asked
from results import natural

STAGES = ("double", "permanent", "double-double", "fixed-integer", "unlimited")


def rows_of(study):
    return study.rows("soak.csv", family=str, way=str, cases=natural, differences=natural, **dict.fromkeys(STAGES, natural))


def asked(study):
    """Ways of asking are compared with exact one by one; a case counts once."""
    rows = [row for row in rows_of(study) if row["family"] != "all"]
    answers, wrong = sum(row["cases"] for row in rows), sum(row["differences"] for row in rows)
    return {"filtered": Asked(answers, wrong, study.run["samples_done"], "cases")}
