# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: cost.py SOURCE

The tables of costs show what the stored measurements say. Exit status 1 otherwise.
"""

import contextlib
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv[1])
sys.path.append(str(SOURCE / "experiments/report"))

import cost_tables  # noqa: E402


def spread(median):
    return {"median": median, "lower_quartile": 0.9 * median, "upper_quartile": 1.1 * median}


def bench(commit):
    """A file as `touchstone bench` writes it."""
    def contestant(name, median, wrong, ratio):
        return {"name": name, "asked": 7, "nanoseconds": spread(median), "wrong": {"count": wrong, "of": 1000}, "ratio": spread(ratio)}
    contests = [{"family": family, "name": name, "contestants":
                 [contestant("fast", 30.4, 250, 1), contestant("filtered", 28.6, 0, 1.25), contestant("Ericson", 20, 3, 1)]}
                for family, name in cost_tables.FAMILIES]
    contests[0]["contestants"].append(contestant("EPECK", 12345.6, 0, 400))
    contests[3]["contestants"].append(contestant("fast, same tree", 14.3, 10, 0.5))
    return {"run": {key: f"<{key}>" for key in [*cost_tables.RUN, "seed"]} | {"commit": commit}, "repetitions": 11,
            "contests": [{"family": "slivers", "name": "", "contestants": []}, *contests]}


class Cost(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for file in ("README.md", "docs/cost.md", "tests/experiments/studies/bench/instructions.json"):
            (self.root / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / file, self.root / file)
        self.git("init", "--quiet")
        self.commit = self.commits("first")

    def git(self, *words):
        made = subprocess.run(["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@b", *words], capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        return made.stdout.strip()

    def commits(self, title):
        self.git("commit", "--quiet", "--allow-empty", "-m", title)
        return self.git("rev-parse", "HEAD")

    def run_main(self, *options):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            status = cost_tables.main(str(self.root), *options)
        self.said = said.getvalue()
        return status

    def store(self, data):
        (self.root / "docs/cost.json").write_text(json.dumps(cost_tables.kept(data, self.root)))
        self.run_main("--write")

    def test_noise_is_not_stored(self):
        noisy = bench(self.commit)
        noisy["contests"][1]["contestants"][1]["nanoseconds"]["upper_quartile"] = 80
        noisy["contests"][2]["contestants"][1]["ratio"]["upper_quartile"] = 2
        with self.assertRaisesRegex(SystemExit, "too noisy to quote: random-triangles, filtered; half-near, ratio; measure again"):
            cost_tables.kept(noisy, self.root)

    def test_pages_show_the_stored_measurements(self):
        self.assertEqual(cost_tables.main(str(SOURCE)), 0)

    def test_a_changed_number_is_noticed(self):
        page = self.root / "docs/cost.md"
        page.write_text(page.read_text().replace("| 275 |", "| 276 |", 1))
        self.assertEqual(self.run_main(), 1)
        self.run_main("--write")
        self.assertEqual(self.run_main(), 0)

    def test_measured_times_with_quartiles_replace_instructions_in_the_readme(self):
        self.store(bench(self.commit))
        page = (self.root / "README.md").read_text()
        self.assertIn("| triangles, balls anywhere | 30 (27 to 33) | 29 (26 to 31) | 1.25 (1.12 to 1.38) |  |  |  | 12,346 (11,111 to 13,580) | 25 % | 0 of 1,000 |  |\n", page)
        self.assertIn(f"on one core of <processor> (<compiler>, <flags>, commit {self.commit[:12]}): medians of 11 repetitions", page)
        self.assertIn("takes `filtered` 1.25 times as long as `fast` (quartiles 1.12 to 1.38)", page)
        self.assertNotIn("Instructions per contact query", page)
        self.assertEqual(self.run_main(), 0)

    def test_polygons_are_compared_with_plain_doubles_over_the_same_hierarchy(self):
        self.store(bench(self.commit))
        self.assertIn("both by the same hierarchy | 14 (13 to 16) | 29 (26 to 31) | 2.00 (1.82 to 2.22) |", (self.root / "README.md").read_text())

    def test_a_run_without_a_family_is_refused(self):
        short = bench(self.commit)
        del short["contests"][2]
        with self.assertRaisesRegex(SystemExit, "no times of half-near"):
            cost_tables.kept(short, self.root)

    def test_times_of_changed_sources_are_neither_stored_nor_accepted(self):
        with self.assertRaisesRegex(SystemExit, "the sources had changes; measure with one that was built from a landed commit"):
            cost_tables.kept(bench(self.commit + "+"), self.root)
        self.store(bench(self.commit))
        self.assertEqual(self.run_main("--landed"), 0)
        path = self.root / "docs/cost.json"
        path.write_text(path.read_text().replace(self.commit, self.commit + "+"))
        self.assertEqual(self.run_main("--landed"), 1)
        self.assertIn("had changes", self.said)

    def test_times_of_a_commit_that_is_not_an_ancestor_are_refused(self):
        self.store(bench(self.commit))
        self.commits("second")
        self.assertEqual(self.run_main("--landed"), 0)
        self.git("checkout", "--quiet", "--orphan", "elsewhere")
        self.commits("unrelated")
        self.assertEqual(self.run_main("--landed"), 1)
        self.assertIn("is not an ancestor of HEAD", self.said)
        with self.assertRaisesRegex(SystemExit, "is not an ancestor of HEAD"):
            cost_tables.kept(bench("248e07be873c6a89d091fdbab32a82ba6fd900ec"), self.root)

    def test_a_shallow_clone_and_a_folder_without_history_say_that_they_cannot_tell(self):
        self.store(bench(self.commit))
        self.git("add", "--all")
        self.commits("second")
        shallow = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.git("clone", "--quiet", "--depth", "1", f"file://{self.root}", shallow)
        self.root = shallow
        self.assertEqual(self.run_main("--landed"), cost_tables.CANNOT_TELL)
        self.assertIn("the clone is shallow", self.said)
        shutil.rmtree(self.root / ".git")
        self.assertEqual(self.run_main("--landed"), cost_tables.CANNOT_TELL)
        self.assertIn("not a git repository", self.said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
