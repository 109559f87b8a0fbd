# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone soak`: filtered against exact on adversarial cases."""
from page import code, count, escaped, folded, percent, stacked, table, upper_limit
from readings.bench import STAGE_COLOURS as COLOURS
from readings.soak import asked, rows_of

TITLE = "The certified path under attack"
STAGES = {"double": "doubles", "permanent": "sharper doubles", "double-double": "double-doubles", "fixed-integer": "short integers",
          "unlimited": "unlimited integers"}


def finding(study):
    a = asked(study)["filtered"]
    if a.wrong:
        return f'<b class="no">{count(a.wrong)} answers of {count(a.answers)} differed from the exact ones: see differences.jsonl.</b>'
    whole = sum(row["cases"] for row in rows_of(study) if row["family"] != "all" and row["way"] == "answer")
    rest = (f" The whole answer was compared in {count(whole)} of them; it differs in at most {percent(upper_limit(whole))} of such cases." if whole else "")
    return (f"Not one answer of {count(a.answers)} differed from the exact one, in {count(a.trials)} cases. At 95 % confidence, contact "
            f"differs in at most {percent(upper_limit(a.trials))} of such cases.{rest}")


def stages_table(study):
    rows = rows_of(study)
    families = list(dict.fromkeys(row["family"] for row in rows))
    body = []
    for family in families:
        own = [row for row in rows if row["family"] == family]
        answers = sum(row["cases"] for row in own)
        shares = [sum(row[stage] for row in own) / answers if answers else 0 for stage in STAGES]
        body.append([escaped(family), count(answers), stacked(shares, COLOURS.values(), STAGES.values()), str(sum(row["differences"] for row in own))])
    key = ", ".join(f'<span style="color: {COLOURS[stage]}">■</span>\u00a0{words}' for stage, words in STAGES.items())
    return table(f"Families of cases, and the slowest stage that an answer went to: {key}. A family that ends in integers is one on which doubles could "
                 "not have told the truth.", ["family", "answers", "decided by", "differ"], body, (1, 3))


def chapter(study):
    return f"""<p>{code('filtered')} answers by stages: plain doubles with a proved bound on their error; where that cannot
tell, double-doubles (two doubles for one number); where those cannot, integers as long as it takes. The soak asks it about
cases made to hurt (exact tangency, needles, points, extreme exponents, far from the origin) in three ways (a triangle, a
prepared polygon, the whole answer) and holds every answer against {code('exact')}.</p>""" + folded("By family, and by the stage that decided", stages_table(study))
