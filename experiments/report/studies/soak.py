# SPDX-License-Identifier: GPL-3.0-or-later
"""filtered against exact on adversarial cases."""
from asked import Asked
from page import count, escaped, stacked
from results import distinct, natural
from studies import OUTPUT, Run

RUN = Run(9, "the certified path under attack",
          full=[["soak", "--output", OUTPUT]], quick=[["soak", "--samples", "100000", "--output", OUTPUT]],
          tiny=["soak", "--samples", "200"])
TITLE = "The certified path under attack"
IN_WORDS = {"double": "doubles", "permanent": "sharper doubles", "double-double": "double-doubles", "fixed-integer": "short integers",
            "unlimited": "unlimited integers"}
COLOURS = {"double": "#9fd8c4", "permanent": "#4cb391", "double-double": "#00795a", "fixed-integer": "#7a5195", "unlimited": "#ef5675"}
STAGES = tuple(COLOURS)


def rows_of(study):
    return study.rows("soak.csv", family=str, way=str, cases=natural, differences=natural, **dict.fromkeys(STAGES, natural))


def asked(study):
    """Ways of asking are compared with exact one by one; a case counts once."""
    rows = [row for row in rows_of(study) if row["family"] != "all"]
    answers, wrong = sum(row["cases"] for row in rows), sum(row["differences"] for row in rows)
    return {"filtered": Asked(answers, wrong, study.run["samples_done"], "cases")}


def family_row(family, rows):
    answers = sum(row["cases"] for row in rows)
    shares = [sum(row[stage] for row in rows) / answers if answers else 0 for stage in STAGES]
    return [escaped(family), count(answers), stacked(shares, COLOURS.values(), IN_WORDS.values()), str(sum(row["differences"] for row in rows))]


def told(study, opened="By family, and by the stage that decided"):
    rows = rows_of(study)
    return {"certified": asked(study)["filtered"], "whole": sum(row["cases"] for row in rows if row["family"] != "all" and row["way"] == "answer"),
            "opened": opened, "key": [(COLOURS[stage], IN_WORDS[stage]) for stage in STAGES],
            "families": [family_row(family, [row for row in rows if row["family"] == family]) for family in distinct(rows, "family")]}
