#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the studies of studies/, each in its folder of RESULTS; called from the project's folder. Skips studies that the same
program has finished with the same arguments.
"""
import argparse
import fcntl
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

from replacing import replacing
from studies import DRIVE, MESHES, OUTPUT, modules, shown

MARK = "reproduce.json"  # in a study's folder: how it was begun, by which program, and whether it has come to its end
INTERRUPTED = 130


def meshes():
    return sorted(str(path) for path in pathlib.Path("cache/meshes").rglob("*") if path.is_file())


def checksum(paths):
    digest = hashlib.sha256()
    for path in paths:
        digest.update(pathlib.Path(path).read_bytes())
    return digest.hexdigest()


class Folder:
    """Of one study: what was begun there, and what is to be done."""

    def __init__(self, path, study, program):
        self.path, self.study = path, study
        self.program = {"program": checksum([program]), "meshes": checksum(meshes()) if study.needs_meshes else ""}
        try:
            self.mark = json.loads((path / MARK).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            self.mark = {}

    def settings(self, mode):
        return self.program | {"calls": [shown(call, self.path.name) for call in self.study.calls(mode)]}

    def begun(self, mode):
        return self.mark == self.settings(mode) | {"done": self.mark.get("done")}

    def done(self, mode):
        return self.begun(mode) and self.mark["done"] and (self.path / "run.json").exists()

    def foreign(self):
        """Not made here: nothing may be removed or written over."""
        return not self.mark and self.path.exists() and any(self.path.iterdir())

    def begin(self, mode):
        """Nothing of another run is left among the results."""
        if self.mark:
            shutil.rmtree(self.path)
        self.path.mkdir(parents=True, exist_ok=True)
        self.write(self.settings(mode) | {"done": False})

    def end(self):
        self.write(self.mark | {"done": True})

    def write(self, mark):
        self.mark = mark
        with replacing(self.path / MARK) as file:
            file.write_text(json.dumps(mark, indent=1) + "\n", encoding="utf-8")


def status_of(command, lock):
    """Keeps the lock for as long as the command runs, even if this process is killed. An interrupt is for the command, which
    saves what it has."""
    process = subprocess.Popen(command, pass_fds=[lock.fileno()])
    while True:
        try:
            return process.wait()
        except KeyboardInterrupt:
            pass


def run(program, study, path, mode, lock):
    folder = Folder(path, study, program)
    if folder.done(mode) or folder.done("full"):
        print("Already done.", flush=True)
        return 0
    if mode != "full" and folder.begun("full"):
        print("Begun with --full, and unfinished: ./reproduce --full continues it.", flush=True)
        return 0
    if folder.foreign():
        print(f"run_studies.py: {path}: has files that ./reproduce did not make; move it away, or give ./reproduce another --output",
              file=sys.stderr)
        return 2
    folder.begin(mode)
    for call in study.calls(mode):
        options = ["--force"] if "--output" in call else []  # the folder holds the mark
        words = [word for each in call for word in (meshes() if each == MESHES else [each.replace(OUTPUT, str(path))])]
        status = status_of([program, *words, *options], lock)
        if status and not (status == 1 and DRIVE in call):
            return status
    folder.end()
    return 0


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", metavar="TOUCHSTONE")
    parser.add_argument("results", metavar="RESULTS", type=pathlib.Path)
    parser.add_argument("--full", action="store_const", const="full", dest="mode", default="quick")
    parser.add_argument("--paper", action="store_true")
    parser.add_argument("--first-study", metavar="PROGRAM", help="runs the study that can be built first, instead of TOUCHSTONE")
    parser.add_argument("--only-first", action="store_true", help="run that study alone")
    return parser.parse_args()


def main():
    asked = arguments()
    program, results = asked.program, asked.results
    mode = "paper" if asked.paper and asked.mode == "quick" else asked.mode
    results.mkdir(parents=True, exist_ok=True)
    lock = open(results / "lock", "w", opener=lambda path, flags: os.open(path, flags | os.O_NOFOLLOW, 0o666))
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        sys.exit(f"run_studies.py: another run is working in {results}")
    if not asked.only_first:
        methods = subprocess.run([program, "methods"], check=True, capture_output=True, text=True).stdout
        with replacing(results / "methods.txt") as file:
            file.write_text(methods, encoding="utf-8")
    begin, failed = time.monotonic(), []
    for name, module in modules().items():
        study = module.RUN
        if not study.calls(mode) or (asked.only_first and not study.first):
            continue
        print(f"\n== {name}: {study.about} (after {time.monotonic() - begin:.0f} s of studies)", flush=True)
        if study.needs_meshes and not meshes():
            print("Skipped: there are no meshes in cache/meshes.")
            continue
        status = run(asked.first_study if study.first and asked.first_study else program, study, results / name, mode, lock)
        if status == INTERRUPTED:
            print("run_studies.py: interrupted; run it again to continue", file=sys.stderr)
            return INTERRUPTED
        if status:
            print(f"run_studies.py: {name}: exit status {status}", file=sys.stderr)
            failed.append(name)
    if failed:
        print(f"run_studies.py: failed: {', '.join(failed)}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
