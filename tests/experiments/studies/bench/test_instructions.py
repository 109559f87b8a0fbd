# SPDX-License-Identifier: GPL-3.0-or-later
"""Instructions a query are held against a baseline: what has grown is named, and ends with status 1."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[4]
# Counts as valgrind prints them, 1000 to begin with and `price` a query; ten queries each time.
VALGRIND = """#!/bin/sh
while [ $# -gt 0 ]; do case $1 in --count) what=$2; shift;; --repetitions) times=$2; shift;; esac; shift; done
. "$(dirname "$0")/prices"
eval price=\\$$what
echo "$what: 10 queries"
echo "==1== Collected : $((1000 + 10 * price * times))" >&2
"""


class Instructions(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "valgrind").write_text(VALGRIND)
        (self.folder / "valgrind").chmod(0o755)
        self.baseline = self.folder / "baseline.json"

    def run_with(self, *options, fast, filtered, families=("--family", "near,far")):
        (self.folder / "prices").write_text(f"fast={fast}\nfiltered={filtered}\n")
        command = [sys.executable, "-B", ROOT / "experiments/studies/bench/instructions.py", "/bin/true", *families, *options]
        return subprocess.run(command, capture_output=True, text=True,
                              env={**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}"})

    def test_are_the_difference_of_asking_once_and_twice(self):
        run = self.run_with("--json", self.baseline, fast=200, filtered=300)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertIn("1.500", run.stdout)
        counts = {"fast": 200, "filtered": 300}
        self.assertEqual(json.loads(self.baseline.read_text()),
                         {"samples": 2000, "seed": 1, "instructions_per_query": {"near": counts, "far": counts}})

    def test_that_have_grown_are_named(self):
        self.run_with("--json", self.baseline, fast=200, filtered=300)
        for fast, filtered, status, words in ((200, 300, 0, None), (205, 308, 0, None), (200, 320, 1, "filtered: +6.7%, 300.0 before"),
                                              (220, 300, 1, "fast: +10.0%, 200.0 before"), (100, 300, 0, "fast: -50.0%, 200.0 before")):
            run = self.run_with("--baseline", self.baseline, fast=fast, filtered=filtered)
            self.assertEqual(run.returncode, status, run.stdout + run.stderr)
            self.assertEqual(run.stdout.count(" before"), 0 if words is None else 2)  # once a family
            self.assertIn(words or "", run.stdout)

    def test_are_held_against_those_of_the_same_queries_alone(self):
        self.run_with("--json", self.baseline, fast=200, filtered=300)
        for options, words in ((["--seed", "2"], "is of {'samples': 2000, 'seed': 1}, not of {'samples': 2000, 'seed': 2}"),
                               (["--family", "near,other"], "the baseline has no fast of other"),
                               (["--baseline", self.folder / "none"], "cannot be read"),
                               (["--baseline", self.folder / "prices"], "is no baseline")):
            run = self.run_with("--baseline", self.baseline, *options, fast=200, filtered=300)
            self.assertEqual(run.returncode, 2)
            self.assertIn(words, run.stderr)

    def test_stand_in_the_baseline_for_every_family_that_is_counted_by_default(self):
        run = self.run_with("--baseline", ROOT / "tests/experiments/studies/bench/instructions.json", families=(), fast=1, filtered=1)
        self.assertEqual((run.returncode, run.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
