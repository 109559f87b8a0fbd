# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: same_bytes.py TOUCHSTONE

Data files depend on the settings alone. Runs each study at once and by parts, which are moved and merged: all data files
must be the same. Parts that are missing, interrupted, edited or of other settings are an error that names their folder and
the reason. Exit status 1 otherwise.
"""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

from running import expect, run

STUDIES = {
    "near-edge": ["near-edge", "--methods", "fast,thesis", "--families", "u", "--seed", "5", "--search", "4",
                  "--no-pictures", "--threads", "1", "--samples", "21"],
    "soak": ["soak", "--seed", "5", "--threads", "1", "--samples", "20000"],
    "motions": ["motions", "--methods", "fast,cgal-double-distance", "--vertices", "6", "--seed", "5", "--no-pictures",
                "--threads", "1", "--samples", "20", "--passes", "2000", "--repetitions", "1"],
    "tradeoff": ["tradeoff", "--methods", "fast,thesis,interval,exact", "--families", "u", "--seed", "5",
                 "--queries", "1", "--repetitions", "1", "--no-pictures", "--threads", "1", "--samples", "60"],
    "stability": ["stability", "--methods", "fast,thesis", "--axes", "aspect,origin,mixed", "--seed", "5",
                  "--no-pictures", "--threads", "1", "--samples", "60"],
}
TIMES = {"timings.csv", "front.csv", "steps-cost.csv"}
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


def check(study, program, folder):
    command = [program] + STUDIES[study]
    alone = run(*command, "--output", f"{folder}/alone")
    expect(not alone.stderr, f"{study} says: {alone.stderr}")
    parts = [f"{folder}/part-{number}" for number in (1, 2, 3)]
    for number, part in enumerate(parts, 1):
        run(*command, "--part", f"{number}/3", "--output", part)
    pathlib.Path(f"{folder}/elsewhere").mkdir()
    os.rename(parts[0], f"{folder}/elsewhere/one")
    run(program, "merge", parts[2], f"{folder}/elsewhere/one", parts[1], "--output", f"{folder}/merged", "--threads", "2")
    compare(f"{study}, merged", data(f"{folder}/alone"), f"{folder}/merged")
    record = json.loads(pathlib.Path(f"{folder}/merged/run.json").read_text())
    expect(record["parts"] == 3 and record["samples_done"] == record["samples_asked"], f"{study}, merged: run.json says {record}")


def catches_interruption(process):
    """True once the process has a handler for SIGINT, which it installs after it has locked its folder."""
    caught = re.search(r"^SigCgt:\s*(\w+)$", pathlib.Path(f"/proc/{process}/status").read_text(), re.MULTILINE)
    return bool(int(caught[1], 16) >> (signal.SIGINT - 1) & 1)


def check_interruption(program, folder):
    """An interrupted run ends with status 130, keeps what it found, and says so; an interrupted part keeps nothing."""
    soak = [program, "soak", "--samples", "100000000", "--threads", "1"]
    for name, options, kept in (("whole", [], True), ("part", ["--part", "1/2"], False)):
        running = subprocess.Popen([*soak, *options, "--output", f"{folder}/{name}"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        while not pathlib.Path(f"{folder}/{name}/.lock").exists() or not catches_interruption(running.pid):
            os.sched_yield()
        running.send_signal(signal.SIGINT)
        expect(b"interrupted" in running.communicate(timeout=PATIENCE)[1] and running.returncode == 130, f"{name}: status {running.returncode}")
        record = json.loads(pathlib.Path(f"{folder}/{name}/run.json").read_text())
        expect(record["interrupted"] and record["samples_done"] < record["samples_asked"], f"{name}: run.json says {record}")
        expect(pathlib.Path(f"{folder}/{name}/soak.csv").exists() == kept, f"{name}: tables")
        expect(not pathlib.Path(f"{folder}/{name}/part.json").exists(), f"{name}: it has the sum of a part")


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
    part("other", "--part", "2/2", "--methods", "fast", "--passes", "2", study="motions", samples="2")
    refused("part 2/2 of soak is missing", "one")
    refused("FOLDER/one: is part 1/2, as FOLDER/one is", "one", "two", "one")
    refused("FOLDER/three: is part 3/3, unlike FOLDER/one, which is part 1/2", "three", "one")
    refused("FOLDER/whole: is not of a part: its run.json names none", "one", "whole")
    refused("FOLDER/none: has no run.json: its part has not ended, so run it again", "one", "none")
    refused("FOLDER/moving/part.json: is of --moving yes, not of --moving no", "one", "moving")
    refused("FOLDER/fewer/part.json: is of --part 2/2 of 800 items, not of --part 2/2 of 900 items", "one", "fewer")
    refused("FOLDER/other: is of motions, unlike FOLDER/one, which is of soak", "one", "other")
    refused("FOLDER/two: is a part, so it cannot be the output", "one", "two", output="two")
    state = pathlib.Path(f"{folder}/two/part.json")
    whole = state.read_text()
    for text, reason in ((whole.replace('"version":', '"version":1'), "is of another version of this program"),
                         (whole[:-9], "is not of a part of this program: ")):
        state.write_text(text)
        said = run(program, "merge", f"{folder}/one", f"{folder}/two", "--output", f"{folder}/merged", expected=2).stderr
        expect(f"{folder}/two/part.json: {reason}" in said, f"merge of another sum says: {said}")
    state.write_text(whole)
    run(program, "merge", f"{folder}/one", f"{folder}/two", "--output", f"{folder}/merged")
    compare("soak, merged", data(f"{folder}/whole"), f"{folder}/merged")


def main(program):
    signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background of a shell it is ignored, also by children
    with tempfile.TemporaryDirectory() as folder:
        check_refusals(program, f"{folder}/refusals")
        check_interruption(program, f"{folder}/interrupted")
        for study in STUDIES:
            check(study, program, f"{folder}/{study}")


if __name__ == "__main__":
    main(*sys.argv[1:])
