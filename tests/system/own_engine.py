# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: own_engine.py TOUCHSTONE SOURCE

Engines that this project does not know, one exact and one that looks at vertices alone, get all that its methods get, by
the commands that the pages name. Exit status 1 otherwise.
"""
import csv
import json
import pathlib
import pty
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

TOUCHSTONE, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
PATIENCE = 300
EXACT = f"{sys.executable} {SOURCE}/tests/experiments/judge/exact_contact.py=precise"
VERTICES = """import json, math, sys
for line in sys.stdin:
    case = json.loads(line)
    distance = min(math.dist(vertex, case["ball"]["center"]) for vertex in case["polygon"]["outer"])
    print(json.dumps({"id": case["id"], "contact": distance <= case["ball"]["radius"]}), flush=True)
"""


class OwnEngine(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "vertices.py").write_text(VERTICES)
        self.vertices = f"{sys.executable} vertices.py"

    def run_it(self, *words, status=0, **options):
        done = subprocess.run([TOUCHSTONE, *map(str, words)], cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE,
                              stdin=subprocess.DEVNULL, **options)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout[-2000:])
        return done

    def rows(self, *path):
        with open(self.folder.joinpath(*path), newline="") as file:
            return list(csv.DictReader(file))

    def test_the_judge_sums_up_and_reports(self):
        corpus = [SOURCE / f"tests/corpus/{name}.jsonl" for name in ("edge", "off-plane", "holes")]
        done = self.run_it("judge", "--engine", EXACT, "--engine", self.vertices + "=corners", "--keys", "contact", "--json",
                           "--junit", "it.xml", "--report", "it.html", *corpus, status=1)
        self.assertEqual(done.stderr, "")
        precise, corners = json.loads(done.stdout)["methods"]
        self.assertEqual((precise["method"], precise["all"]["wrong"], precise["all"]["not_given"]), ("precise", 0, 0))
        self.assertEqual(list(precise["keys"]), ["contact"])
        self.assertEqual(list(precise["families"]), ["edge", "holes", "off-plane"])
        self.assertGreater(corners["all"]["wrong"], 50)
        self.assertLess(corners["all"]["lower"], corners["all"]["rate"])
        suites = xml.etree.ElementTree.parse(self.folder / "it.xml").getroot()
        self.assertEqual(int(suites.get("failures")), corners["all"]["wrong"])
        self.assertEqual(len(suites.findall(".//testcase")), 2 * precise["all"]["cases"])
        page = (self.folder / "it.html").read_text()
        self.assertEqual(page.count("role=\"img\""), 8)  # of the one that is wrong
        self.assertNotIn("http", page.replace("http://www.w3.org/2000/svg", ""))
        text = self.run_it("judge", "--engine", self.vertices + "=corners", "--keys", "contact", "--summary", *corpus, status=1)
        self.assertLess(text.stdout.count("\n"), 50)
        self.assertEqual(text.stderr, "")

    def test_the_judge_keeps_files_that_are_there(self):
        (self.folder / "it.html").write_text("precious")
        done = self.run_it("judge", "--report", "it.html", SOURCE / "tests/corpus/features.jsonl", status=2)
        self.assertIn("--force", done.stderr)
        self.assertEqual((self.folder / "it.html").read_text(), "precious")

    def test_the_judge_fails_by_new_failures_alone(self):
        judge = ("judge", "--keys", "contact", "--known", "known.jsonl", "--json", SOURCE / "tests/corpus/edge.jsonl", "--engine")
        self.run_it(*judge, self.vertices + "=mine", status=2)  # there is no such file yet
        wrote = self.run_it(*judge, self.vertices + "=mine", "--update")
        known = (self.folder / "known.jsonl").read_text()
        failures = known.count("\n")
        self.assertGreater(failures, 10)
        self.assertIn(f"known.jsonl: {failures} added, 0 removed", wrote.stderr)
        again = self.run_it(*judge, self.vertices + "=mine")
        self.assertEqual(again.stderr, "")
        self.assertEqual(json.loads(again.stdout)["methods"][0]["all"]["known"], failures)
        mended = self.run_it(*judge, EXACT.replace("precise", "mine"), "--update")
        self.assertEqual(mended.stderr.count(": mended: "), failures)
        self.assertEqual((self.folder / "known.jsonl").read_text(), "")
        self.run_it(*judge, self.vertices + "=mine", status=1)

    def test_what_cannot_be_started_ends_at_once(self):
        for engine in ("./nothing", "./vertices.py"):
            done = self.run_it("judge", "--engine", engine, SOURCE / "tests/corpus/edge.jsonl", status=2)
            self.assertIn(f"touchstone: engine {engine}: cannot be started: exit status 12", done.stderr)
            self.assertEqual(done.stdout, "")
        (self.folder / "vertices.py").chmod(0o644)
        for call in (["near-edge", "--samples", "1", "--no-pictures"], ["regress", "--samples", "1"], ["cases", "--samples", "1"]):
            self.assertIn("cannot be started", self.run_it(*call, "--engine", "./nothing=none", status=2).stderr)

    def test_near_edge_measures_it(self):
        self.run_it("near-edge", "--engine", EXACT, "--engine", self.vertices + "=corners", "--families", "l", "--samples", "1",
                           "--search", "1", "--no-maps", "--no-pictures", "--output", "out")
        rates = self.rows("out", "rates.csv")
        self.assertEqual({row["method"] for row in rates}, {"precise", "corners"})
        self.assertEqual({row["test"] for row in rates}, {"contact"})
        self.assertEqual({row["failures"] for row in rates if row["method"] == "precise"}, {"0"})
        self.assertIn("1", {row["failures"] for row in rates if row["method"] == "corners"})
        self.assertIn("corners", (self.folder / "out/worst.jsonl").read_text())
        shown = self.run_it("show", "out/worst.jsonl", "--samples", "1", "--engine", self.vertices + "=corners", "--html", "worst.html")
        self.assertEqual(shown.stdout, "")
        self.assertIn("corners", (self.folder / "worst.html").read_text())

    def test_tradeoff_says_which_times_include_a_pipe(self):
        self.run_it("tradeoff", "--engine", self.vertices + "=corners", "--methods", "fast", "--families", "l", "--samples", "1",
                           "--queries", "5", "--repetitions", "1", "--no-pictures", "--output", "out")
        for table in ("timings.csv", "front.csv"):
            for row in self.rows("out", table):
                self.assertEqual(row["through"], "pipe" if row["method"] == "corners" else "call")

    def test_stability_measures_it(self):
        self.run_it("stability", "--engine", self.vertices + "=corners", "--axes", "aspect", "--samples", "1", "--no-pictures", "--quiet",
                    "--output", "out")
        self.assertIn("corners", {row["method"] for row in self.rows("out", "failures.csv")})

    def test_regress_has_a_baseline_of_its_own(self):
        write = ["regress", "--samples", "1", "--write", "mine.json"]
        self.run_it(*write, "--engine", EXACT.replace("=precise", "=mine"))
        compare = ["regress", "--baseline", "mine.json", "--engine"]
        self.assertIn("0 cases better than the baseline, 0 worse", self.run_it(*compare, EXACT.replace("=precise", "=mine")).stdout)
        self.run_it(*compare, self.vertices + "=mine", status=1)
        self.assertIn("--engine names", self.run_it(*compare, self.vertices + "=other", "--engine", EXACT.replace("=precise", "=mine"), status=2).stderr)

    def test_near_edge_asks_it_about_meshes(self):
        (self.folder / "mesh.obj").write_text("v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n")
        self.run_it("near-edge", "mesh.obj", "--engine", self.vertices + "=corners", "--output", "out")
        self.assertIn("corners", (self.folder / "out/meshes.csv").read_text())

    def test_its_failures_are_found_and_made_small_and_shown(self):
        engine = ["--engine", self.vertices + "=corners"]
        found = self.run_it("cases", "--samples", "2", "--ball", "near-edge", *engine, "--expected").stdout
        self.assertEqual(found.count("\n"), 2)
        (self.folder / "found.jsonl").write_text(found)
        small = self.run_it("corpus", "shrink", "found.jsonl", *engine).stdout
        self.assertLess(len(small), len(found))
        self.assertIn("corpus shrink --engine corners", small)
        (self.folder / "small.jsonl").write_text(small)
        self.run_it("judge", *engine, "--keys", "contact", "small.jsonl", status=1)
        self.run_it("judge", "--engine", EXACT, "--keys", "contact", "small.jsonl")
        page = self.run_it("show", "small.jsonl", *engine, "--methods", "filtered").stdout
        self.assertEqual(page.count("role=\"img\""), 2)
        self.assertIn("class=\"wrong\"", page)
        self.assertIn("<th>corners</th>", page)

    def test_the_study_of_motions_asks_those_alone_that_know_motions(self):
        moving = ["motions", "--vertices", "4", "--samples", "1", "--no-pictures", "--methods", "fast"]
        for engine, told in ((self.vertices + "=corners", 'method "corners" is wrong about whether'),
                             (EXACT, 'method "precise" does not say whether')):
            refused = self.run_it(*moving, "--engine", engine, "--output", "refused", status=2)
            self.assertIn(told + " a ball that moves through a triangle touches it", refused.stderr)
            self.assertIn("judge --at-rest", refused.stderr)
        self.run_it(*moving, "--engine", TOUCHSTONE + " judge --methods exact =ours", "--output", "ways")
        wrong = {name: sum(int(row["missed"]) + int(row["invented"]) for row in self.rows("ways", "ways.csv") if row["method"] == name)
                 for name in ("fast", "ours")}
        self.assertGreater(wrong["fast"], 0)
        self.assertEqual(wrong["ours"], 0)

    def test_the_old_name_of_the_option_is_understood(self):
        asked = ["--keys", "contact", "--json", SOURCE / "tests/corpus/edge.jsonl"]
        self.assertEqual(self.run_it("judge", "--exec", EXACT, *asked).stdout, self.run_it("judge", "--engine", EXACT, *asked).stdout)
        with_sign = self.run_it("judge", "--exec=" + EXACT, *asked).stdout
        self.assertEqual(with_sign, self.run_it("judge", "--engine=" + EXACT, *asked).stdout)

    def test_the_script_of_ci_judges_it(self):
        environment = dict(os.environ, TOUCHSTONE=TOUCHSTONE, KEYS="contact")
        done = subprocess.run([SOURCE / ".ci/judge_engine", self.vertices + "=corners", "judged"], cwd=self.folder, env=environment,
                              capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder / "judged")), ["junit.xml", "report.html", "summary.txt"])
        self.assertIn("corners\n", done.stdout)

    def test_colours_are_for_terminals_without_no_color(self):
        def error(**environment):
            parent, child = pty.openpty()
            environment = {**os.environ, "TERM": "xterm", **environment}
            subprocess.run([TOUCHSTONE, "judg"], stderr=child, stdin=subprocess.DEVNULL, env=environment, timeout=PATIENCE)
            os.close(child)
            return os.read(parent, 1000).decode()
        environment = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        self.assertEqual("\033[31m" in error(NO_COLOR=""), True, environment)
        self.assertNotIn("\033", error(NO_COLOR="1"))
        self.assertNotIn("\033", error(NO_COLOR="", TERM="dumb"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
