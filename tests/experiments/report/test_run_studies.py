# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_run_studies.py TOUCHSTONE SOURCE SCRATCH

What ./reproduce did is not done again, and what was half done goes on: with a program in place of touchstone that notes its
calls. The commands in the list of studies are such as touchstone knows. A file of results is replaced whole, or stays as it was."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

TOUCHSTONE, SOURCE, SCRATCH = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
sys.path.insert(0, str(SOURCE / "experiments/report"))

from replacing import replacing  # noqa: E402
from studies import MESHES, OUTPUT, modules  # noqa: E402

RUNS = [module.RUN for module in modules().values()]

PATIENCE = 60  # seconds, for what takes one

# Notes its call; fails, or waits to be killed, at the study that a file names.
PROGRAM = """#!/bin/sh
[ "$1" = methods ] && { echo "fast about fast"; exit; }
echo "$*" >> calls
output=; for word; do [ "$before" = --output ] && output=$word; before=$word; done
[ "$1" = "$(cat fails 2>/dev/null)" ] && exit ${STATUS:-1}
[ "$1" = "$(cat waits 2>/dev/null)" ] && { echo begun > "$output/soak.csv"; echo $$ > waiting; exec tail -f /dev/null; }
[ -n "$output" ] && echo '{}' > "$output/run.json"
exit 0
"""


class Studies(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(dir=SCRATCH)))
        (self.folder / "cache/meshes").mkdir(parents=True)
        (self.folder / "cache/meshes/a.obj").write_text("v 0 0 0\n")
        self.write_program(PROGRAM)

    def write_program(self, text, name="touchstone"):
        program = self.folder / name
        program.write_text(text)
        program.chmod(0o755)

    def start(self, *options):
        return subprocess.Popen([sys.executable, "-B", str(SOURCE / "experiments/report/run_studies.py"), "./touchstone", "results", *options],
                                cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                env=dict(os.environ, STATUS=self.status), start_new_session=True)

    status = "1"

    def run_all(self, *options, expected=0):
        """The calls that were made."""
        (self.folder / "calls").unlink(missing_ok=True)
        process = self.start(*options)
        complaint = process.communicate(timeout=PATIENCE)[1]
        self.assertEqual(process.returncode, expected, complaint)
        calls = self.folder / "calls"
        return calls.read_text().splitlines() if calls.exists() else []

    def quick_calls(self):
        return sum(len(study.quick) for study in RUNS if study.quick)

    def test_runs_each_once(self):
        self.assertEqual(len(self.run_all()), self.quick_calls())
        self.assertEqual(self.run_all(), [])

    def test_the_first_study_runs_alone_by_a_program_of_its_own_and_is_kept(self):
        self.write_program(PROGRAM.replace("calls", "calls_first"), "first_study")
        self.assertEqual(self.run_all("--first-study", "./first_study", "--only-first"), [])
        self.assertEqual([call.split()[0] for call in (self.folder / "calls_first").read_text().splitlines()], ["near-edge"])
        calls = self.run_all("--first-study", "./first_study")
        self.assertEqual(len(calls), self.quick_calls() - 1)
        self.assertFalse(any(call.startswith("near-edge --") for call in calls))
        self.write_program(PROGRAM.replace("calls", "calls_again"), "first_study")
        self.assertEqual(self.run_all("--first-study", "./first_study"), [])
        self.assertTrue((self.folder / "calls_again").exists())

    def test_another_program_runs_all_again(self):
        self.run_all()
        self.write_program(PROGRAM + "# another\n")
        self.assertEqual(len(self.run_all()), self.quick_calls())

    def test_other_meshes_run_again_what_they_are_asked_in(self):
        self.run_all()
        (self.folder / "cache/meshes/a.obj").write_text("v 1 0 0\n")
        self.assertEqual([call.split()[1] for call in self.run_all()], ["cache/meshes/a.obj"])

    def test_without_meshes_the_others_run(self):
        shutil.rmtree(self.folder / "cache")
        calls = self.run_all()
        self.assertEqual(len(calls), self.quick_calls() - 1)
        self.assertFalse((self.folder / "results/meshes").exists())

    def test_full_runs_anew_and_quick_keeps_it(self):
        self.run_all()
        full = self.run_all("--full")
        self.assertTrue(any(call.startswith("bench-scenes") for call in full))
        self.assertFalse(any("--quick" in call or "--samples" in call for call in full))
        self.assertEqual(self.run_all(), [])

    def test_a_failure_is_told_and_the_others_run(self):
        (self.folder / "fails").write_text("tradeoff")
        self.assertEqual(len(self.run_all(expected=1)), self.quick_calls())
        (self.folder / "fails").unlink()
        again = self.run_all()
        self.assertEqual([call.split()[0] for call in again], ["tradeoff"])
        self.assertTrue(again[0].endswith("--force"))

    def test_an_interrupt_stops_all(self):
        self.status = "130"
        (self.folder / "fails").write_text("near-edge")
        calls = self.run_all(expected=130)
        self.assertEqual(calls[-1].split()[0], "near-edge")

    def wait_for(self, name, process):
        end = time.monotonic() + PATIENCE
        while not (self.folder / name).exists() or not (self.folder / name).read_text():
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), end)
        return int((self.folder / name).read_text())

    def kill_in(self, study, *options):
        """Kills a run, and what it runs, in the middle of a study."""
        (self.folder / "waiting").unlink(missing_ok=True)
        (self.folder / "waits").write_text(study)
        process = self.start(*options)
        self.wait_for("waiting", process)
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        (self.folder / "waits").unlink()

    def test_what_was_killed_halfway_runs_again(self):
        self.kill_in("stability")
        self.assertEqual(self.run_all()[0].split()[0], "stability")

    def test_quick_does_not_destroy_what_full_has_begun(self):
        self.kill_in("stability", "--full")
        self.assertFalse(any(call.startswith("stability") for call in self.run_all()))
        self.assertTrue(any(call.startswith("stability") for call in self.run_all("--full")))

    def test_two_runs_in_one_folder_are_refused_while_the_first_ones_study_lives(self):
        (self.folder / "waits").write_text("near-edge")
        first = self.start()
        self.addCleanup(os.kill, self.wait_for("waiting", first), signal.SIGKILL)
        first.kill()  # its study lives on
        first.wait()
        first.stderr.close()
        second = self.start()
        self.assertIn("another run is working in results", second.communicate(timeout=PATIENCE)[1])
        self.assertEqual(second.returncode, 1)

    def test_nothing_is_written_into_a_foreign_folder(self):
        foreign = self.folder / "results/thesis/chapter.tex"
        foreign.parent.mkdir(parents=True)
        foreign.write_text("mine")
        calls = self.run_all(expected=1)
        self.assertEqual(len(calls), self.quick_calls() - 1)
        self.assertFalse(any(call.startswith("thesis") for call in calls))
        self.assertEqual(list(foreign.parent.iterdir()), [foreign])


