# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone soak --moving`: filtered against exact on adversarial motions."""
from chapters import soak
from page import code, count, folded, percent, upper_limit
from readings.soak import asked

TITLE = "The certified path under attack by moving balls"


def finding(study):
    a = asked(study)["filtered"]
    if a.wrong:
        return soak.finding(study)
    return (f"Not one answer of {count(a.answers)} differed from the exact one, in {count(a.trials)} motions: at most "
            f"{percent(upper_limit(a.trials))} of such motions are answered wrongly (95 %).")


def chapter(study):
    return f"""<p>The balls of the chapter above move: along edges, past vertices, through faces, far away, or not at all; in a quarter of
the motions the radius just grazes, up to a double. Contact and first contact (kind, time, feature, point and whether it is momentary) of
{code("filtered")}, with and without vector instructions, are compared with {code("exact")}.</p>""" + folded("By family", soak.stages_table(study))
