# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_pytest_plugin.py SOURCE [unittest's options]

`pytest --touchstone` and the strategies find a sign error that is planted in an exact engine, and make it small.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from touchstone_contact.judging import Question

SOURCE = pathlib.Path(sys.argv.pop(1))
ENGINE = (SOURCE / "tests/experiments/judge/exact_contact.py").read_text()
CALLABLE = """
def touches(centre, radius, vertices, holes):
    return contact({"ball": {"center": centre.tolist(), "radius": float(radius)},
                    "polygon": {"outer": vertices.tolist(), "holes": [hole.tolist() for hole in holes]}})
"""
RIGHT, WRONG = "x - height * y", "x + height * y"
PROPERTIES = """
import hypothesis
import numpy as np
from engine import touches
from touchstone_contact import strategies


@hypothesis.settings(derandomize=True, max_examples=200, deadline=None, database=None)
@hypothesis.given(strategies.questions())
def test_engine(question):
    assert touches(np.array(question.centre), question.radius, np.array(question.vertices), []) == question.contact
"""


class Plugin(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.write(RIGHT)

    def write(self, sign):
        self.assertEqual(ENGINE.count(RIGHT), 1)
        (self.folder / "engine.py").write_text(ENGINE.replace(RIGHT, sign) + CALLABLE)

    def pytest(self, *options, status, judged=True):
        options = ["-p", "touchstone_contact.pytest_plugin", "--touchstone", "engine:touches", *options] if judged else options
        command = [sys.executable, "-B", "-m", "pytest", "-p", "no:cacheprovider", "--color=no", *options]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=600, env={**os.environ, "COLUMNS": "200"})
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def test_passes_an_exact_engine_in_every_family(self):
        said = self.pytest("-v", "--touchstone-triangles", status=0)
        self.assertIn("touchstone[sliver] PASSED", said)
        self.assertIn("touchstone[moving] SKIPPED (touches takes none of the 318 cases)", said)
        self.assertRegex(said, r"1\d passed, \d+ skipped in")

    def test_finds_a_planted_sign_error_and_makes_it_small(self):
        self.write(WRONG)
        said = self.pytest("-k", "face or flat", "--touchstone-pictures", "pictures", status=1)
        self.assertIn("touchstone[face]", said)
        self.assertNotIn("touchstone[sliver]", said)
        self.assertRegex(said, r"touches fails in \d+ of 213 cases:\n  case [\w-]+: contact: expected true, found false\n")
        self.assertIn("made small: contact: expected true, found false\n", said)
        self.assertIn("to call it: import numpy as np; from engine import touches\n", said)
        calls = re.findall(r"^  (touches\(.*\))$", said, re.MULTILINE)
        self.assertEqual(len(calls), 1, said)  # the height of a flat case is 0
        numbers = [float(number) for number in re.findall(r"(?<![\w.])-?[\d.]+(?:e[+-]\d+)?", calls[0])]
        self.assertLessEqual(len(numbers), 3 + 1 + 4 * 3, said)
        self.assertLessEqual(max(map(abs, numbers)), 16, said)
        call = f"import numpy as np; from engine import touches; print({calls[0]})"
        again = subprocess.run([sys.executable, "-c", call], cwd=self.folder, capture_output=True, text=True, timeout=60)
        self.assertEqual(again.stdout, "False\n", again.stderr)
        xml.etree.ElementTree.parse(self.folder / "pictures/face.svg")

    def test_expects_known_failures_and_warns_of_mended_ones(self):
        self.write(WRONG)
        (self.folder / "write.py").write_text("import touchstone_contact, engine\n"
                                              "touchstone_contact.judge(engine.touches).write_known('known.jsonl')\n")
        subprocess.run([sys.executable, "-B", "write.py"], cwd=self.folder, check=True, timeout=600)
        self.pytest("-k", "face", "--touchstone-known", "known.jsonl", status=0)
        self.write(RIGHT)
        said = self.pytest("-k", "face", "--touchstone-known", "known.jsonl", status=0)
        self.assertIn('known.jsonl: mended: {"method":"touches","case":', said)

    def test_judges_by_files_and_keys(self):
        (self.folder / "mine.jsonl").write_text('{"id":"a","ball":{"center":[0,0,1],"radius":1},"polygon":{"outer":[[0,0,0],[1,0,0],[0,1,0]]},'
                                                '"expected":{"contact":true,"relation":"touching"}}\n')
        self.assertIn("1 passed", self.pytest("--touchstone-cases", "mine.jsonl", status=0))
        said = self.pytest("--touchstone-cases", "mine.jsonl", "--touchstone-keys", "all", status=1)
        self.assertIn('case a: relation: expected "touching", not given', said)

    def test_refuses_what_it_cannot_import(self):
        for name in ("engine", "engine:nothing", "nothing:touches"):
            self.assertIn(f"ERROR: --touchstone {name}: ", self.pytest("--touchstone", name, status=4))

    def test_refuses_wrong_values_of_options_once_before_all_tests(self):
        for name in ("known", "cases"):
            (self.folder / f"{name}.jsonl").write_text("{}\n")
        for option, value, reason in (("keys", "contact,weight", "no answer has a key 'weight'"), ("beyond", "2^x", "'2^x' is not a margin"),
                                      ("known", "none.jsonl", "[Errno 2]"), ("known", "known.jsonl", str(self.folder / "known.jsonl: line 1")),
                                      ("cases", "none.jsonl", "[Errno 2]"), ("cases", "cases.jsonl", str(self.folder / "cases.jsonl: line 1"))):
            said = self.pytest(f"--touchstone-{option}", value, status=4)
            self.assertIn(f"ERROR: --touchstone-{option} {value}: {reason}", said)
            self.assertEqual(said.count("ERROR"), 1, said)

    def test_does_nothing_unless_asked(self):
        self.pytest("-p", "touchstone_contact.pytest_plugin", status=5, judged=False)

    def test_strategies_find_the_error_that_an_exact_engine_does_not_have(self):
        (self.folder / "test_properties.py").write_text(PROPERTIES)
        self.pytest(status=0, judged=False)
        self.write(WRONG)
        said = self.pytest(status=1, judged=False)
        self.assertIn("Falsifying example: test_engine(", said)
        example = re.search(r"question=(Question\(.*?\)),\s+\)", re.sub("^E ", "", said, flags=re.MULTILINE), re.DOTALL)
        found = eval(example[1], {"Question": Question})
        self.assertLessEqual(len(found.vertices), 5, said)
        self.assertLessEqual(max(abs(x) for point in found.points() for x in point), 8, said)
        self.assertTrue(found.contact, said)


if __name__ == "__main__":
    unittest.main()
