# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: same_bytes.py TOUCHSTONE

Data files depend on the settings alone. Runs each study at once; interrupted (SIGINT) or killed (SIGKILL) behind a
checkpoint and resumed; and by parts, one of which is interrupted and one killed before they are moved and merged. All
data files must be the same. Parts that do not belong together are an error that names their folder and the reason. Exit
status 1 otherwise.
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

from running import expect, run

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
TIMES = {"timings.csv", "front.csv", "cost.csv"}
WHOLE = {"front.csv", "cost.csv"}  # of times that an interrupted run has not taken
PATIENCE = 60  # seconds, for what takes one or two


def data(folder):
    """The contents of the data files."""
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()
            if path.name != "run.json" and path.name not in TIMES}


def compare(what, wanted, folder):
    found = data(folder)
    expect(wanted.keys() == found.keys(), f"{what}: other files: {sorted(wanted.keys() ^ found.keys())}")
    for name, content in wanted.items():
        expect(found[name] == content, f"{what}: {name} differs")


def end_behind_a_checkpoint(command, folder, end):
    """Sends a signal to the run as soon as there is a checkpoint with something in it.

    Returns the exit status and how much the checkpoint then holds."""
    checkpoint = pathlib.Path(folder) / "checkpoint.json"
    running = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + PATIENCE
    while not (checkpoint.exists() and json.loads(checkpoint.read_text())["done"] > 0):
        expect(running.poll() is None, f"{' '.join(command)}: ended by itself")
        if time.monotonic() > deadline:
            running.kill()
            expect(False, f"{' '.join(command)}: no checkpoint after {PATIENCE} s")
        os.sched_yield()
    os.kill(running.pid, end)
    running.wait(PATIENCE)
    return running.returncode, json.loads(checkpoint.read_text())["done"]


def require_interrupted(what, folder, wanted):
    told = json.loads(pathlib.Path(f"{folder}/run.json").read_text()).get("interrupted")
    expect(told == wanted, f"{what}: run.json says interrupted: {told}")


def end_and_resume(what, command, folder, end, share):
    """Ends the run, which has so many items, by a signal, and resumes it."""
    status, done = end_behind_a_checkpoint(command + ["--output", folder], folder, end)
    what = f"{what}, ended by {end.name}"
    expect(status == (130 if end == signal.SIGINT else -end), f"{what}: exit status {status}")
    expect(0 < done < share, f"{what}: when {done} of {share} were done")
    if end == signal.SIGINT:
        require_interrupted(what, folder, True)
        expect(not WHOLE.intersection(os.listdir(folder)), f"{what}: it has a table of whole runs")
    run(*command, "--output", folder, "--resume")
    require_interrupted(f"{what} and resumed", folder, False)
    print(f"{what} at {done} of {share}: resumed")


def check(study, program, folder):
    command = [program] + STUDIES[study]
    items = int(command[-1]) * (3 if study == "stability" else 1)  # blocks of three axes
    alone = run(*command, "--output", f"{folder}/alone")
    expect(not alone.stderr, f"{study} says: {alone.stderr}")
    wanted = data(f"{folder}/alone")
    for end in (signal.SIGINT, signal.SIGKILL):
        end_and_resume(study, command, f"{folder}/{end.name}", end, items)
        compare(f"{study}, ended by {end.name} and resumed", wanted, f"{folder}/{end.name}")
    parts = [f"{folder}/part-{number}" for number in (1, 2, 3)]
    for number, (part, end) in enumerate(zip(parts, (signal.SIGINT, signal.SIGKILL, None)), 1):
        of_part = command + ["--part", f"{number}/3"]
        if end:
            end_and_resume(f"part {number} of {study}", of_part, part, end, items // 3)
        else:
            run(*of_part, "--output", part)
    pathlib.Path(f"{folder}/elsewhere").mkdir()
    os.rename(parts[0], f"{folder}/elsewhere/one")
    run(program, "merge", parts[2], f"{folder}/elsewhere/one", parts[1], "--output", f"{folder}/merged", "--threads", "2")
    compare(f"{study}, merged", wanted, f"{folder}/merged")
    record = json.loads(pathlib.Path(f"{folder}/merged/run.json").read_text())
    expect(record["parts"] == 3 and record["samples_done"] == record["samples_asked"], f"{study}, merged: run.json says {record}")


def check_refusals(program, folder):
    """Parts that are missing, doubled, unfinished or foreign."""
    def part(name, *options, study="soak", samples="900"):
        run(program, study, "--samples", samples, "--seed", "5", "--output", f"{folder}/{name}", *options)

    def refused(reason, *names, output="merged"):
        said = run(program, "merge", *(f"{folder}/{name}" for name in names), "--output", f"{folder}/{output}", "--force", expected=2).stderr
        expect(said == f"touchstone: {reason.replace('FOLDER', folder)}\n", f"merge of {names} says: {said}")
        expect(not pathlib.Path(f"{folder}/merged").exists(), f"merge of {names} has written something")

    part("one", "--part", "1/2")
    part("two", "--part", "2/2")
    part("whole")
    part("three", "--part", "3/3")
    part("moving", "--part", "2/2", "--moving")
    part("fewer", "--part", "2/2", samples="800")
    part("other", "--part", "2/2", study="tunnelling")
    refused("part 2/2 of soak is missing", "one")
    refused("FOLDER/one: is part 1/2, as FOLDER/one is", "one", "two", "one")
    refused("FOLDER/three: is part 3/3, unlike FOLDER/one, which is part 1/2", "three", "one")
    refused("FOLDER/whole: is not of a part: its run.json names none", "one", "whole")
    refused("FOLDER/none: has no run.json, so its part has not ended; --resume continues it", "one", "none")
    refused("FOLDER/moving/checkpoint.json: is of --moving yes, not of --moving no", "one", "moving")
    refused("FOLDER/fewer/checkpoint.json: is of --part 2/2 of 800 items, not of --part 2/2 of 900 items", "one", "fewer")
    refused("FOLDER/other: is of tunnelling, unlike FOLDER/one, which is of soak", "one", "other")
    refused("FOLDER/two: is a part, so it cannot be the output", "one", "two", output="two")
    state = pathlib.Path(f"{folder}/two/checkpoint.json")
    whole = state.read_text()
    for text, reason in ((whole.replace('"version":', '"version":1'), "is of another version of this program"),
                         (whole[:-9], "is not a checkpoint of this program: ")):
        state.write_text(text)
        said = run(program, "merge", f"{folder}/one", f"{folder}/two", "--output", f"{folder}/merged", expected=2).stderr
        expect(f"{folder}/two/checkpoint.json: {reason}" in said, f"merge of another checkpoint says: {said}")
    state.write_text(whole)
    run(program, "merge", f"{folder}/one", f"{folder}/two", "--output", f"{folder}/merged")
    compare("soak, merged", data(f"{folder}/whole"), f"{folder}/merged")


def main(program):
    signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background of a shell it is ignored, also by children
    with tempfile.TemporaryDirectory() as folder:
        check_refusals(program, f"{folder}/refusals")
        for study in STUDIES:
            check(study, program, f"{folder}/{study}")


if __name__ == "__main__":
    main(*sys.argv[1:])
