# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone recorded`: the questions of a third-party simulation."""
from page import code, count, percent, power, share_of_size, table, upper_limit, words
from readings.recorded import Data, asked

TITLE = "Questions recorded from a simulation"
BUILDS = {"bullet": "doubles", "bullet-float": "floats"}


def finding(study):
    data = Data(study)
    certified = [row for row in data.rows if row["method"] == "filtered"]
    wrong = [f"{percent(row['wrong'] / row['questions'])} of {count(row['questions'])} questions in {BUILDS[name]}"
             for name in data.simulations if (row := data.of_simulation(name))["questions"]]
    ours = sum(row["wrong"] for row in certified)
    return (f"A pile of balls comes to rest at contact, where rounding decides: Bullet answered {words(wrong)} wrongly, "
            f"{code('filtered')} {count(ours) if ours else 'none'}.")


def wrong_of(row):
    if row is None:
        return ["", ""]
    if not row["wrong"]:
        return [f"none (&lt; {percent(row['upper'])})", ""]
    return [percent(row["wrong"] / row["questions"]), share_of_size(row["furthest"]) if row["furthest"] else "0"]


def chapter(study):
    data = Data(study)
    near = [f"{percent(data.near[name, 'own', k])} within {power('2', -k)} in {BUILDS[name]}"
            for name, k in (("bullet", 50), ("bullet-float", 20)) if (name, "own", k) in data.near]
    rows = [["the simulation itself", *(cell for name in data.simulations for cell in wrong_of(data.of_simulation(name)))]]
    rows += [[code(method), *(cell for name in data.simulations for cell in wrong_of(data.at.get((name, "own", method))))] for method in data.methods]
    head = ["method"] + [title for name in data.simulations for title in (f"wrong, questions in {BUILDS[name]}", "furthest")]
    return f"""<p>Bullet steps {count(data.piles())} piles of balls that fall on a rough bowl of triangles, with its own settings. Every question
of ball and triangle that its narrow phase asks is recorded, with the answer that it got, and asked again. Its solver moves balls at rest
to depth 0, so the questions of a pile are near: {words(near)} of the triangle's size.</p>""" + table(
        "Does the ball touch the triangle? Wrong answers, and the furthest one from contact, as a share of the triangle's size. The simulation "
        f"itself: whether Bullet reported a depth of at least 0. Limits (95 %) hold as if questions were independent; of piles without a wrong answer, "
        f"fewer than {percent(upper_limit(data.piles()))} would have one. A step that sees contact an ulp late does no harm by itself.",
        head, rows, range(1, len(head)))
