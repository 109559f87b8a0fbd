# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone soak`: filtered against exact on adversarial cases."""
from page import bar, code, count, escaped, percent, table, upper_limit
from readings.soak import asked, rows_of

TITLE = "The certified path under attack"
STAGES = {"double": "doubles", "permanent": "sharper doubles", "double-double": "double-doubles", "fixed-integer": "short integers",
          "unlimited": "unlimited integers"}


def finding(study):
    a = asked(study)["filtered"]
    if a.wrong:
        return f'<b class="no">{count(a.wrong)} answers of {count(a.answers)} differed from the exact ones: see differences.jsonl.</b>'
    whole = sum(row["cases"] for row in rows_of(study) if row["family"] != "all" and row["way"] == "answer")
    rest = f", in the whole answer, which {count(whole)} of them were asked for, at most {percent(upper_limit(whole))}" if whole else ""
    return (f"<b>Adversarial cases.</b> Not one answer of {count(a.answers)} differed from the exact one, in {count(a.trials)} "
            f"cases: in contact at most {percent(upper_limit(a.trials))} of such cases do{rest} (95 %).")


def stages_table(study):
    rows = rows_of(study)
    families = list(dict.fromkeys(row["family"] for row in rows))
    body = []
    for family in families:
        own = [row for row in rows if row["family"] == family]
        asked_here = sum(row["cases"] for row in own)
        body.append([escaped(family), count(asked_here), *(bar(sum(row[stage] for row in own) / asked_here,
                                                               percent(sum(row[stage] for row in own) / asked_here)) if asked_here else "0"
                                                           for stage in STAGES), str(sum(row["differences"] for row in own))])
    return table(
        "Families of cases, and the slowest stage that an answer went to. A family that ends in integers is one on which "
        "doubles could not have told the truth.", ["family", "answers", *STAGES.values(), "differ"], body, range(1, len(STAGES) + 3))


def chapter(study):
    return f"""<p>{code('filtered')} answers by stages: plain doubles with a proved bound on their error; where that cannot
tell, double-doubles (two doubles for one number); where those cannot, integers as long as it takes. The soak asks it about
cases made to hurt (exact tangency, needles, points, extreme exponents, far from the origin) in three ways (a triangle, a
prepared polygon, the whole answer) and holds every answer against {code('exact')}.</p>""" + stages_table(study)
