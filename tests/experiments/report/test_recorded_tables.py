# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_recorded_tables.py SOURCE

./reproduce says how many tables equal the recorded ones, and which do not. Times are not compared."""
import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest

sys.path.append(f"{sys.argv.pop(1)}/experiments/report")
import recorded_tables  # noqa: E402
from studies import modules, shown  # noqa: E402


class Tables(unittest.TestCase):
    def setUp(self):
        self.results = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.record = self.results / "record.json"
        for name, text in {"soak/one.csv": "method,seconds\nfast,1\n", "motions/two.csv": "x\n1\n", "motions/three.csv": "y\n1\n",
                           "motions/cost.csv": "x,median_ns\n1,2\n", "soak/run.json": '{"engines": []}'}.items():
            (self.results / name).parent.mkdir(exist_ok=True)
            (self.results / name).write_text(text)
        self.mark("soak", "quick")
        self.mark("motions", "quick")
        self.said(recorded_tables.write)

    def mark(self, study, mode):
        calls = [shown(call, study) for call in modules()[study].RUN.calls(mode)]
        (self.results / study / "reproduce.json").write_text(json.dumps({"calls": calls, "done": True}))

    def said(self, call):
        with contextlib.redirect_stdout(io.StringIO()) as output:
            self.status = call(self.results, self.record)
        return output.getvalue()

    def test_without_times_are_recorded_and_equal(self):
        self.assertEqual(list(json.loads(self.record.read_text())["tables"]), ["motions/three.csv", "motions/two.csv", "soak/one.csv"])
        (self.results / "motions/cost.csv").write_text("x,median_ns\n1,3\n")
        self.assertRegex(self.said(recorded_tables.compare), r"^3 of 3 tables equal those of version [\d.]+\.\n$")
        self.assertEqual(self.status, 0)

    def test_that_differ_are_named_and_fail_unless_the_program_has_other_engines(self):
        (self.results / "motions/two.csv").write_text("x\n2\n")
        self.assertRegex(self.said(recorded_tables.compare), r"^2 of 3 tables .*\nThese differ: motions/two\.csv\n")
        self.assertEqual(self.status, 1)
        (self.results / "soak/run.json").write_text('{"engines": ["ode"]}')
        self.assertIn("These differ, of a program that also has ode: motions/two.csv\n", self.said(recorded_tables.compare))
        self.assertEqual(self.status, 0)
        with self.assertRaisesRegex(SystemExit, "made with ode"):
            recorded_tables.write(self.results, self.record)

    def test_that_were_not_made_are_named(self):
        self.mark("soak", "full")
        for _ in "with full samples", "at all":
            self.assertRegex(self.said(recorded_tables.compare), r"^2 of 3 tables .*\nThese were not made with small samples: soak/one\.csv\n")
            self.assertEqual(self.status, 0)
            (self.results / "soak/one.csv").unlink(missing_ok=True)

    def test_of_which_none_is_equal_fail(self):
        for name in ("soak/one.csv", "motions/two.csv", "motions/three.csv"):
            (self.results / name).unlink()
        self.assertIn("0 of 3 tables", self.said(recorded_tables.compare))
        self.assertEqual(self.status, 1)


if __name__ == "__main__":
    unittest.main()
