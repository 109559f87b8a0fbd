# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python3 agrees.py TOUCHSTONE SEED COUNT

Draws unseen cases, has `touchstone judge --methods exact` answer them, and holds its verdicts against the checker's own.
"""

import pathlib
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
sys.path.append(str(HERE.parent))
from running import run  # noqa: E402


def main(touchstone, seed, count):
    with tempfile.TemporaryDirectory() as folder:
        cases, verdicts = pathlib.Path(folder, "cases.jsonl"), pathlib.Path(folder, "verdicts.jsonl")
        cases.write_text(run(sys.executable, "-B", HERE / "unseen_cases.py", "--seed", seed, "--count", count).stdout)
        # Exit status 2: some of the cases are rejected, as they should be.
        verdicts.write_text(run(touchstone, "judge", "--methods", "exact", cases, expected=2).stdout)
        print(run(sys.executable, "-B", HERE / "checker.py", cases, verdicts).stdout, end="")


if __name__ == "__main__":
    main(*sys.argv[1:])
