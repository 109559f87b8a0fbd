# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: same_bytes.py TOUCHSTONE [TOGETHER MPIRUN]

Data files depend on the settings alone. Runs each study in one process, then under MPIRUN in 1, 2 and 4, and
interrupted (SIGINT) or killed (SIGKILL) behind a checkpoint and resumed, alone and under MPIRUN: all their data files
must be the same. One process alone must say nothing of MPI; under MPIRUN, one's error must end all, and commands for
one process must refuse to run in more. Exit status 1 otherwise.
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

STUDIES = {
    "near-edge": ["near-edge", "--methods", "fast,thesis", "--families", "u", "--seed", "5", "--search", "4",
                  "--oracle", "filtered", "--no-pictures", "--threads", "1", "--samples", "201"],
    "soak": ["soak", "--seed", "5", "--threads", "1", "--samples", "20000"],
    "motions": ["motions", "--methods", "fast,cgal-double-distance", "--vertices", "6", "--seed", "5", "--no-pictures",
                "--threads", "1", "--samples", "20"],
    "tunnelling": ["tunnelling", "--vertices", "6", "--seed", "5", "--repetitions", "1", "--no-pictures", "--threads", "1",
                   "--samples", "4000"],
    "tradeoff": ["tradeoff", "--methods", "fast,thesis,interval,exact", "--families", "u", "--seed", "5",
                 "--queries", "1", "--repetitions", "1", "--no-pictures", "--threads", "1", "--samples", "60"],
    "stability": ["stability", "--methods", "fast,thesis", "--axes", "aspect,origin,mixed", "--seed", "5",
                  "--no-pictures", "--threads", "1", "--samples", "60"],
}
TIMES = {"timings.csv", "front.csv", "cost.csv"}  # which one process alone measures
PATIENCE = 60  # seconds, for what takes one or two


class Failure(Exception):
    pass


def launcher(mpirun, processes):
    return [mpirun, "--allow-run-as-root", "--oversubscribe", "-n", str(processes)] if processes else []


def environment():
    # Leaks of the MPI library are not ours.
    return dict(os.environ, ASAN_OPTIONS="detect_leaks=0", OMPI_MCA_rmaps_base_oversubscribe="1")


def run(command, expected=0):
    done = subprocess.run(command, capture_output=True, text=True, env=environment(), timeout=4 * PATIENCE)
    if done.returncode != expected:
        raise Failure(f"{' '.join(command)}: exit status {done.returncode}\n{done.stdout[-300:]}{done.stderr[-900:]}")
    return done


def data(folder):
    """The contents of the data files."""
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()
            if path.name != "run.json" and path.name not in TIMES}


def compare(what, wanted, folder):
    found = data(folder)
    if wanted.keys() != found.keys():
        raise Failure(f"{what}: other files: {sorted(wanted.keys() ^ found.keys())}")
    for name, content in wanted.items():
        if found[name] != content:
            raise Failure(f"{what}: {name} differs")


def processes_of(parent, program):
    """Those of `program` that descend from a process."""
    listed = subprocess.run(["ps", "-e", "-o", "pid=,ppid=,args="], check=True, capture_output=True, text=True).stdout
    lines = [line.split(None, 2) for line in listed.splitlines()]
    found, parents = [], {str(parent)}
    while parents:
        children = [line for line in lines if line[1] in parents]
        found += [int(pid) for pid, _, arguments in children if arguments.split()[0] == program]
        parents = {pid for pid, _, _ in children}
    return found


def end_behind_a_checkpoint(program, command, folder, end):
    """Sends a signal to the last process of the program as soon as there is a checkpoint with something in it.

    Returns the exit status and how much the checkpoint then holds."""
    checkpoint = pathlib.Path(folder) / "checkpoint.json"
    running = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment())
    deadline = time.monotonic() + PATIENCE
    while not (checkpoint.exists() and json.loads(checkpoint.read_text())["done"] > 0):
        if running.poll() is not None:
            raise Failure(f"{' '.join(command)}: ended by itself")
        if time.monotonic() > deadline:
            running.kill()
            raise Failure(f"{' '.join(command)}: no checkpoint after {PATIENCE} s")
        os.sched_yield()
    os.kill(running.pid if command[0] == program else processes_of(running.pid, program)[-1], end)
    running.wait(PATIENCE)
    return running.returncode, json.loads(checkpoint.read_text())["done"]


