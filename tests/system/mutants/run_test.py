# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge of planted bugs is not misled by a program that it has put together wrongly."""

import pathlib
import tempfile
import unittest

import run

SOURCE = pathlib.Path(__file__).resolve().parents[3]
COMMANDS = [
    "/usr/bin/c++ -O2 -o lib/a.cpp.o -c /source/a.cpp",
    "/usr/bin/cmake -E env SLOPPY=1 /usr/bin/ccache /usr/bin/c++ -O2 -o lib/b.cpp.o -c /source/b.cpp",
    "/usr/bin/c++ -O2 -o one/twice.cpp.o -c /source/twice.cpp",
    "/usr/bin/c++ -DOTHER -o two/twice.cpp.o -c /source/twice.cpp",
    ": && /usr/bin/c++ lib/a.cpp.o -o tests/contact_tests lib/b.cpp.o && :",
]
MUTANT = {"name": "planted", "file": "a.cpp", "suites": "*"}


class Commands(unittest.TestCase):
    def test_a_unit_is_compiled_as_the_program_compiles_it(self):
        self.assertEqual(run.compile_command(COMMANDS, "/source/a.cpp"),
                         ["/usr/bin/c++", "-O2", "-o", "lib/a.cpp.o", "-c", "/source/a.cpp"])

    def test_a_unit_that_is_compiled_together_with_others_is_found_among_them(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "Unity").mkdir()
            together = pathlib.Path(folder) / "Unity/unity_0_cxx.cxx"
            together.write_text('/* generated */\n\n#include "/source/c.cpp"\n\n#include "/source/d.cpp"\n')
            command = f"/usr/bin/c++ -o lib/unity_0_cxx.cxx.o -c {together}"
            self.assertEqual(run.compile_command([*COMMANDS, command], "/source/d.cpp"), command.split())
            self.assertEqual(run.files_of(str(together)), ["/source/c.cpp", "/source/d.cpp"])
        self.assertEqual(run.files_of("/source/a.cpp"), ["/source/a.cpp"])

    def test_a_compiler_cache_is_left_out(self):
        self.assertEqual(run.compile_command(COMMANDS, "/source/b.cpp")[0], "/usr/bin/c++")

    def test_a_unit_that_the_program_compiles_twice_or_never_is_refused(self):
        for file, count in ("/source/twice.cpp", 2), ("/source/none.cpp", 0):
            with self.assertRaisesRegex(ValueError, f"{count} commands of the program compile {file}"):
                run.compile_command(COMMANDS, file)

    def test_the_program_is_linked_as_the_build_links_it(self):
        self.assertEqual(run.link_command(COMMANDS, "contact_tests"),
                         ["/usr/bin/c++", "lib/a.cpp.o", "-o", "tests/contact_tests", "lib/b.cpp.o"])


class Parts(unittest.TestCase):
    def test_parts_hold_each_mutant_once(self):
        parts = [run.part_of(list(range(10)), f"{i}/3") for i in (1, 2, 3)]
        self.assertEqual(sorted(sum(parts, [])), list(range(10)))


class Places(unittest.TestCase):
    def faults(self, **changes):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "a.cpp").write_text("one two two")
            return list(run.misplaced(folder, [{**MUTANT, "old": "one", **changes}]))

    def test_a_text_that_is_found_once_is_in_place(self):
        self.assertEqual(self.faults(), [])

    def test_a_text_that_is_found_twice_or_never_is_an_error(self):
        self.assertEqual(self.faults(old="two"), ["planted: its text stands 2 times in a.cpp"])
        self.assertEqual(self.faults(old="three"), ["planted: its text stands 0 times in a.cpp"])

    def test_a_file_or_unit_that_is_missing_is_an_error(self):
        self.assertEqual(self.faults(file="b.cpp"), ["planted: there is no b.cpp"])
        self.assertEqual(self.faults(units=["c.cpp"]), ["planted: there is no c.cpp"])

    def test_all_that_are_listed_are_in_place(self):
        for corpus in False, True:
            self.assertEqual(list(run.misplaced(SOURCE, run.read_mutants(SOURCE, corpus))), [])


class Fake(run.Workshop):
    """Its programs are shell scripts."""

    def __init__(self, folder, planted, unchanged):
        super().__init__(folder, folder, [])
        self.scratch.mkdir(parents=True)
        (self.source / "a.cpp").write_text("right")
        self.scripts = {"wrong": planted, "right": unchanged}

    def plant(self, mutant):
        return self.program_with(mutant, "wrong")

    def program_with(self, mutant, text):
        program = self.scratch / f"{mutant['name']}-{text}"
        program.write_text(f"#!/bin/sh\n{self.scripts[text]}\n")
        program.chmod(0o755)
        return program


class Verdicts(unittest.TestCase):
    def verdict(self, planted, unchanged):
        with tempfile.TemporaryDirectory() as folder:
            return run.judge(Fake(folder, planted, unchanged), MUTANT)

    def test_a_failed_test_kills(self):
        self.assertEqual(self.verdict("echo '[  FAILED  ] Suite.Test, where'; exit 1", "exit 1"), (True, "killed by Suite.Test"))

    def test_a_crash_kills_only_if_the_unchanged_file_passes(self):
        self.assertEqual(self.verdict("exit 139", "exit 0"), (True, "killed by exit status 139"))
        killed, sentence = self.verdict("exit 139", "exit 139")
        self.assertFalse(killed)
        self.assertIn("fails too", sentence)

    def test_a_program_that_passes_survives(self):
        self.assertEqual(self.verdict("exit 0", "exit 0"), (False, "SURVIVES"))


if __name__ == "__main__":
    unittest.main()
