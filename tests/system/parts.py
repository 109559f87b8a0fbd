# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: parts.py TOUCHSTONE SOURCE

A judgement by parts tells what one run tells, byte for byte, also if parts are killed and run again, and by the Snakefile
of the pages. Parts that do not belong together are an error that names their folder and the reason. Exit status 1
otherwise.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOUCHSTONE, SOURCE = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
PATIENCE = 300
# Touches the nearest vertex. Ends the judge that asks it by the signals of the file `signals`: lines of a case and a number.
ENGINE = """import json, math, os, pathlib, re, sys
def judge():
    held = {re.match(r"process (\\d+) ", lock.read_text()) for lock in pathlib.Path().glob("**/.lock")}
    held = {int(match[1]) for match in held if match}
    pid = os.getpid()
    while pid not in held:
        pid = int(pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[1])
    return pid
for line in sys.stdin:
    case = json.loads(line)
    signals = pathlib.Path("signals").read_text().splitlines()
    for signal in [text for text in signals if text.split()[0] == case["id"]]:
        pathlib.Path("signals").write_text("\\n".join(text for text in signals if text != signal))
        os.kill(judge(), int(signal.split()[1]))
    distance = min(math.dist(vertex, case["ball"]["center"]) for vertex in case["polygon"]["outer"])
    print(json.dumps({"id": case["id"], "contact": distance <= case["ball"]["radius"], "distance": distance}), flush=True)
"""
MINE = ["--engine", f"{sys.executable} engine.py =mine"]


class Parts(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "engine.py").write_text(ENGINE)
        (self.folder / "signals").write_text("")
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

    def test_add_up_to_one_run_also_if_they_are_killed(self):
        whole = self.run_it("judge", "cases.jsonl", *MINE, "--methods", "fast", status=1)
        ids = [line.split('"')[3] for line in self.cases.splitlines()]
        # Behind what SIGINT has kept, SIGKILL loses what came later.
        (self.folder / "signals").write_text(f"{ids[5]} 2\n{ids[15]} 9\n{ids[30]} 9\n")
        self.part("1/3", "one", status=130)
        self.part("1/3", "one", "--resume", status=-9)
        self.part("1/3", "one", "--resume")
        self.part("2/3", "two", status=-9)
        self.part("2/3", "two", "--resume")
        self.part("3/3", "three", "--quiet")
        self.assertEqual((self.folder / "signals").read_text(), "")
        merged = self.run_it("merge", "two", "three", "one", "--output", "all", status=1)
        self.assertEqual(merged.stdout, whole.stdout)
        self.assertEqual(merged.stderr, whole.stderr)
        kept = self.run_it("judge", "cases.jsonl", *MINE, "--methods", "fast", "--output", "kept", status=1)
        self.assertEqual((kept.stdout, kept.stderr), (whole.stdout, whole.stderr))
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
        self.assertEqual(refused("1", "keys", "3"), "touchstone: keys/checkpoint.json: is of --keys contact, not of --keys \n")
        self.part("2/3", "summary", "--summary")
        self.assertIn("touchstone: summary/checkpoint.json: is of --summary yes, not of", refused("1", "summary", "3"))
        (self.folder / "cases.jsonl").write_text(self.draw(60, "--seed", "2"))
        self.part("2/3", "other")
        self.assertIn("touchstone: 1/checkpoint.json: is of FILE cases.jsonl (60 lines, hash ", refused("1", "other", "3"))
        self.assertIn("touchstone: --output: cases on standard input", self.run_it("judge", "--part", "1/1", "--output", "in", status=2).stderr)

    def test_of_drawn_cases_are_run_by_the_snakefile(self):
        drawn = self.draw(41)
        victim = drawn.splitlines()[20].split('"')[3]
        (self.folder / "signals").write_text(f"{victim} 9\n")
        command = ["snakemake", "--snakefile", SOURCE / "docs/judge-drawn.smk", "--cores", "2", "--config", f"touchstone={TOUCHSTONE}",
                   "cases=41", "parts=3", f"judge={MINE[0]} '{MINE[1]}' --keys contact"]

        def snakemake():
            return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE, stdin=subprocess.DEVNULL,
                                  env=dict(os.environ, XDG_CACHE_HOME=str(self.folder / "cache")))

        (self.folder / "cases.jsonl").unlink()
        self.assertNotEqual(snakemake().returncode, 0, "a part was killed")
        again = snakemake()
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((self.folder / "cases.jsonl").read_text(), drawn)
        whole = self.run_it("judge", "cases.jsonl", *MINE, "--keys", "contact", status=1)
        self.assertEqual((self.folder / "judged.txt").read_text(), whole.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