class Commands(unittest.TestCase):
    def test_are_known_to_the_program(self):
        for study in RUNS:
            for call in [*study.full, *(study.quick or [])]:
                with self.subTest(call=call):
                    asked = subprocess.run([TOUCHSTONE, *("a.obj" if word == MESHES else word.replace(OUTPUT, "none") for word in call), "--help"],
                                           capture_output=True, text=True)
                    self.assertEqual(asked.returncode, 0, asked.stderr)
                    options = [word for word in call if word.startswith("--")]
                    for option in options:
                        self.assertIn(option, asked.stdout)
                    if "--output" in options:
                        self.assertIn("--force", asked.stdout)

    def test_have_an_order(self):
        self.assertEqual(len({study.place for study in RUNS}), len(RUNS))


class Replacing(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.page = self.folder / "report.html"
        self.page.write_text("earlier")

    def test_gives_the_new_file_the_name(self):
        with replacing(self.page) as file:
            file.write_text("new")
            self.assertEqual(self.page.read_text(), "earlier")
        self.assertEqual(self.page.read_text(), "new")
        self.assertEqual(list(self.folder.iterdir()), [self.page])

    def test_keeps_the_earlier_file_where_the_new_one_fails(self):
        with self.assertRaises(OSError), replacing(self.page) as file:
            file.write_text("half")
            raise OSError
        self.assertEqual(self.page.read_text(), "earlier")
        self.assertEqual(list(self.folder.iterdir()), [self.page])

    def test_follows_no_link(self):
        link = self.folder / "index.html"
        link.symlink_to(self.page)
        with replacing(link) as file:
            file.write_text("new")
        self.assertEqual(self.page.read_text(), "earlier")
        self.assertFalse(link.is_symlink())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
