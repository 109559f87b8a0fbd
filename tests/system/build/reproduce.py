# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: reproduce.py ROOT

./reproduce configures before it builds, each time: what was installed since is found. It builds the program of the first
study before the whole one. Programs that take long are replaced
by such as note their call. Exit status 1 otherwise."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

NOTES = '#!/bin/sh\necho "$(basename "$0") $*" >> "$CALLS"\n'


def calls_of(folder):
    calls = folder / "calls"
    calls.unlink(missing_ok=True)
    subprocess.run([folder / "reproduce", "--no-install"], check=True, stdout=subprocess.DEVNULL,
                   env=dict(os.environ, CALLS=str(calls), PATH=f"{folder}/bin:{os.environ['PATH']}"))
    return [call for call in calls.read_text().splitlines() if call.startswith("cmake ")]


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
            found = calls_of(folder)
            if found != calls:
                print(f"./reproduce, {when}: {found}, not {calls}")
                return 1
            (folder / "build/release/build.ninja").write_text("")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
