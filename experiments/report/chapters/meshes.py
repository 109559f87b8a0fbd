# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone meshes`: every face of meshes of real machines."""
from names import NAMED, of_method
from page import bar, code, count, counted, escaped, folded, percent, table, words
from readings.meshes import Data, asked

TRUTH = "exact"  # with which all are compared, itself included
TITLE = "Real input: every face of a robot cell"
TESTS = {"plane": "plane", "foot": "foot", "edges": "edges", "contact": "final answer"}


def finding(study):
    data, all_asked = Data(study), asked(study)
    faces = sum(data.faces.values())
    failing = [f"{of_method(m)} {percent(a.wrong / a.answers)}" for m, a in all_asked.items() if a.wrong and m in NAMED]
    never = [code(m) for m, a in all_asked.items() if not a.wrong and m != TRUTH]
    text = (f"On {counted(faces, 'triangles')} of {counted(len(data.faces), 'meshes', 'mesh')} of robot "
            f"arms and a milling centre, with balls at most two doubles from a threshold, of "
            f"{count(max(a.answers for a in all_asked.values()))} final answers were wrong: ")
    text += words(failing) if failing else "none of those asked"
    if never:
        text += f"; of {words(never)} not one"
    return text + "."


def rate(wrong, trials):
    return bar(wrong / trials, percent(wrong / trials)) if wrong else "0"


def chapter(study):
    data = Data(study)
    faces = sum(data.faces.values())
    methods = data.methods
    by_test = table(
        f"Wrong answers by test, on all {count(faces)} faces. <i>plane</i>: does the ball cross the face's plane? <i>foot</i>: "
        "is the point of that plane straight below the centre inside the face? <i>edges</i>: the list of edges within the "
        f"radius: of {count(data.counts(methods[0], 'plane')[1])} balls each. The final answer is contact or none, of the "
        f"{count(data.counts(methods[0])[1])} balls whose radius is near its threshold.",
        ["method", *TESTS.values()],
        [[code(m), *(rate(*data.counts(m, test)) for test in TESTS)] for m in methods], range(1, 5))
    by_machine = table(
        "Wrong final answers by machine, of the balls whose radius is near its threshold.",
        ["machine", "meshes", "faces", *(code(m) for m in methods)],
        [[escaped(folder), str(sum(mesh.startswith(folder + "/") for mesh in data.faces)),
          count(sum(n for mesh, n in data.faces.items() if mesh.startswith(folder + "/"))),
          *(percent(wrong / trials) if wrong else "0" for wrong, trials in (data.counts(m, mesh=folder + "/") for m in methods))]
         for folder in data.folders], range(1, 3 + len(methods)))
    rejected = sum(row["rejected"] for row in {row["mesh"]: row for row in data.rows}.values())
    ordered = sorted((data.counts(m)[0] / data.counts(m)[1], m) for m in methods)
    least = next(((rate, m) for rate, m in ordered if rate), None)
    text = f"""<p>Do such failures need contrived shapes? Debian's package <code>linuxcnc-uspace</code> ships the meshes of
{counted(len(data.folders), 'machines')}: robot arms and a milling centre. Each of their {count(faces)} faces is asked about
20 balls: 5 near the face, 5 near an edge and 5 near a vertex, with the double nearest to the exact distance as the radius,
and one and two doubles to either side; and 5 with an ample radius, whose centre is moved by single doubles so that its
<i>foot</i> (the point of the face's plane straight below it) crosses an edge. The truth is {code("exact")}: rational
arithmetic on the doubles as they are. {counted(rejected, 'faces') if rejected else "Not one"}
{"were" if rejected > 1 else "was"} rejected as no polygon.</p>"""
    if least:
        text += (f"<p>Of the methods that err at all, {code(least[1])} errs least, in {percent(least[0])}; "
                 f"{code(ordered[-1][1])} most, in {percent(ordered[-1][0])}.</p>")
    return text + folded("By test, and by machine", by_test + by_machine)
