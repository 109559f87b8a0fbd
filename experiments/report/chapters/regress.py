# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone regress`: third-party engines on the same cases."""
import re

from engine_tables import OVERALL, by_family, overall
from names import ENGINES
from page import code, count, counted, escaped, folded, percent, power, table, words
from readings.regress import OWN, Outcomes, asked, cases_of, polygons_of, rows_by_engine, rows_of

TITLE = "Other engines on the same questions"


def shown(text):
    """2^-28 as 2⁻²⁸, and 5 % on one line."""
    return re.sub(r"2\^(-\d+)", lambda match: power("2", match[1]), escaped(text)).replace(" %", "\u00a0%")


def finding(study):
    rows = rows_of(study)
    lines = overall(rows, polygons_of(study, rows))
    others = [line for line in lines if line[0] not in OWN]
    outcomes = {engine: Outcomes.of(rows) for engine, rows in rows_by_engine(rows).items()}
    wrong = sorted((outcomes[name].wrong / outcomes[name].cases, name) for name, _, share, *_ in others if not share.startswith("0 of"))
    never = [code(name) for name, _, share, *_ in others if share.startswith("0 of")]
    cases = cases_of(rows)
    text = f"{count(cases)} random cases each, at relative offsets of 2⁻⁸ to 2⁻⁵² from contact and 0: "
    span = words([f"{percent(share)} ({code(name)})" for share, name in dict.fromkeys((wrong[0], wrong[-1]))], "to") if wrong else ""
    text += f"wrong answers of {counted(len(wrong), 'engines')}, {span}" if wrong else "no wrong answer"
    return text + (f"; of {words(never)} none" if never and wrong else "") + "."


def chapter(study):
    rows = rows_of(study)
    absent = [engine for engine in ENGINES if engine not in rows_by_engine(rows)]
    cases = cases_of(rows)
    head, lines = by_family(rows)
    text = f"""<p>{count(cases)} times: does a ball touch a random polygon of {counted(len(head) - 1, 'families', 'family')}?
The radii are at relative offsets of 2⁻⁸ to 2⁻⁵² from contact, or 0: the double
nearest to the distance. Most engines take triangles, and
receive polygons triangulated. An engine that computes in floats rounds such questions before it answers, so that near contact its answer is
that to another question. As many questions are therefore asked whose coordinates and radii are floats, at offsets of 2⁻⁸ to 2⁻²³ or 0. The cases are the same as those of the baseline in <code>tests/experiments/judge/regress</code>, which every
<code>./check</code> compares with.</p>"""
    text += table("Wrong answers of engines. The largest relative offset of a wrong answer says how far from contact it still "
                  "errs.",
                  OVERALL[:1] + ["what it is"] + OVERALL[2:],
                  [[code(name), escaped(what), *map(shown, cells)] for name, what, *cells in overall(rows, polygons_of(study, rows))], range(2, len(OVERALL)))
    if {"cgal-epick-distance", "cgal-double-distance"} <= set(rows_by_engine(rows)):
        text += (f"<p>{code('squared_distance')} is a construction: over {code('cgal-epick-distance')} it is computed in doubles, as over "
                 f"{code('cgal-double-distance')}, so the two agree. {code('do_intersect')} is a predicate, which that kernel decides exactly once "
                 "the square of the radius is rounded.</p>")
    if absent:
        text += (f"<p>Not in this build, because their libraries were missing: {words(map(code, absent))}. "
                 "<code>./reproduce --full</code> installs them.</p>")
    return text + folded("By family of polygons", table(f"By family of polygons: wrong answers of {int(rows[0]['cases']):,}, and the largest relative offset "
                        "of one (at 0: only where the radius is the double nearest to the distance).", head,
                        [[code(name), *(shown(cell.replace("at offset 0 alone", "at 0")) for cell in cells)] for name, *cells in lines],
                        range(1, len(head))))
