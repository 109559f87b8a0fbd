# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: plan.py TOUCHSTONE

Runs the plan of two studies by Debian's Snakemake on two cores, kills a part behind a checkpoint, and runs the plan
again: the part continues, parts that had ended are not run again, and the data files are those of one run. Exit status
1 otherwise.
"""

import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

from running import Failure, expect, run
from same_bytes import compare, data

STUDIES = {"soak": ["--samples", "40000", "--seed", "5"],
           "tunnelling": ["--vertices", "6", "--seed", "5", "--repetitions", "1", "--no-pictures", "--samples", "2000"]}
PARTS = 3
PATIENCE = 120  # seconds, for what takes a few


def start(program, folder):
    with open(folder / "log", "a") as log:
        return subprocess.Popen(["snakemake", "--cores", "2", "--config", f"touchstone={program}"], cwd=folder, stdout=log, stderr=log,
                                stdin=subprocess.DEVNULL, env=dict(os.environ, XDG_CACHE_HOME=str(folder / "cache")))


def kill_a_part(running, folder):
    """Kills the run of the first part of soak that has a checkpoint with something in it, and returns its folder."""
    deadline = time.monotonic() + PATIENCE
    while running.poll() is None and time.monotonic() < deadline:
        for checkpoint in folder.glob("parts/soak/*/checkpoint.json"):
            try:
                holder = (checkpoint.parent / ".lock").read_text()
                if '"done":0,' not in checkpoint.read_text():
                    os.kill(int(re.match(r"process (\d+) ", holder)[1]), signal.SIGKILL)
                    return checkpoint.parent
            except (FileNotFoundError, TypeError, ProcessLookupError):  # it has just begun or ended
                continue
        os.sched_yield()
    raise Failure("no part could be killed")


def check(program, folder):
    plan = run(program, "plan", "--parts", PARTS, *(" ".join([study, *options]) for study, options in STUDIES.items()))
    (folder / "Snakefile").write_text(plan.stdout)
    running = start(program, folder)
    killed = kill_a_part(running, folder)
    expect(running.wait(PATIENCE) != 0 and not (killed / "run.json").exists() and not (folder / "soak").exists(),
           "the plan goes on although a part was killed")
    ended = {path: path.read_bytes() for path in folder.glob("parts/*/*/run.json")}
    expect(start(program, folder).wait(PATIENCE) == 0, "the plan fails when it is run again")
    expect(all(path.read_bytes() == record for path, record in ended.items()), "a part that had ended was run again")
    for study, options in STUDIES.items():
        run(program, study, *options, "--output", f"{folder}/whole/{study}")
        compare(f"{study} by parts", data(folder / "whole" / study), folder / study)
    print(f"{killed.relative_to(folder)} was killed and resumed, {len(ended)} parts had ended: the same bytes")


def main(program):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        try:
            check(os.path.abspath(program), folder)
        except (Failure, subprocess.TimeoutExpired) as failure:
            print(failure, (folder / "log").read_text() if (folder / "log").exists() else "", sep="\n")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
