# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: examples.py TOUCHSTONE SOURCE COMPILER

The two engines of docs/engines.md run as they stand there, and are judged as the page says. Exit status 1
otherwise.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

SQUARE = {"outer": [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]}
CASES = [
    # A vertex is nearest: right. The middle of an edge is: wrong about it.
    {"id": "vertex", "ball": {"center": [-3, -4, 0], "radius": 5}, "polygon": SQUARE,
     "expected": {"contact": True, "distance": 5}},
    {"id": "edge", "ball": {"center": [1, -1, 0], "radius": 1}, "polygon": SQUARE, "expected": {"contact": True}},
]


def judged(program, engine, folder):
    cases = folder / "cases.jsonl"
    cases.write_text("".join(json.dumps(case) + "\n" for case in CASES))
    done = subprocess.run([program, "judge", "--engine", engine, cases], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def main(program, source, compiler):
    page = (pathlib.Path(source) / "docs/engines.md").read_text()
    blocks = dict(re.findall(r"```(python|cpp)\n(.*?)```", page, re.DOTALL))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "engine.py").write_text(blocks["python"])
        (folder / "engine.cpp").write_text(blocks["cpp"])
        subprocess.run([compiler, "-std=c++20", "-o", folder / "engine", folder / "engine.cpp"], check=True)
        for engine in [f"{sys.executable} {folder}/engine.py", f"{folder}/engine"]:
            status, verdicts, complaints = judged(program, engine, folder)
            wanted = f"case edge: method {engine}: contact: expected true, found false\n"
            if (status, complaints) != (1, wanted) or len(verdicts.splitlines()) != len(CASES):
                sys.exit(f"{engine}: exit status {status}\n{verdicts}{complaints}")


if __name__ == "__main__":
    main(*sys.argv[1:])
