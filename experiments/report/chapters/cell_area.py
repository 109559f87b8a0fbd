# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone cell area`: where the cell's storage may stand."""
from page import count, picture, smaller, words
from results import finite

TITLE = "Where the storage of the cell may stand"
OUTCOMES = {"completed": "the whole process runs", "in-the-way": "something is in the way", "no-contact": "the sphere touches nothing",
            "beyond-limits": "a joint is at its limit", "out-of-reach": "out of reach",
            "not-held": "the part is not between the fingers", "misplaced": "the part would not arrive in its place"}


def asked(study):
    return {}


def finding(study):
    rows = study.rows("plan.csv", outcome=str)
    done = sum(row["outcome"] == "completed" for row in rows)
    return f"At its height, the whole process runs with the storage at {count(done)} of {count(len(rows))} places of a grid."


def chapter(study):
    text = """<p>The thesis calls the places from which the robot can fetch the part the <i>area of configuration</i>. The
whole process is run with the storage at every place of a grid.</p>"""
    for name, about in (("plan", "angles and radii, at the height of the storage"),
                        ("heights", "heights and radii, at its angle")):
        rows = study.rows(f"{name}.csv", angle_deg=finite, radius=finite, height=finite, outcome=str)
        path = smaller(study.folder, f"cell-area-{name}")
        counts = {outcome: sum(row["outcome"] == outcome for row in rows) for outcome in OUTCOMES}
        said = words(f"{OUTCOMES[outcome]}: {count(n)}" for outcome, n in counts.items() if n)
        if path:
            text += picture(path, f"A map of places of the storage: {about}; a marker for each outcome.",
                            f"Places of the storage: {about}; a colour and a marker for each outcome. <b>What follows:</b> of "
                            f"{count(len(rows))} places, {said}.")
    return text
