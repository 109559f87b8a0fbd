# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python3 agrees.py TOUCHSTONE SEED COUNT

Draws unseen cases, has `touchstone judge --methods exact` answer them, and holds its verdicts against the checker's own.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent


def main(touchstone, seed, count):
    environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1")
    with tempfile.TemporaryDirectory() as folder:
        cases = pathlib.Path(folder, "cases.jsonl")
        verdicts = pathlib.Path(folder, "verdicts.jsonl")
        with cases.open("w") as out:
            subprocess.run([sys.executable, HERE / "unseen_cases.py", "--seed", seed, "--count", count],
                           stdout=out, check=True, env=environment)
        with verdicts.open("w") as out:
            # Exit status 2: some of the cases are rejected, as they should be.
            subprocess.run([touchstone, "judge", "--methods", "exact", cases], stdout=out, stderr=subprocess.DEVNULL)
        return subprocess.run([sys.executable, HERE / "checker.py", cases, verdicts], env=environment).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
