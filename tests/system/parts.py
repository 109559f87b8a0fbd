# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: parts.py TOUCHSTONE SOURCE

A judgement by parts tells what one run tells, byte for byte. Parts that do not belong together, or were edited, are an error
that names their folder and the reason. Exit status 1 otherwise.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOUCHSTONE, SOURCE = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
PATIENCE = 300
# Touches the nearest vertex.
ENGINE = """import json, math, sys
for line in sys.stdin:
    case = json.loads(line)
    distance = min(math.dist(vertex, case["ball"]["center"]) for vertex in case["polygon"]["outer"])
    print(json.dumps({"id": case["id"], "contact": distance <= case["ball"]["radius"], "distance": distance}), flush=True)
"""
MINE = ["--engine", f"{sys.executable} engine.py =mine"]


class Parts(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "engine.py").write_text(ENGINE)
        self.cases = self.draw(60)
        (self.folder / "cases.jsonl").write_text(self.cases)

    def draw(self, samples, *options):
        return self.run_it("cases", "--family", "u", "--ball", "near-edge", "--expected", "--samples", samples, *options).stdout

    def run_it(self, *words, status=0):
        done = subprocess.run([TOUCHSTONE, *map(str, words)], cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE,
                              stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout[-2000:])
        return done

    def part(self, share, folder, *options, status=0):
        return self.run_it("judge", "cases.jsonl", *MINE, "--methods", "fast", *options, "--part", share, "--output", folder, status=status)

    def test_add_up_to_one_run(self):
        whole = self.run_it("judge", "cases.jsonl", *MINE, "--methods", "fast", status=1)
        for share, folder in ("1/3", "one"), ("2/3", "two"), ("3/3", "three"):
            self.part(share, folder)
        merged = self.run_it("merge", "two", "three", "one", "--output", "all", status=1)
        self.assertEqual(merged.stdout, whole.stdout)
        self.assertEqual(merged.stderr, whole.stderr)
        summary = self.run_it("merge", "one", "two", "three", "--output", "all", "--force", "--json", status=1).stdout
        self.assertEqual(summary, self.run_it("judge", "cases.jsonl", *MINE, "--methods", "fast", "--json", status=1).stdout)

    def test_that_do_not_belong_together_are_named(self):
        def refused(*folders):
            return self.run_it("merge", *folders, "--output", "all", "--force", status=2).stderr

        for number in (1, 2, 3):
            self.part(f"{number}/3", str(number))
        self.assertEqual(refused("1", "3"), "touchstone: part 2/3 of judge is missing\n")
        self.assertEqual(refused("1", "3", "2", "3"), "touchstone: 3: is part 3/3, as 3 is\n")
        self.part("2/3", "keys", "--keys", "contact")
        self.assertEqual(refused("1", "keys", "3"), "touchstone: keys/part.json: is of --keys contact, not of --keys \n")
        self.part("2/3", "summary", "--summary")
        self.assertIn("touchstone: summary/part.json: is of --summary yes, not of", refused("1", "summary", "3"))
        (self.folder / "cases.jsonl").write_text(self.draw(60, "--seed", "2"))
        self.part("2/3", "other")
        self.assertIn("touchstone: 1/part.json: is of FILE cases.jsonl (60 lines, hash ", refused("1", "other", "3"))
        self.assertIn("touchstone: --part: cases on standard input", self.run_it("judge", "--part", "1/1", "--output", "in", status=2).stderr)

    def test_that_were_edited_are_refused(self):
        for number in (1, 2):
            self.part(f"{number}/2", str(number))
        file = self.folder / "2/part.json"
        text = file.read_text()
        self.assertIn("separate", text)
        file.write_text(text.replace("separate", "touching", 1))  # of equal length
        said = self.run_it("merge", "1", "2", "--output", "all", status=2).stderr
        self.assertEqual(said, "touchstone: 2/part.json: was changed since its run wrote it\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
