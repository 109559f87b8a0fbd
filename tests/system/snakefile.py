# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: snakefile.py TOUCHSTONE SOURCE

experiments/Snakefile runs studies and a judgement by parts on two cores with Debian's Snakemake. The data are those of one
run, and a part that was killed runs again. Exit status 1 otherwise.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

from running import Failure, expect, run
from same_bytes import compare, data

STUDIES = {"soak": ["--samples", "4000", "--seed", "5"],
           "motions": ["--methods", "filtered,fast", "--vertices", "6", "--seed", "5", "--samples", "3", "--passes", "200", "--repetitions", "1", "--no-pictures"]}
PATIENCE = 300  # seconds, for what takes a few
# Kills the program that runs the second part, once.
KILLED = """#!/bin/sh
case "$*" in *" 2/3 "*) [ -e killed ] || { touch killed; kill -9 $$; } ;; esac
exec 'PROGRAM' "$@"
"""


def snakemake(source, folder, program, command, output):
    done = subprocess.run(["snakemake", "-s", source / "experiments/Snakefile", "--cores", "2", "--config", f"touchstone={program}",
                           f"run={command}", "parts=3", f"output={output}"], cwd=folder, capture_output=True, text=True,
                          stdin=subprocess.DEVNULL, env=dict(os.environ, XDG_CACHE_HOME=str(folder / "cache")), timeout=PATIENCE)
    return done.returncode, done.stdout + done.stderr


def check(program, source, folder):
    dying = folder / "dying"
    dying.write_text(KILLED.replace("PROGRAM", program))
    dying.chmod(0o755)
    for study, options in STUDIES.items():
        command = " ".join([study, *options])
        status, said = snakemake(source, folder, dying, command, study)
        expect((status != 0) == (study == "soak"), f"a part was killed once alone: {said}")
        status, said = snakemake(source, folder, dying, command, study)
        expect(status == 0, said)
        run(program, study, *options, "--output", f"{folder}/whole/{study}")
        compare(f"{study} by parts", data(folder / "whole" / study), folder / study)
    cases = run(program, "cases", "--family", "u", "--ball", "near-edge", "--expected", "--samples", "40").stdout
    (folder / "cases.jsonl").write_text(cases)
    status, said = snakemake(source, folder, program, "judge cases.jsonl --methods thesis --keys contact", "judged")
    expect(status == 0, said)
    whole = run(program, "judge", f"{folder}/cases.jsonl", "--methods", "thesis", "--keys", "contact", expected=1).stdout
    expect((folder / "judged.txt").read_text() == whole, "the judgement by parts differs")


def main(program, source):
    with tempfile.TemporaryDirectory() as name:
        try:
            check(os.path.abspath(program), pathlib.Path(source).resolve(), pathlib.Path(name))
        except (Failure, subprocess.TimeoutExpired) as failure:
            print(failure)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