def require_interrupted(what, folder, wanted):
    told = json.loads(pathlib.Path(f"{folder}/run.json").read_text()).get("interrupted")
    if told != wanted:
        raise Failure(f"{what}: run.json says interrupted: {told}")


def check(study, program, mpirun, folder):
    command = [program] + STUDIES[study]
    asked = int(command[-1])
    alone = run(command + ["--output", f"{folder}/alone"])
    if alone.stderr:
        raise Failure(f"{study} alone says: {alone.stderr}")
    wanted = data(f"{folder}/alone")
    counts = [0, 1, 2, 4] if mpirun else [0]
    for count in counts[1:]:
        run(launcher(mpirun, count) + command + ["--output", f"{folder}/{count}"])
        compare(f"{study} in {count} processes", wanted, f"{folder}/{count}")
        record = json.loads(pathlib.Path(f"{folder}/{count}/run.json").read_text())
        if record["processes"] != count:
            raise Failure(f"{study} in {count} processes: run.json says {record['processes']}")
    ends = [(0, signal.SIGINT, 130), (0, signal.SIGKILL, -signal.SIGKILL)] + ([(2, signal.SIGINT, None), (4, signal.SIGKILL, None)] if mpirun else [])
    for number, (count, end, expected) in enumerate(ends):
        part = f"{folder}/part-{number}"
        what = f"{study}, ended by {end.name} in {count or 1} processes"
        status, done = end_behind_a_checkpoint(program, launcher(mpirun, count) + command + ["--output", part], part,
                                               end)
        if status == 0 or expected not in (None, status):
            raise Failure(f"{what}: exit status {status}")
        if not 0 < done < asked * (3 if study == "stability" else 1):  # blocks of three axes
            raise Failure(f"{what}: when {done} of {asked} were done")
        if end == signal.SIGINT:
            require_interrupted(what, part, True)
        # Gone on with another number of processes than before.
        run((launcher(mpirun, 2) if mpirun and count == 0 else []) + command + ["--output", part, "--resume"])
        compare(f"{what} and resumed", wanted, part)
        require_interrupted(f"{what} and resumed", part, False)
        print(f"{what} at {done} of {asked}: resumed, the same bytes")
    if mpirun:  # found out by the first process alone
        refused = run(launcher(mpirun, 3) + command + ["--output", "/dev/null/folder"], expected=2)
        if "process 0 of 3: /dev/null/folder: cannot be made" not in refused.stderr:
            raise Failure(f"{study}: the error of one process is not told: {refused.stderr}")


def check_processes(together, mpirun):
    """What they tell each other; and one's error, in the middle of its work, ends all."""
    told = run(launcher(mpirun, 3) + [together]).stdout
    wanted = ("largest 4, first 7, first xxx, gathered 1000000 2000000\n"
              "stopped, the first items, agreed\n")
    if told != wanted:
        raise Failure(f"three processes tell: {told}")
    failed = run(launcher(mpirun, 4) + [together, "2"], expected=2)
    if "process 2 of 4: item beyond 500" not in failed.stderr:
        raise Failure(f"the error of one process is not told: {failed.stderr}")


def check_alone(program, mpirun, folder):
    """Commands that know of no other processes refuse them, and write nothing."""
    for command in ["meshes", "bench"]:
        asked = ["no-such-mesh.stl"] if command == "meshes" else []
        asked += ["--output", f"{folder}/{command}"]
        refused = run(launcher(mpirun, 2) + [program, command] + asked, expected=2)
        if "this command works in one process only" not in refused.stderr:
            raise Failure(f"{command} in 2 processes says: {refused.stderr}")
        if pathlib.Path(folder).exists():
            raise Failure(f"{command} in 2 processes has begun")


def main(program, together=None, mpirun=None):
    signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background of a shell it is ignored, also by children
    with tempfile.TemporaryDirectory() as folder:
        try:
            if mpirun:
                check_processes(together, mpirun)
                check_alone(program, mpirun, f"{folder}/alone")
            for study in STUDIES:
                check(study, program, mpirun, f"{folder}/{study}")
        except Failure as failure:
            print(failure)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
