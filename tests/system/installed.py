# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: installed.py BUILD SOURCE SCRATCH [--optimised]

The installed program needs nothing of the machine that built it: every command that reads data or draws pictures does so
from a new prefix, and no file that is installed or written names a folder of the build. --optimised: the programs
hold neither assertions nor what debuggers read, which may name their sources. Exit status 1 otherwise.
"""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import unittest

BUILD, SOURCE, SCRATCH = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
OPTIMISED = "--optimised" in sys.argv
PREFIX, WORK = SCRATCH / "prefix", SCRATCH / "work"
TOUCHSTONE, DATA = PREFIX / "bin/touchstone", PREFIX / "share/touchstone"
PATIENCE = 300  # seconds, for what takes a few

# A call and what it writes.
CALLS = [
    (["corpus", "make", "corpus"], "corpus/corpus.json"),
    (["recorded", "--methods", "fast", "--samples", "1", "--balls", "2", "--steps", "5", "--output", "recorded"], "recorded/*.csv"),
    (["motions", "--methods", "filtered", "--vertices", "4", "--samples", "1", "--passes", "5", "--repetitions", "1", "--output", "motions"], "motions/steps.svg"),
    (["cell", "new", "new"], "new/cell.json"),
    (["cell", "layout", "--quick", "--output", "layout"], "layout/*.svg"),
    (["cell", "export", "new/cell.json", "cell.html"], "cell.html"),
    (["cell", "show", "new/cell.json", "--output", "show"], "show/run.json"),
    (["thesis", "--quick", "--samples", "100", "--output", "thesis"], "thesis/index.html"),
]
CASE = '{"id":"a","ball":{"center":[1,1,1],"radius":1},"polygon":{"outer":[[0,0,0],[4,0,0],[0,4,0]]}}\n'
IMPORT_ALL = """
import importlib, pathlib, sys
for path in sorted(pathlib.Path("studies").glob("*.py")):
    importlib.import_module(f"studies.{path.stem}")
print(*(module.__file__ for module in sys.modules.values() if getattr(module, "__file__", None)), sep="\\n")
"""


def holding(folder, paths):
    """The files below a folder that name one of the paths, with it."""
    return sorted((str(file), path) for file in folder.rglob("*") if file.is_file() for path in paths
                  if path.encode() in file.read_bytes())


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        WORK.mkdir(parents=True)
        cls.addClassCleanup(shutil.rmtree, SCRATCH)
        subprocess.run(["cmake", "--install", BUILD, "--prefix", PREFIX, "--component", "program"], check=True,
                       stdout=subprocess.DEVNULL)
        (WORK / "case.jsonl").write_text(CASE)

    def run_program(self, *words, **options):
        return subprocess.run([TOUCHSTONE, *words], cwd=WORK, capture_output=True, text=True, stdin=subprocess.DEVNULL,
                              timeout=PATIENCE, **options)

    def test_holds_no_path_of_the_build(self):
        files = holding(PREFIX, [str(SOURCE), str(BUILD)])
        programs = tuple(f"{PREFIX / folder}/" for folder in ("bin", "libexec"))
        self.assertEqual([file for file in files if OPTIMISED or not file[0].startswith(programs)], [])

    def test_finds_its_data_and_scripts(self):
        for call, written in CALLS:
            with self.subTest(call=call):
                done = self.run_program(*call)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertTrue(list(WORK.glob(written)))
        self.assertEqual(holding(WORK, [str(SOURCE), str(BUILD), str(SCRATCH)]), [])
        self.assertIn(" 0 faults\n", self.run_program("corpus", "check").stdout)

    def test_starts_the_programs_of_its_own(self):
        done = self.run_program("judge", "--methods", "all", "case.jsonl")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_serves_a_cell(self):
        serving = subprocess.Popen([TOUCHSTONE, "cell", "serve", "--port", "0"], stdout=subprocess.PIPE, text=True)
        self.addCleanup(serving.stdout.close)
        self.assertRegex(serving.stdout.readline(), r"Aristo.*: http://")
        serving.send_signal(signal.SIGTERM)
        self.assertEqual(serving.wait(PATIENCE), -signal.SIGTERM)

    def test_has_every_script_of_its_pictures(self):
        done = subprocess.run(["/usr/bin/python3", "-B", "-c", IMPORT_ALL], cwd=DATA / "experiments/report", capture_output=True,
                              text=True, env={**os.environ, "PYTHONPATH": "."})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(str(DATA / "experiments/report/studies/thesis.py"), done.stdout)
        self.assertNotRegex(done.stdout, rf"(?m)^{re.escape(str(SOURCE))}/experiments/")
        for path in (SOURCE / "experiments/report").rglob("*"):
            if path.suffix in (".py", ".html", ".css"):
                self.assertTrue((DATA / path.relative_to(SOURCE)).exists(), path)

    def test_names_data_that_are_missing(self):
        for call in ["corpus", "check"], ["cell", "new", "least"], ["cell", "serve"]:
            with self.subTest(call=call):
                done = self.run_program(*call, env={**os.environ, "TOUCHSTONE_DATA": "/nowhere"})
                self.assertEqual(done.returncode, 2)
                self.assertRegex(done.stderr, r"\Atouchstone: /nowhere/\S+: is missing; the variable TOUCHSTONE_DATA names ")

    def test_takes_its_data_from_where_the_variable_says(self):
        moved = SCRATCH / "moved"
        (moved / "tests/corpus").mkdir(parents=True)
        shutil.copy(DATA / "tests/corpus/point.jsonl", moved / "tests/corpus")
        done = self.run_program("corpus", "check", env={**os.environ, "TOUCHSTONE_DATA": str(moved)})
        self.assertRegex(done.stdout, r" cases in 1 file, .* 0 faults\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
