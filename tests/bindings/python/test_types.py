# SPDX-License-Identifier: GPL-3.0-or-later
"""The annotations of the module are those of its functions, let right programs pass and find errors in wrong ones."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).parent


def mypy(*arguments, module="mypy"):
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", module, *arguments]
        return subprocess.run(command, capture_output=True, text=True, cwd=folder, check=False)


class Types(unittest.TestCase):
    def test_let_a_right_program_pass(self):
        found = mypy("--strict", str(HERE / "typed_sample.py"))
        self.assertEqual(found.returncode, 0, found.stdout + found.stderr)

    def test_find_every_wrong_line(self):
        sample = HERE / "wrongly_typed_sample.py"
        found = mypy("--strict", str(sample))
        wrong = {i for i, line in enumerate(sample.read_text().splitlines(), 1) if line.endswith("# wrong")}
        self.assertEqual({int(line) for line in re.findall(r"sample\.py:(\d+): error", found.stdout)}, wrong, found.stdout)

    def test_hold_in_the_modules_of_python(self):
        found = mypy("--strict", "-p", "touchstone_contact.judging", "-p", "touchstone_contact.strategies", "-p", "touchstone_contact._arguments")
        self.assertEqual(found.returncode, 0, found.stdout + found.stderr)

    def test_name_every_class_and_function(self):
        found = mypy("touchstone_contact", "--ignore-missing-stub", "--allowlist", str(HERE / "not_in_stubs.txt"), module="mypy.stubtest")
        self.assertEqual(found.returncode, 0, found.stdout + found.stderr)


if __name__ == "__main__":
    unittest.main()
