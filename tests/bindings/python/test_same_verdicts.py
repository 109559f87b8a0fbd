# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_same_verdicts.py TOUCHSTONE [unittest's options]

The judge of the module gives the verdicts of the program's, on all cases that the module has: the same failures, key by
key, the same counts, with margins and without, with failures that are known and without.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import judged_engines
import touchstone_contact as touchstone
from touchstone_contact.judging import case_files

ENGINES = pathlib.Path(judged_engines.__file__)
POSED = sorted((pathlib.Path(__file__).parents[2] / "corpus/meshes").glob("*.jsonl"))  # in doubles; no case in floats has a pose
AT_FACES = [file for file in case_files() if not file.stem.startswith("meshes")]


class SameVerdicts(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def judged_by_program(self, name, files, options, numbers):
        """The counts of the program, and the text of all failures with its known ones in."""
        engine = ["--methods", name] if name == "fast" else ["--engine", f"{sys.executable} -B {ENGINES} {name} {numbers}={name}"]
        command = [TOUCHSTONE, "judge", *engine, "--json", "--known", self.folder / "known.jsonl", "--update", *options, *files]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=600)
        self.assertLessEqual(done.returncode, 1, done.stderr)
        (method,) = json.loads(done.stdout)["methods"]
        mended = [line for line in done.stderr.splitlines() if ": mended: " in line]
        return method, len(mended), (self.folder / "known.jsonl").read_text()

    def compare(self, name, files, beyond=None, keys="all", known="", options=(), floats=True, **others):
        """Returns both judgements' common count of all cases."""
        (self.folder / "known.jsonl").write_text(known)
        found = touchstone.judge(judged_engines.ENGINES[name], files, floats=floats, keys=keys, beyond=beyond,
                                 known=self.folder / "known.jsonl", **others)
        found.write_known(self.folder / "found.jsonl")
        options = [*options, *(["--beyond", beyond] if beyond else []), *([] if keys == "all" else ["--keys", keys])]
        method, mended, text = self.judged_by_program(name, files, options, "floats" if floats else "doubles")
        self.assertEqual((self.folder / "found.jsonl").read_text(), text)
        self.assertEqual(len(found.mended), mended)
        for count, of_program in [(found.all, method["all"]), *((found.families[family], method["families"][family])
                                                                for family in found.families | method["families"])]:
            for number in ("cases", "wrong", "not_given", "known", "within"):
                self.assertEqual(getattr(count, number), of_program[number], number)
            self.assertAlmostEqual(count.upper, of_program["upper"], delta=1e-9)
        return found.all, text

    def test_about_plain_doubles(self):
        count, _ = self.compare("fast", AT_FACES)
        self.assertGreater(count.wrong, 2000)

    def test_about_plain_doubles_with_margins(self):
        for beyond in ("2^-20", "1e-12m"):
            count, _ = self.compare("fast", AT_FACES, beyond)
            self.assertGreater(count.within, 1000)

    def test_about_an_engine_of_contact_alone(self):
        options = ["--triangles", "--at-rest"]
        count, known = self.compare("corners", AT_FACES, "2^-20", "contact", options=options, triangles=True)
        again, _ = self.compare("corners", AT_FACES, None, "contact", known, options, triangles=True)
        self.assertEqual((count.known, again.known), (0, count.wrong))
        self.assertGreater(again.wrong, again.known)

    def test_about_a_careless_engine(self):
        count, known = self.compare("careless", case_files())
        self.assertGreater(count.wrong, 3000)
        self.assertIn('"key":"no answer"', known)
        self.assertIn('"given":false', known)
        for beyond, before in (("2^-20", known), ("1e-3", "")):
            count, _ = self.compare("careless", case_files(), beyond, known=before)
            self.assertEqual(count.known > 0, before != "")
            self.assertGreater(count.within, 300)

    def test_about_posed_meshes(self):
        for beyond in (None, "2^-20", "1e-3"):
            count, _ = self.compare("careless", POSED, beyond, floats=False)
            self.assertEqual((count.cases, count.wrong > 150), (240, True))


if __name__ == "__main__":
    TOUCHSTONE = sys.argv.pop(1)
    unittest.main()
