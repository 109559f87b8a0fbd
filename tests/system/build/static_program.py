# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: static_program.py BUILD ORDINARY SCRATCH [EMULATOR]

`cpack` makes an archive of BUILD, a build of a preset `static`. Its program has no dynamic section, and with its data it
answers as the program ORDINARY does, byte for byte, also to a check of the corpus, which it finds beside itself: in a
root that holds nothing else, with an empty environment. So does its judge of an engine, which takes a shell of this machine.
EMULATOR runs a program of another architecture. It needs files of this machine, so the root is this machine's.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).parents[1]))
from running import expect, run  # noqa: E402

BUILD, ORDINARY, SCRATCH = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
EMULATOR = [shutil.which(word) for word in sys.argv[4:]]
SOURCE = pathlib.Path(__file__).parents[3]
CORPUS = "share/touchstone/tests/corpus"
MOST_BYTES = 25_000_000
# Their arithmetic is that of every machine. Others depend on libm, long doubles, or the order in which Eigen adds floats.
EVERYWHERE = "exact,filtered,fast,interval,rational"
BALL, TRIANGLE = ["ask", "--ball", "1,1,1,1.1547005383792515"], ["--polygon", "1 0 0, 0 1 0, 0 0 1"]


def unpacked():
    """The folder of the archive, alone in a new root."""
    shutil.rmtree(SCRATCH, ignore_errors=True)
    root = SCRATCH / "root"
    root.mkdir(parents=True)
    run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", SCRATCH)
    archive, = SCRATCH.glob("*.tar.gz")
    run("tar", "-xf", archive, "-C", root)
    folder, = root.iterdir()
    expect(f"{folder.name}.tar.gz" == archive.name, f"{archive.name} holds {folder.name}")
    return folder


def check_needs_nothing(program):
    headers = run("readelf", "--wide", "--program-headers", program).stdout
    expect("LOAD" in headers, f"readelf shows no segments: {headers}")
    needed = re.findall(r"^ +(?:INTERP|DYNAMIC) .*", headers, re.MULTILINE)
    expect(not needed, f"{program} is linked dynamically: {needed}")
    size = program.stat().st_size
    expect(size < MOST_BYTES, f"{program} has {size} bytes")
    print(f"{program.name} has {size} bytes and no dynamic section")


class Program:
    """Runs in the folder of the corpus, without any environment; `root`: the folder that it takes for the whole machine."""

    def __init__(self, program, corpus, root=None):
        self.command, self.corpus = [*(EMULATOR if program != ORDINARY else []), program], corpus
        if root:
            as_root = [] if os.geteuid() == 0 else ["--map-root-user"]
            inside = [f"/{path.relative_to(root)}" for path in (corpus, program)]
            self.command = [shutil.which("unshare"), *as_root, f"--root={root}", f"--wd={inside[0]}", inside[1]]

    def answer(self, words):
        done = subprocess.run([*self.command, *words], cwd=self.corpus, env={}, capture_output=True)
        return done.returncode, done.stdout, done.stderr


def check_same(words, one, other):
    answers = one.answer(words), other.answer(words)
    expect(answers[0] == answers[1], f"{' '.join(words)[:200]}: {answers[0][0]} and {answers[1][0]}, {answers[0][2][:500]} and {answers[1][2][:500]}, "
           f"{len(answers[0][1])} and {len(answers[1][1])} bytes")
    status, output, _ = answers[0]
    expect(status in (0, 1) and output, f"{' '.join(words)[:200]}: exit status {status}, {len(output)} bytes")
    print(f"{' '.join(words)[:70]}: the same {len(output)} bytes", flush=True)


def main():
    folder = unpacked()
    program, corpus = folder / "bin/touchstone", folder / CORPUS
    check_needs_nothing(program)
    licences = folder / "share/doc/Touchstone/program"
    packages = re.findall(r"^  .*  (\S+-dev) ", (licences / "LICENSES").read_text(), re.MULTILINE)
    notices = [notice.name for notice in (licences / "libraries").iterdir()]
    expect((licences / "LICENSE-GPL").exists() and len(packages) > 5 and sorted(packages) == sorted(notices),
           f"LICENSES names {packages}, the notices are of {notices}")

    # From here on all answers are compared with those of the ordinary program.
    ordinary, placed = Program(ORDINARY, corpus), Program(program, corpus)
    alone = placed if EMULATOR else Program(program, corpus, folder.parent)
    floats = sorted(str(file.relative_to(corpus)) for file in corpus.glob("floats/*.jsonl"))
    doubles = sorted(file.name for file in corpus.glob("*.jsonl"))
    expect(len(floats) > 10 and len(doubles) > 10, f"the archive has the cases {floats} and {doubles}")
    check_same([*BALL, *TRIANGLE], ordinary, alone)
    check_same([*BALL, "--to", "0,0,0", *TRIANGLE], ordinary, alone)
    check_same(["judge", "--methods", EVERYWHERE, *floats], ordinary, alone)
    if not EMULATOR:
        shared = re.findall(rb"^\S+", placed.answer(["methods"])[1], re.MULTILINE)
        expect(len(shared) > 20, f"the program has the methods {shared}")
        check_same(["judge", "--methods", b",".join(shared).decode(), *floats, *doubles], ordinary, alone)
        check_same(["cases", "--samples", "50", "--expected"], ordinary, alone)
        check_same(["corpus", "check"], ordinary, alone)

    (SCRATCH / "engine.py").write_text(re.search(r"```python\n(.*?)```", (SOURCE / "docs/engines.md").read_text(), re.DOTALL)[1])
    engine = f"python3 {SCRATCH}/engine.py=vertices"
    check_same(["judge", "--engine", engine, "--at-rest", "--keys", "contact", "face.jsonl"], ordinary, placed)


if __name__ == "__main__":
    main()
