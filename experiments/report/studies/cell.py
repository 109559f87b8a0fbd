# SPDX-License-Identifier: GPL-3.0-or-later
"""What the cell asks: every face at every stop of both case studies, as if no boxes were compared first."""
import json

import chart
from asked import Asked
from looks import look_of
from page import code, count, escaped, power, smaller
from results import DataError, finite, maybe, natural
from studies import CELL, DRIVE, OUTPUT, Run, same

RUN = Run(15, "the manufacturing cell", **same(
    ["cell", "run", CELL, "--output", OUTPUT], ["cell", "export", CELL, f"{OUTPUT}/cell.html"],
    *(["cell", "run", CELL, "--preset", f"case {n}", "--every-face", "--output", f"{OUTPUT}/case-{n}"] for n in (1, 2)),
    ["cell", "run", CELL, "--preset", "U-part", "--output", f"{OUTPUT}/u-part"],
    ["cell", "run", CELL, "--preset", "U-part", DRIVE, "thesis", "--output", f"{OUTPUT}/driven"]),
          tiny=["cell", "run", CELL, "--methods", "filtered,fast"])
TITLE = "The manufacturing cell, playing"
DRIVEN, EXACTLY = "driven", "u-part"  # folders: a run with a U part that the thesis's method drives, and one by the exact answer


CASES = ("case-1", "case-2")  # folders of runs with --every-face


class Questions:
    def __init__(self, study):
        self.cases = [case for case in CASES if (study.folder / case).is_dir()]
        self.methods, self.near = {}, {}  # name: asked, wrong hits, wrong misses, unsure; k: questions within 2^-k
        self.asked = 0
        for case in self.cases:
            for row in study.rows(f"{case}/methods.csv", method=str, asked=natural, wrong_hits=natural, wrong_misses=natural, unsure=natural):
                before = self.methods.get(row["method"], (0, 0, 0, 0))
                self.methods[row["method"]] = tuple(a + row[name] for a, name in zip(before, ("asked", "wrong_hits", "wrong_misses", "unsure")))
            rows = study.rows(f"{case}/near.csv", exponent=natural, near=natural, questions=natural)
            self.asked += rows[0]["questions"]
            for row in rows:
                self.near[row["exponent"]] = self.near.get(row["exponent"], 0) + row["near"]

    def nearest(self):
        """The greatest k with a question within 2^-k of a face's size from contact."""
        return max((k for k, near in self.near.items() if near), default=None)

    def wrong(self, method):
        _, hits, misses, _ = self.methods[method]
        return hits + misses


def asked(study):
    """Where the boxes of the sphere and of a face meet: the other questions are far from contact, and would dilute sums."""
    rows = study.rows("methods.csv", method=str, asked=natural, wrong_hits=natural, wrong_misses=natural, unsure=natural)
    return {row["method"]: Asked(row["asked"], row["wrong_hits"] + row["wrong_misses"], row["asked"], "questions", row["unsure"]) for row in rows}


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


def consequence(study):
    """A wrong answer that changes what the robot does: a U-shaped part that the thesis's method lets it grip, as SVG,
    with the numbers of its caption; None if that was not run."""
    if not (study.folder / DRIVEN).is_dir() or not (study.folder / EXACTLY).is_dir():
        return None
    driven, exactly = (path_of(study, run) for run in (DRIVEN, EXACTLY))
    ball, outline = notched_face(study)
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
    title = "Seen from above: the U part, the way of the sphere, and where it stops by the thesis's method, in the notch, and by the exact answer, at the part."
    gaps = study.rows(f"{DRIVEN}/moves.csv", phase=str, joint=str, gap=maybe(finite))
    return {"drawing": chart.part(width, round(height), title, drawn), "gap": next(row["gap"] for row in gaps if row["gap"] is not None),
            "later": len(exactly) - len(driven)}


def exported(path):
    """The page of `touchstone cell export`, which needs no other file."""
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise DataError(f"{path}: {error.strerror}") from None
    if "<canvas" not in text:
        raise DataError(f"{path}: is not a page of 'touchstone cell export'")
    return text


def told(study):
    """`still`, for paper: a picture of the thesis's figures, where they were drawn."""
    moves = study.rows("moves.csv", move=natural, phase=str, joint=str, until=str, degrees=finite, exact_deg=finite, kind=str, face=str)
    questions = Questions(study)
    nearest = questions.nearest()
    return {
        "questions": questions, "nearest": nearest, "wrong": [f"{code(m)} {count(questions.wrong(m))}" for m in questions.methods if questions.wrong(m)],
        "page": exported(study.folder / "cell.html"), "still": smaller(study.folder.parent / "thesis", "5-20"),
        "near": [[power("2", -k) if k else "1", count(near)] for k, near in questions.near.items() if k <= (0 if nearest is None else nearest) + 1],
        "contacts": [abs(row["degrees"] - row["exact_deg"]) for row in moves if row["until"] == "contact"],
        "moves": [[str(row["move"]), escaped(row["phase"]), escaped(row["joint"]), escaped(row["until"]), f"{row['degrees']:+g}°".replace("-", "−"),
                   f"{row['exact_deg']:+.6f}°".replace("-", "−")] for row in moves]}
