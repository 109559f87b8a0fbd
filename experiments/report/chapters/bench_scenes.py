# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone bench-scenes`: whole scenes, beside other libraries."""
from names import BALLS, QUESTIONS
from noise import TOO_NOISY
from page import code, count, escaped, folded, multiple, percent, picture, rounded, smaller, table, words
from readings.bench_scenes import OURS, Data, are_steady

TITLE = "Whole scenes"


def asked(study):
    return {}


def finding(study):
    data = Data(study)
    most = max(data.largest(scene) for scene in data.scenes)
    wrong = [f"{escaped(library)} {percent(data.wrong(library)[0] / data.wrong(library)[1])}" for library in data.libraries
             if library != OURS and data.wrong(library)[0]]
    return (f"Scenes of up to {count(most)} triangles: {code(OURS)} differed from {code('exact')} in "
            f"{count(data.wrong(OURS)[0])} of {count(data.wrong(OURS)[1])} answers checked" + (f"; beside it, answers that "
                                                                                               f"differ: {words(wrong)}" if wrong else "") + ".")


LENGTHS = {"short": "ways of one radius", "long": "ways of thirty radii"}


def microseconds(row):
    return f"{rounded(row['nanoseconds'] / 1000)} µs" if are_steady(row) else TOO_NOISY


def motions_table(data, scene):
    """First contacts of moving balls, beside the same balls at rest at the start of their ways."""
    rows = []
    for (size, motions), own in grouped(row for row in data.motions if row["scene"] == scene).items():
        ours = own[OURS]
        for library, row in own.items():
            said = "" if row["wrong"] is None else f"{count(row['wrong'])} of {count(row['checked'])}"
            rows.append([f"{LENGTHS.get(motions, motions)}, {count(size)} triangles", escaped(library), microseconds(row),
                         "" if library == OURS or not are_steady(row, ours) else multiple(row["nanoseconds"] / ours["nanoseconds"]), said])
    return table(f"First contact of moving balls: time of a question, in times of {OURS}, and wrong answers. “{OURS}, at the start”: the same balls "
                 "at rest where their ways begin, touching any?", ["motions", "library", "time", f"of {OURS}", "wrong"], rows, (2, 3, 4)) if rows else ""


def grouped(rows):
    """By triangles and kind of motion: the rows by library."""
    groups = {}
    for row in rows:
        groups.setdefault((row["triangles"], row["motions"]), {})[row["library"]] = row
    return groups


def chapter(study):
    data = Data(study)
    text = f"""<p>{code(OURS)} asks about many faces at once, with the answers of {code('exact')} about every one, and skips
what cannot matter. Each library builds the same scene and is asked about the same balls, in turns, with one
thread.</p>"""
    for scene in data.scenes:
        size = data.largest(scene)
        rows = [row for row in data.queries if row["scene"] == scene and row["triangles"] == size]
        questions = list(dict.fromkeys((row["balls"], row["question"]) for row in rows))
        ours = {(row["balls"], row["question"]): row for row in rows if row["library"] == OURS}
        body = []
        for library in data.libraries:
            own = {(row["balls"], row["question"]): row for row in rows if row["library"] == library}
            body.append([escaped(library), *(
                "not asked" if q not in own else microseconds(own[q])
                + (f"<br><small>{multiple(own[q]['nanoseconds'] / ours[q]['nanoseconds'])}</small>"
                   if library != OURS and q in ours and are_steady(own[q], ours[q]) else "")
                + (f"<br><small class=\"no\">{percent(own[q]['wrong'] / own[q]['checked'])} wrong</small>" if own[q]["wrong"] else "")
                for q in questions)])
        numbers = table(f"Scene “{escaped(scene)}” of {count(size)} triangles: microseconds a query, how many times {OURS}'s, "
                      "and answers that differ.",
                      ["library", *(f"{BALLS.get(balls, balls)}: {QUESTIONS.get(question, question)}" for balls, question in questions)], body,
                      range(1, len(questions) + 1))
        path, drawn = smaller(study.folder, f"queries-{scene}"), ""
        if path:
            growth = []
            small = min(row["triangles"] for row in data.queries if row["scene"] == scene)
            for library in data.libraries:
                times = {row["triangles"]: row["nanoseconds"] for row in data.queries if are_steady(row) and
                         (row["scene"], row["library"], row["balls"], row["question"]) == (scene, library, "near", "any")}
                if small in times and size in times and small < size:
                    growth.append(f"{escaped(library)} {multiple(times[size] / times[small])}")
            follows = (f" <b>What follows:</b> from {count(small)} to {count(size)} triangles the time of “near the surface: "
                       f"touches any?” grows by {words(growth)}." if growth else "")
            drawn = picture(path, f"Lines of microseconds a query against triangles in the scene {scene}, a line for each "
                                  "library, a panel for each "
                            "kind of ball and question.", f"Time of a query against the size of the scene "
                                                          f"“{escaped(scene)}”.{follows}")
        text += folded(f"Times of {scene}", drawn + numbers + motions_table(data, scene))
    return text
