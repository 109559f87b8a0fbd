# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: control_bytes.py TOUCHSTONE

No control character of a file, of an id or of a file's name reaches a terminal, whatever field it stands in; neither
does a character that changes the direction of writing. None begins a line of its own, and none cuts a message short:
what stands behind it is there. JSON on standard output is JSON. Exit status 1 otherwise.
"""

import json
import os
import re
import subprocess
import sys
import tempfile

WORD = b"\x1b[31m\xc2\x9b\x7f\xe2\x80\xae\0END"  # a field between blanks
NAME = b"\x1b[31m\xc2\x9b\x7f\xe2\x80\xae\nFORGED END"  # of a file, or on a command line
TEXT = "\x1b[31m\x9b\x7f\u202e\0\nFORGED END"  # within JSON
SHOWN = rb"\x1b[31m\xc2\x9b\x7f\xe2\x80\xae"
FORBIDDEN = re.compile(rb"[\x00-\x09\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\x8e\x8f\xaa-\xae]|\xe2\x81[\xa6-\xa9]"
                       rb"|(?m:^FORGED)")

TRIANGLE = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
OFF = b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
STL = (b"solid " + b"a" * 80 + b"\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
       b"endfacet\nendsolid\n")
PLY = (b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       b"element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")


def changed(text, old, new=WORD):
    assert old in text, old
    return text.replace(old, new, 1)


# Each is a mesh with one field that is wrong.
MESHES = {
    "vertex.obj": changed(TRIANGLE, b"v 0", b"v " + WORD),
    "weight.obj": changed(TRIANGLE, b"v 0 0 0", b"v 0 0 0 " + WORD),
    "face.obj": changed(TRIANGLE, b"f 1", b"f " + WORD),
    "header.off": changed(OFF, b"OFF"),
    "count.off": changed(OFF, b"3 1 0", WORD + b" 1 0"),
    "vertex.off": changed(OFF, b"1 0 0", WORD + b" 0 0"),
    "face.off": changed(OFF, b"3 0 1 2", b"3 0 1 " + WORD),
    "colour.off": OFF[:-1] + b" " + WORD + b"\n",
    "vertex.stl": changed(STL, b"vertex 1", b"vertex " + WORD),
    "word.stl": changed(STL, b"endloop"),
    "solid.stl": changed(STL, b"solid", WORD.replace(b"\0", b"")),  # which is no sign of a binary file
    "format.ply": changed(PLY, b"ascii"),
    "word.ply": changed(PLY, b"property float y", WORD + b" float y"),
    "type.ply": changed(PLY, b"float y", WORD + b" y"),
    "count.ply": changed(PLY, b"vertex 3", b"vertex " + WORD),
    "list.ply": changed(PLY, b"list uchar", b"list " + WORD),
    "element.ply": changed(PLY, b"end_header", b"element " + WORD + b" 9\nproperty int a\nend_header"),
    "binary.ply": changed(changed(PLY, b"ascii", b"binary_little_endian").split(b"0 0 0")[0],
                          b"element", b"element " + WORD + b" 9\nproperty double a\nelement"),
    "value.ply": changed(PLY, b"1 0 0", WORD + b" 0 0"),
    "corner.ply": changed(PLY, b"3 0 1 2", b"3 0 1 " + WORD),
}

CASE = {"id": "a", "ball": {"center": [0, 0, 1], "radius": 1}, "polygon": {"outer": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}}


def case(**members):
    return (json.dumps({**CASE, **members}) + "\n").encode()


def line(text):
    return text.encode() + b"\n"


# Each is a case with one field, or a line with one word, that is complained about.
CASES = {
    "id of a rejected case": case(id=TEXT, ball={"center": [0, 0, 1], "radius": -1}),
    "id of a case that is not met": case(id=TEXT, expected={"contact": False}),
    "value that is not met": case(expected={"relation": TEXT}),
    "key that is not met": case(expected={"nearest": {TEXT: 1}}),
    "unknown key": case(expected={TEXT: True}),
    "unknown code": case(expected={"error": TEXT}),
    "key twice": line(case()[:-2].decode() + ', %s: 1, %s: 2}' % ((json.dumps(TEXT),) * 2)),
    "word that is no JSON": b"{" + WORD + b"}\n",
    "control character that is no JSON": b"{\"id\": \"\x1b[31m END",
    "bytes that are not UTF-8, and so no JSON": b"{\"id\": \"\x9b\xff END\"}\n",
}

# An engine prints what lies in this file.
REPLIES = {
    "line": WORD + b"\n",
    "id": (json.dumps({"id": TEXT, "contact": True}) + "\n").encode(),
    "value": (json.dumps({"id": "a", "contact": TEXT}) + "\n").encode(),
    "key that stands twice": line('{"id": "a", %s: 1, %s: 2}' % ((json.dumps(TEXT),) * 2)),
}


class Checks:
    def __init__(self, program, folder):
        self.program, self.folder, self.faults = program, folder, []

    def write(self, name, content):
        with open(os.path.join(os.fsencode(self.folder), os.fsencode(name)), "wb") as file:
            file.write(content)

    def run(self, what, *arguments, status=(2,), echoes=None, json_lines=False):
        """`echoes`: bytes that must be seen."""
        done = subprocess.run([self.program, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True)
        shown = done.stderr
        if json_lines:
            for verdict in done.stdout.splitlines():
                json.loads(verdict)
        else:
            shown += done.stdout
        found = FORBIDDEN.search(shown)
        if found:
            self.faults.append(f"{what}: {found.group()!r} in {shown!r}")
        if done.returncode not in status:
            self.faults.append(f"{what}: exit status {done.returncode}: {shown!r}")
        for text in echoes or ():
            if text.lower() not in shown.lower():  # STL's words are told in small letters
                self.faults.append(f"{what}: no {text!r} in {shown!r}")


def ask(mesh, balls="balls"):
    return "ask", "--mesh", mesh, "--balls", balls


def check_meshes(checks):
    checks.write("balls", b"0 0 0 1\n")
    for name, content in MESHES.items():
        checks.write(name, content)
        faces = ("near-edge", name, "--methods", "fast", "--force")
        for arguments in (ask(name), faces, (*faces, "--skip-bad")):
            checks.run(arguments, *arguments, status=(0, 2) if "--skip-bad" in arguments else (2,), echoes=(SHOWN, b"END"))


def check_names(checks):
    bad = TRIANGLE + b"v 2 0 0\nf 1 2 4\n"  # a face without an area
    for what, content in ("sound", TRIANGLE), ("bad", bad), ("broken", b"f 7 8 9\n"):
        name = NAME + what.encode() + b".obj"
        checks.write(name, content)
        faces = ("near-edge", name, "--methods", "fast", "--force")
        for arguments in (ask(name), faces, (*faces, "--skip-bad")):
            status = (0,) if what == "sound" else (0, 2) if "--skip-bad" in arguments else (2,)
            checks.run(arguments, *arguments, status=status, json_lines=arguments[0] == "ask",
                       echoes=(b"END",) if what != "sound" or arguments[0] != "ask" else ())
    for arguments in (("judge", NAME), ("corpus", "check", NAME), ("corpus", "shrink", NAME, "--method", "fast"),
                      ask(NAME + b".obj"), ("near-edge", NAME + b".xyz" + NAME, "--methods", "fast", "--force"),
                      ("regress", "--baseline", NAME), (NAME,), ("judge", b"--" + NAME), ("judge", "--methods", NAME)):
        checks.run(arguments, *arguments, status=(1, 2, *range(100, 120)),
                   echoes=(SHOWN,) if len(arguments) > 1 else ())
    checks.write("a.obj", TRIANGLE)
    checks.write(NAME, WORD + b" 0 0 1\n")
    checks.run("balls", *ask("a.obj", NAME), echoes=(SHOWN, b"END"))


def check_cases(checks):
    for what, content in CASES.items():
        checks.write("cases.jsonl", content)
        for arguments in (("judge",), ("judge", "--engine", "cat"), ("judge", "--engine", "exit 1"),
                          ("corpus", "check"), ("corpus", "shrink", "--method", "fast")):
            told = "JSON" not in what and not ("shrink" in arguments and what.startswith(("value", "key that is")))
            checks.run((what, arguments), *arguments, "cases.jsonl", status=(1, 2), json_lines="check" not in arguments,
                       echoes=(b"END",) if told else ())
    for what, content in REPLIES.items():
        checks.write("cases.jsonl", case(expected={"contact": False}))
        checks.write("reply", content)
        checks.run(what, "judge", "--engine", "cat reply; cat >/dev/null", "cases.jsonl", status=(1,), echoes=(b"END",),
                   json_lines=True)
    checks.run("engine", "judge", "--engine", b"exit 1 # " + NAME, "cases.jsonl", status=(1,), echoes=(SHOWN,),
               json_lines=True)


def check_baselines(checks):
    settings = ("--methods", "fast,thesis", "--samples", "1", "--seed", "3")
    checks.run("baseline", "regress", *settings, "--write", "sound.json", status=(0,))
    with open(os.path.join(checks.folder, "sound.json")) as file:
        sound = json.load(file)
    fast = sound["methods"]["fast"]
    for what, status, content in (
            ("method", 0, {**sound, "methods": {**sound["methods"], TEXT: fast}}),
            ("key", 2, {**sound, TEXT: 1}),
            ("family", 2, {**sound, "methods": {TEXT: {**fast, TEXT: ""}}}),
            ("digits", 2, {**sound, "methods": {TEXT: {**fast, "star": TEXT}}}),
            ("version", 2, {**sound, "version": TEXT}),
            ("unsure", 2, {**sound, "unsure": {TEXT: fast}})):
        checks.write("other.json", json.dumps(content).encode())
        checks.run(("baseline", what), "regress", "--methods", "fast", "--baseline", "other.json", status=(status,),
                   echoes=(b"END",))
    twice = json.dumps(sound)[:-1] + ', %s: 1, %s: 2}' % ((json.dumps(TEXT),) * 2)
    for what, content in ("key that stands twice", twice.encode()), ("word that is no JSON", b"{" + WORD):
        checks.write("other.json", content)
        checks.run(("baseline", what), "regress", "--baseline", "other.json")


def check_parts(checks):
    soak = ("soak", "--samples", "3", "--part", "1/1", "--output", "soak")
    checks.run("soak", *soak, status=(0,))
    path = os.path.join(checks.folder, "soak", "part.json")
    with open(path) as file:
        sound = json.load(file)
    for what, content in (("seed", json.dumps({**sound, "seed": TEXT}).encode()),
                          ("word that is no JSON", b"{" + WORD)):
        with open(path, "wb") as file:
            file.write(content)
        checks.run(("part", what), "merge", "soak", "--output", "all", echoes=(b"part.json",))


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        checks = Checks(os.path.abspath(program), folder)
        for check in check_meshes, check_names, check_cases, check_baselines, check_parts:
            check(checks)
        if checks.faults:
            sys.exit("\n".join(checks.faults))


if __name__ == "__main__":
    main(*sys.argv[1:])
