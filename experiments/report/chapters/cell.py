# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone cell`: the thesis's manufacturing cell, playing."""
import dataclasses
import json

import chart
from looks import look_of
from page import code, count, escaped, folded, percent, picture, power, rounded, smaller, table, upper_limit, words
from readings.cell import Questions, asked
from results import DataError, finite, maybe, natural

TITLE = "The manufacturing cell, playing"
DRIVEN, EXACTLY = "driven", "u-part"  # folders: a run with a U part that the thesis's method drives, and one by the exact answer


def moves_of(study):
    return study.rows("moves.csv", move=natural, phase=str, joint=str, until=str, degrees=finite, exact_deg=finite, kind=str, face=str)


def said_of_methods(study):
    """Of the recorded questions of both case studies."""
    questions = Questions(study)
    if not questions.asked:
        return ""
    wrong = [f"{code(m)} {count(questions.wrong(m))}" for m in questions.methods if questions.wrong(m)]
    said = f"wrong answers of {words(wrong)}" if wrong else f"not one wrong answer of {count(len(questions.methods))} methods, {code('thesis')} among them"
    nearest = questions.nearest()
    near = "" if nearest is None else (f" The nearest is within {power('2', -nearest)} of the face’s size from contact, and none within "
                                       f"{power('2', -nearest - 1)}: rounding is far below that.")
    return f" In both case studies, of {count(questions.asked)} questions about every face at every stop, {said}.{near}"


def finding(study):
    moves = moves_of(study)
    return (f"The cell of the thesis runs its whole process, {len(moves)} moves and {count(study.run['samples_done'])} "
            f"stops, every contact decided exactly; the joint's angle at each contact is enclosed between neighbouring "
            f"doubles.{said_of_methods(study)}")


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


def path_of(study, run):
    """The stops of a run with the U part, in its first turn of the base: the sphere's place in mm, and what it touches."""
    rows = study.rows(f"{run}/trajectory.csv", stop=natural, phase=str, joint=str, sphere_x=finite, sphere_y=finite, sphere_z=finite, touched_face=str, material=str)
    return [row for row in rows if (row["phase"], row["joint"]) == ("to-storage", "base")]


def notched_face(study):
    """The face of the part about which the thesis's method was wrong: case id, ball and outline, as the run wrote the case."""
    path = study.folder / DRIVEN / "disagreements.jsonl"
    try:
        case = json.loads(path.read_text(encoding="utf-8").splitlines()[0])
        return case["ball"], case["polygon"]["outer"]
    except OSError as error:
        raise DataError(f"{path}: {error.strerror}") from None
    except (ValueError, LookupError, TypeError) as error:
        raise DataError(f"{path}: its first case cannot be read: {error}") from None


@dataclasses.dataclass(frozen=True)
class Consequence:
    """A wrong answer that changes what the robot does."""
    drawing: str  # SVG
    words: str


def consequence(study):
    """Of a U-shaped part that the thesis's method lets the robot grip; None if that was not run."""
    if not (study.folder / DRIVEN).is_dir() or not (study.folder / EXACTLY).is_dir():
        return None
    driven, exactly = (path_of(study, run) for run in (DRIVEN, EXACTLY))
    ball, outline = notched_face(study)
    gap = next(row["gap"] for row in study.rows(f"{DRIVEN}/moves.csv", phase=str, joint=str, gap=maybe(finite)) if row["gap"] is not None)
    xs, ys = zip(*(point[:2] for point in outline))
    low_x, low_y, width = min(xs) - 2, min(ys) - 8, 380
    scale = width / (max(xs) + 14 - low_x)
    height = (max(ys) + 4 - low_y) * scale

    def at(x, y):
        return f"{(x - low_x) * scale:.1f},{height - (y - low_y) * scale:.1f}"

    def sphere(row, colour, words, below):
        x, y = at(row["sphere_x"], row["sphere_y"]).split(",")
        return (f'<circle cx="{x}" cy="{y}" r="{ball["radius"] * scale}" stroke="{colour}" stroke-width="2"/><circle cx="{x}" cy="{y}" r="2.5" fill="{colour}" stroke="none"/>'
                + chart.text(float(x) + ball["radius"] * scale + 8, float(y) + below, words, "start", f'style="fill: {colour}; paint-order: stroke; stroke: var(--soft); stroke-width: 5" font-weight="600"'))

    def way(rows, colour, dash):
        near = [at(row["sphere_x"], row["sphere_y"]) for row in rows if low_x < row["sphere_x"] < max(xs) + 14 and low_y < row["sphere_y"]]
        return f'<polyline points="{" ".join(near)}" stroke="{colour}" stroke-width="1.5" stroke-dasharray="{dash}"/>'

    thesis = look_of("thesis")
    drawn = (f'<polygon points="{" ".join(at(*point[:2]) for point in outline)}" fill="var(--paper)" stroke-width="1.5"/>'
             + way(exactly, "currentColor", "2 3") + way(driven, thesis.colour, "") + sphere(exactly[-1], "currentColor", "exact: touches", 5)
             + sphere(driven[-1], thesis.colour, "thesis: “contact”", 24))
    words = (f"The part is U-shaped, seen from above, and the robot's base turns until the sphere at the gripper (circle) touches it. Driven by "
             f"{code('thesis')}, it stops in the notch, {rounded(gap)} mm from any material, and grips there; {count(len(exactly) - len(driven))} steps later it "
             "would have touched. The process then ends where the part, held wrongly, touches the vice. Driven by the exact answer it completes.")
    return Consequence(chart.part(width, round(height), "Seen from above: the U part, the way of the sphere, and where it stops by the thesis's method, in the "
                                  "notch, and by the exact answer, at the part.", drawn), words)


def near_table(study):
    """How near the questions of the case studies come to contact; empty if they were not recorded."""
    questions = Questions(study)
    if not questions.asked:
        return ""
    last = max((k for k, near in questions.near.items() if near), default=0) + 1
    rows = [[power("2", -k) if k else "1", count(questions.near[k])] for k in range(last + 1)]
    return folded("How near the questions of the case studies come to contact", table(
        f"Questions whose radius is at most such a share of the face's size from the exact distance, of {count(questions.asked)}.",
        ["share of the size", "questions"], rows, (1,)))


def chapter(study):
    moves = moves_of(study)
    contacts = [row for row in moves if row["until"] == "contact"]
    off = max((abs(row["degrees"] - row["exact_deg"]) for row in contacts), default=0)
    follows = (f" <b>What follows:</b> stepping by whole degrees, as the thesis does, stops up to {rounded(off)} degrees "
               "beyond the exact contact."
               if contacts else "")
    text = """<p>The thesis of 2008 lets a robot carry a part between a storage and a milling machine, and stops each joint
where a <i>virtual sphere</i> at the gripper touches a face. That cell plays below,
with our numbers, without any program or network.</p>"""
    page = study.folder / "cell.html"
    text += folded("Play it here", iframe(page)) + still(study)
    text += '<p class="dim">The playing cell alone: <a href="cell/cell.html">cell.html</a>, by <code>touchstone cell export</code>.</p>'
    return text + near_table(study) + folded("The moves", table(
        f"The moves. Commanded: by whole steps; exact: where contact, or the plan, is. until: what ends the move.{follows}",
        ["move", "phase", "joint", "until", "commanded", "exact"],
        [[str(row["move"]), escaped(row["phase"]), escaped(row["joint"]), escaped(row["until"]), f"{row['degrees']:+g}°".replace("-", "−"),
          f"{row['exact_deg']:+.6f}°".replace("-", "−")] for row in moves], (4, 5)))
