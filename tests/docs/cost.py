# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: cost.py SOURCE

The tables of costs show what the stored measurements say. Exit status 1 otherwise.
"""

import contextlib
import io
import json
import pathlib
import shutil
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv[1])
sys.path.append(str(SOURCE / "experiments/report"))

import cost_tables  # noqa: E402


def bench():
    """A file as `touchstone bench` writes it."""
    def contestant(name, median, wrong):
        return {"name": name, "asked": 7, "nanoseconds": {"median": median, "lower_quartile": 0.9 * median, "upper_quartile": 1.1 * median}, "wrong": {"count": wrong, "of": 1000}}
    contests = [{"family": family, "name": name, "contestants":
                 [contestant("fast", 30.4, 250), contestant("filtered", 28.6, 0), contestant("Ericson", 20, 3)]}
                for family, name in cost_tables.FAMILIES]
    contests[0]["contestants"].append(contestant("EPECK", 12345.6, 0))
    return {"run": {key: f"<{key}>" for key in [*cost_tables.RUN, "seed"]}, "repetitions": 11,
            "contests": [{"family": "slivers", "name": "", "contestants": []}, *contests]}


class Cost(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for file in ("README.md", "docs/cost.md", "tests/experiments/studies/bench/instructions.json"):
            (self.root / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / file, self.root / file)

    def run_main(self, *options):
        with contextlib.redirect_stdout(io.StringIO()):
            return cost_tables.main(str(self.root), *options)

    def measure(self):
        (self.root / "bench.json").write_text(json.dumps(bench()))
        return self.run_main("--measured", str(self.root / "bench.json"))

    def test_noise_is_not_stored(self):
        noisy = bench()
        noisy["contests"][1]["contestants"][1]["nanoseconds"]["upper_quartile"] = 80
        (self.root / "bench.json").write_text(json.dumps(noisy))
        with self.assertRaisesRegex(SystemExit, "too noisy to quote: random-triangles, filtered; measure again"):
            self.run_main("--measured", str(self.root / "bench.json"))
        self.assertFalse((self.root / "docs/cost.json").exists())

    def test_pages_show_the_stored_measurements(self):
        self.assertEqual(cost_tables.main(str(SOURCE)), 0)

    def test_a_changed_number_is_noticed(self):
        page = self.root / "docs/cost.md"
        page.write_text(page.read_text().replace("| 275 |", "| 276 |", 1))
        self.assertEqual(self.run_main(), 1)
        self.run_main("--write")
        self.assertEqual(self.run_main(), 0)

    def test_measured_times_replace_instructions_in_the_readme(self):
        self.measure()
        page = (self.root / "README.md").read_text()
        self.assertIn("| triangles, balls anywhere | 30 | 29 | 12,346 | 25 % | 0 of 1,000 | 0 of 1,000 |\n", page)
        self.assertIn("on one core of <processor> (<compiler>, <flags>; medians of 11 runs)", page)
        self.assertNotIn("Instructions per contact query", page)
        self.assertEqual(self.run_main(), 0)

    def test_a_contestant_that_was_not_measured_has_empty_cells(self):
        self.measure()
        self.assertIn("| triangles, all balls exactly tangent | 30 | 29 |  | 25 % | 0 of 1,000 |  |\n",
                      (self.root / "README.md").read_text())

    def test_a_run_without_a_family_is_refused(self):
        short = bench()
        del short["contests"][2]
        with self.assertRaisesRegex(SystemExit, "no times of half-near"):
            cost_tables.kept(short)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
