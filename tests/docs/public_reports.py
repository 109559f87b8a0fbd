# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: public_reports.py SOURCE PROGRAM [--write]

The program gives each input of public_reports/ the verdict that is right, and docs/public-reports.md says which. Exit
status 1 otherwise. --write updates the page.

files.jsonl holds mesh files. `content` has one character for each byte. A file with `faces` must be read as these, in
this order ("square": two triangles), with the `warning`, if there is one. A file with `refused` must be refused, with
its name, the place and the word. cases.jsonl holds cases with what an exact method must answer; those with `engines` are also
asked of the engines that Debian has, if the program was built with them.
"""

import itertools
import json
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
DATA = SOURCE / "tests/docs/public_reports"
PAGE = SOURCE / "docs/public-reports.md"
SQUARE = [[[0, 0, 0], [4, 0, 0], [4, 4, 0]], [[0, 0, 0], [4, 4, 0], [0, 4, 0]]]
NEAR = 2.0 ** -40
TEST = re.compile(r"`(\w+)\.(\w+)`")
sys.path.append(str(SOURCE / "experiments/report"))

import markers  # noqa: E402


def lines_of(name):
    return [json.loads(line) for line in (DATA / name).read_text().splitlines()]


def between(a, b, share):
    return [x + (y - x) * share for x, y in zip(a, b)]


def probes(faces):
    """Points, and the faces that hold each: all corners, a point within each edge, and points just beyond each corner."""
    for face in faces:
        for a, b in itertools.pairwise([*face, face[0]]):
            yield a, [i for i, other in enumerate(faces) if a in other]
            yield between(a, b, 0.5), [i for i, other in enumerate(faces) if a in other and b in other]
            yield between(a, b, 1 + NEAR), []
            yield between(b, a, 1 + NEAR), []


def read_as(faces, answers, asked):
    """What differs from the right faces, as text; empty if nothing does. Faces that are not triangles are only counted."""
    found = [[touched["face"] for touched in answer["touched"]] for answer in answers]
    if found[0] != list(range(len(faces))):
        return f"faces {found[0]}, expected {len(faces)}"
    for (point, holders), touched in zip(asked, found[1:]):
        if touched != holders:
            return f"the point {point} is on the faces {touched}, expected {holders}"
    return ""


def verdict(folder, record):
    """What the program says about a file, and a complaint if it is not right."""
    file = folder / record["file"]
    file.write_bytes(record["content"].encode("latin-1"))
    faces = SQUARE if record.get("faces") == "square" else record.get("faces", [])
    asked = list(probes(faces)) if all(len(face) == 3 for face in faces) else []
    balls = [[0, 0, 0, 1e6], *([*point, 0] for point, _ in asked)]
    run = subprocess.run([PROGRAM, "ask", "--mesh", file.name, "--balls", "-"], cwd=folder, capture_output=True, text=True,
                         input="".join(" ".join(map(repr, ball)) + "\n" for ball in balls))
    said, answers = run.stderr.strip(), [json.loads(line) for line in run.stdout.splitlines()]
    if "refused" in record:
        place, word = record["refused"]["place"], record["refused"]["word"]
        begin = f"touchstone: --mesh: {file.name}: " + (f"{place}: " if place else "")
        right = run.returncode == 2 and not answers and said.startswith(begin) and word in said and "\n" not in said
        text = "``" + said.removeprefix(f"touchstone: --mesh: {file.name}: ") + "``" if place else "the extension, or what it holds"
        return f"refused: {text}", "" if right else f"exit status {run.returncode}, '{said}', {len(answers)} answers"
    warning = f"touchstone: warning: {file.name}: " + record["warning"] if "warning" in record else ""
    wrong = "" if run.returncode == 0 and said.startswith(warning) and bool(said) == bool(warning) else f"'{said}'"
    wrong = wrong or read_as(faces, answers, asked)
    off_plane = 0 if wrong else answers[0]["touched"][0].get("off_plane", 0)
    if off_plane != record.get("off_plane", 0):
        wrong = f"off_plane is {off_plane}"
    text = f"{len(faces)} face{'s' if len(faces) > 1 else ''}" + (f", displaced by {off_plane}" if off_plane else "")
    return text + (f"; warning: {said.split(': ', 3)[3]}" if warning and not wrong else ""), wrong


def answer_text(answer):
    if "error" in answer:
        return f"rejected: {answer['error']}"
    if "first" in answer:
        return f"contact on the way, at time {answer['time']}" if answer["first"] == "way" else "no contact on the way"
    return f"{answer['relation']}, distance {answer['distance']}"


def judged():
    """Complaints about cases: the verdicts of both exact paths, and what the independent checker says of one."""
    run = subprocess.run([PROGRAM, "judge", "--methods", "exact,filtered", "--quiet", DATA / "cases.jsonl"], capture_output=True, text=True)
    if run.returncode != 0:
        return ["cases.jsonl: touchstone judge: a verdict is not the expected one"]
    verdicts = [line for line in run.stdout.splitlines() if json.loads(line)["method"] == "exact"]
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "verdicts.jsonl")
        file.write_text("\n".join(verdicts) + "\n")
        checked = subprocess.run([sys.executable, "-B", SOURCE / "tests/system/independent/checker.py", DATA / "cases.jsonl", file],
                                 capture_output=True, text=True)
    return [] if checked.returncode == 0 else checked.stdout.splitlines()


# Those of Debian that answer about spheres and triangles, and the packages that have them.
ENGINES = {"fcl": "libfcl-dev", "libccd": "libccd-dev", "bullet": "libbullet-dev", "ode": "libode-dev", "embree-fast": "libembree-dev"}


def engine_names():
    """Each method with the version of its package; nothing if the program was built without one of them."""
    known = subprocess.run([PROGRAM, "methods"], capture_output=True, text=True, check=True).stdout.split("\n")
    if not ENGINES.keys() <= {line.split()[0] for line in known if line}:
        return []
    listed = subprocess.run(["dpkg-query", "-W", "-f", "${Package}=${Version}\n", *ENGINES.values()], capture_output=True, text=True, check=True)
    versions = dict(line.split("=") for line in listed.stdout.split())
    return [f"`{name}` {re.split('[-+~]', versions[package].split(':')[-1])[0]}" for name, package in ENGINES.items()]


def engine_rows(cases):
    """What these engines say of contact."""
    said = {}
    run = subprocess.run([PROGRAM, "judge", "--methods", ",".join(ENGINES), "--keys", "contact", "--quiet", DATA / "cases.jsonl"],
                         capture_output=True, text=True)
    for line in run.stdout.splitlines():
        answer = json.loads(line)
        said[answer["id"], answer["method"]] = answer.get("contact")

    def word(case, engine):
        found, right = said[case["id"], engine], case["expected"]["contact"]
        if found is None:
            return "no answer"
        return "right" if found == right else "**wrong**: contact" if found else "**wrong**: none"

    return [[case["id"], case["source"], "contact" if case["expected"]["contact"] else "none", *(word(case, engine) for engine in ENGINES)]
            for case in cases if case.get("engines")]


def table(head, rows):
    cells = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |\n" for row in cells)


def missing_tests(page):
    """The tests that the page names and that do not exist."""
    text = "".join(path.read_text() for kind in ("*.cpp", "*.py") for path in (SOURCE / "tests").rglob(kind))
    for suite, name in TEST.findall(page):
        if not re.search(rf"\({suite}, {name}\)|class {suite}\b.*?def {name}\b", text, re.DOTALL):
            yield f"{PAGE.name}: there is no test {suite}.{name}"


def main(*options):
    rows, wrong = [], judged()
    with tempfile.TemporaryDirectory() as folder:
        for record in lines_of("files.jsonl"):
            text, complaint = verdict(pathlib.Path(folder), record)
            rows.append([f"`{record['file']}`", record["about"], record["source"], text])
            if complaint:
                wrong.append(f"{record['file']}: {complaint}")
    asked = lines_of("cases.jsonl")
    cases = [[case["id"], case["about"], case["source"], answer_text(case["expected"])] for case in asked]
    tables = {"files": table(["file", "what is odd", "public report", "verdict"], rows),
              "cases": table(["case", "question", "public report", "verdict"], cases)}
    if engines := engine_names():
        tables["engines"] = table(["case", "public report", "exact", *engines], engine_rows(asked))
    for name, made in tables.items():
        before, found, after = markers.split(PAGE, name)
        if "--write" in options:
            PAGE.write_text(before + made + after)
        elif found != made:
            wrong.append(f"{PAGE.name}: the table '{name}' differs from what the program says; --write updates it")
    wrong += missing_tests(PAGE.read_text().partition("\n## Other inputs\n")[2])
    print("\n".join(wrong) or f"{len(rows)} files and {len(cases)} cases have the right verdict")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[3:]))
