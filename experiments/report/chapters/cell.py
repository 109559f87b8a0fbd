# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone cell`: the thesis's manufacturing cell, playing."""
from page import code, count, escaped, percent, picture, rounded, smaller, table, upper_limit, words
from readings.asked import Asked
from results import DataError, finite, natural

TITLE = "The manufacturing cell, playing"


def moves_of(study):
    return study.rows("moves.csv", move=natural, phase=str, joint=str, until=str, degrees=finite, exact_deg=finite, kind=str, face=str)


def asked(study):
    rows = study.rows("methods.csv", method=str, asked=natural, wrong_hits=natural, wrong_misses=natural, unsure=natural)
    return {row["method"]: Asked(row["asked"], row["wrong_hits"] + row["wrong_misses"], row["asked"], "questions", row["unsure"]) for row in rows}


def said_of_methods(study):
    counts = asked(study)
    wrong = [f"{code(m)} {count(a.wrong)}" for m, a in counts.items() if a.wrong]
    questions = max((a.trials for a in counts.values()), default=0)
    if not questions:
        return "No method was asked beside."
    if wrong:
        return f"Wrong answers among {count(questions)}: {words(wrong)}."
    return (f"Not one of {len(counts)} methods was wrong about the {count(questions)} questions where boxes meet; so few say "
            f"little: at most {percent(upper_limit(questions))} of such questions (95 %).")


def finding(study):
    moves = moves_of(study)
    return (f"<b>The cell of the thesis</b> runs its whole process, {len(moves)} moves and {count(study.run['samples_done'])} "
            f"stops, every contact decided exactly; the joint's angle at each contact is enclosed between neighbouring "
            f"doubles. {said_of_methods(study)}")


def iframe(page):
    """The page of `touchstone cell export`, which needs no other file, within this one."""
    try:
        text = page.read_text(encoding="utf-8")
    except OSError as error:
        raise DataError(f"{page}: {error.strerror}") from None
    if "<canvas" not in text:
        raise DataError(f"{page}: is not a page of 'touchstone cell export'")
    return (f'<iframe class="cell" title="The cell, playing: run, step and turn it" loading="lazy" sandbox="allow-scripts" '
            f'srcdoc="{escaped(text)}"></iframe>')


def still(study):
    """For paper: a picture of the thesis's figures, where they were drawn."""
    path = smaller(study.folder.parent / "thesis", "5-20")
    return "" if path is None else f'<div class="paper">{picture(path, "The cell in perspective, at home.", "The cell at home; on a screen it plays here.")}</div>'


def chapter(study):
    moves = moves_of(study)
    contacts = [row for row in moves if row["until"] == "contact"]
    off = max((abs(row["degrees"] - row["exact_deg"]) for row in contacts), default=0)
    follows = (f" <b>What follows:</b> stepping by whole degrees, as the thesis does, stops up to {rounded(off)} degrees "
               "beyond the exact contact."
               if contacts else "")
    text = """<p>The thesis of 2008 lets a robot carry a part between a storage and a milling machine, and stops each joint
where a <i>virtual sphere</i> at the gripper touches a face. Below is that cell with our numbers: press Run. It plays without
any program or network; the sphere turns orange where it touches.</p>"""
    page = study.folder / "cell.html"
    text += iframe(page) + still(study)
    text += '<p class="dim">The playing cell alone: <a href="cell/cell.html">cell.html</a>, by <code>touchstone cell export</code>.</p>'
    return text + table(
        f"The moves. Commanded: by whole steps; exact: where contact, or the plan, is. until: what ends the move.{follows}",
        ["move", "phase", "joint", "until", "commanded", "exact"],
        [[str(row["move"]), escaped(row["phase"]), escaped(row["joint"]), escaped(row["until"]), f"{row['degrees']:+g}°".replace("-", "−"),
          f"{row['exact_deg']:+.6f}°".replace("-", "−")] for row in moves], (4, 5))
