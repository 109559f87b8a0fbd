# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: reproduce.py ROOT

./reproduce configures before it builds, each time: what was installed since is found. It builds the program of the first
study before the whole one, and names that study's picture unless the study failed. Programs that take long are replaced
by such as note their call. Exit status 1 otherwise."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

NOTES = '#!/bin/sh\necho "$(basename "$0") $*" >> "$CALLS"\n'


def reproduce(folder):
    """Returns what CMake was called with, and what the user is told to look at."""
    calls = folder / "calls"
    calls.unlink(missing_ok=True)
    done = subprocess.run([folder / "reproduce", "--no-install"], capture_output=True, text=True,
                          env=dict(os.environ, CALLS=str(calls), PATH=f"{folder}/bin:{os.environ['PATH']}"))
    return ([call for call in calls.read_text().splitlines() if call.startswith("cmake ")],
            re.findall("look at ([^ ]*)", done.stdout))


def main(root):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for path in ("bin", ".ci", "experiments/studies/meshes", "experiments/report", "build/release"):
            (folder / path).mkdir(parents=True)
        shutil.copy(pathlib.Path(root, "reproduce"), folder)
        for program in ("bin/cmake", "experiments/studies/meshes/fetch"):
            (folder / program).write_text(NOTES)
            (folder / program).chmod(0o755)
        for script in ("run_studies.py", "report.py"):
            (folder / "experiments/report" / script).write_text("")
        (folder / ".ci/packages").write_text("need_packages() { :; }\n")
        builds = [f"cmake --build build/release --target {target}" for target in ("first_study", "touchstone")]
        wanted = {"at first": ["cmake --preset release -DTOUCHSTONE_TESTS=OFF", *builds],
                  "again": ["cmake --preset release", *builds]}  # which keeps tests that a developer has
        for when, calls in wanted.items():
            found = reproduce(folder)
            if found != (calls, ["results/near-edge/maps-reflex-vertex.png"]):
                print(f"./reproduce, {when}: {found}, not {calls} and the first picture")
                return 1
            (folder / "build/release/build.ninja").write_text("")
        (folder / "experiments/report/run_studies.py").write_text("raise SystemExit(1)")
        if found := reproduce(folder)[1]:
            print(f"./reproduce names {found} of a study that failed")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
