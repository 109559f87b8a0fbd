# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: stages.py ROOT BUILD

./check runs the stages that it is told to and no others, and stops at the first that fails. Each stage of the table is
short, and its commands and packages exist. The commands themselves, which take long, are replaced. A stage that builds
a part of the targets builds all that its tests name: BUILD, made by Ninja, tells."""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

LONGEST, LONGEST_OF_CI = 25, 90  # minutes
STUBS = """
need_packages() { echo "packages $*"; }
run() {
  echo "run $1"
  [ "$1" != "$FAILING" ]  # as if one of its commands failed
  echo "ran $1"
}
"""
COMMIT = "0123456789abcdef0123456789abcdef01234567"


def printed(*command):
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()


def bash(script):
    """The lines that a script prints which knows the stages and the packages."""
    return printed("bash", "-euc", f". .ci/packages; . .ci/stages; {script}")


class Table(unittest.TestCase):
    def minutes_of(self, name):
        return bash(f'echo "${{minutes[{name}]}}"')[0]

    def seen(self):
        return [name for name in NAMES[1:] if self.minutes_of(name) != "?"]

    def test_every_stage_has_commands(self):
        patterns = re.findall(r"^    ([a-z][^()]*)\)", (ROOT / ".ci/stages").read_text(), re.MULTILINE)
        branches = " ".join(f"{pattern}) echo $name ;;" for pattern in patterns)
        self.assertEqual(bash(f"for name in quick ${{stages[@]}}; do case $name in {branches} esac; done"), ["quick", *NAMES])

    def test_every_stage_is_short(self):
        minutes = {name: int(self.minutes_of(name)) for name in ["tests", *self.seen()]}
        longest = sorted([0, 0, *(minutes[name] for name in self.seen())])
        self.assertLessEqual(longest[-1], LONGEST)
        self.assertLessEqual(minutes["tests"] + longest[-1] + longest[-2], LONGEST_OF_CI)

    def test_the_packages_of_every_stage_are_listed(self):
        groups = bash('for group in "${packages_of_all[@]}" ${packages[@]}; do list=packages_$group; echo "$group ${!list}"; done')
        self.assertGreater(len(groups), 4)

    def test_the_parts_of_the_tests_are_all_tests(self):
        folders = re.findall(r"add_subdirectory\((\w+)\)", (ROOT / "tests/CMakeLists.txt").read_text())
        rooms = re.search(r"foreach\(folder (.*)\)", (ROOT / "tests/experiments/CMakeLists.txt").read_text())[1].split()
        folders = [folder for folder in folders if folder != "experiments"] + [f"experiments/{room}" for room in rooms]
        self.assertEqual(sorted(folder for _, tested in self.parts() for folder in tested), sorted(folders))

    def test_stages_run_every_part_with_assertions_and_with_sanitizers(self):
        text = (ROOT / ".ci/stages").read_text()
        parts = set(re.findall(r"^(\w+)_in\(\) \{$", text, re.MULTILINE)) - {"tests"}
        self.assertEqual(len(parts), len(self.parts()))
        for part in parts:
            for preset in "dev", "asan-ubsan":
                self.assertRegex(text, rf"[) ]{part}_in {preset}\b")

    def parts(self):
        """Of each part of the tests, the targets that it builds and the folders whose tests it runs."""
        parts = re.findall(r'build "\$1" (.*)\n *tests_in "\$1" (.*)', (ROOT / ".ci/stages").read_text())
        return [[bash(f"printf '%s\\n' {words}") for words in part] for part in parts]

    def test_each_part_builds_what_its_tests_name(self):
        self.assertEqual(len(self.parts()), 5)
        made = {line.split(":")[0] for line in printed("ninja", "-C", BUILD, "-t", "targets", "all")}
        for targets, folders in self.parts():
            commands = " ".join(printed("ninja", "-C", BUILD, "-t", "commands", *targets)).split()
            for folder in folders:
                tests = printed("ctest", "--test-dir", BUILD / "tests" / folder, "--show-only=json-v1")
                for test in json.loads("\n".join(tests))["tests"]:
                    # A test whose own program is not built has no command, and fails by itself.
                    named = {word.removeprefix(f"{BUILD}/") for word in test.get("command", ())}
                    self.assertEqual((named & made).difference(commands), set(), f"{folder}: {test['name']}")

    def test_two_stages_that_were_seen_to_pass_are_drawn_and_each_sometimes(self):
        commits = [hashlib.sha1(str(i).encode()).hexdigest() for i in range(200)]
        draws = [line.split() for line in bash(f"for commit in {' '.join(commits)}; do drawn $commit; done")]
        self.assertEqual({len(set(draw)) for draw in draws}, {min(2, len(self.seen()))})
        self.assertEqual({name for draw in draws for name in draw}, set(self.seen()))


class Check(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        shutil.copy(ROOT / "check", self.root)
        shutil.copytree(ROOT / ".ci", self.root / ".ci")
        with (self.root / ".ci/stages").open("a") as stages:
            stages.write(STUBS)
        (self.root / "git").write_text(f"#!/bin/sh\necho {COMMIT}\n")
        (self.root / "git").chmod(0o755)

    def check(self, *arguments, ci="", failing="", status=0):
        """The stages that run, and the groups of packages that are installed."""
        environment = dict(os.environ, CI=ci, FAILING=failing, PATH=f"{self.root}:{os.environ['PATH']}")
        done = subprocess.run([self.root / "check", *arguments], env=environment, capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.said = done.stdout + done.stderr
        return re.findall(r"^ran (.*)", self.said, re.MULTILINE), " ".join(re.findall(r"^packages (.*)", self.said, re.MULTILINE)).split()

    def test_alone_it_runs_the_tests(self):
        self.assertEqual(self.check()[0], ["tests"])
        self.assertIn("All tests passed", self.said)

    def test_in_CI_it_also_runs_what_the_commit_draws(self):
        self.assertEqual(self.check(ci="true")[0], ["tests", *bash(f"drawn {COMMIT}")[0].split()])

    def test_outside_a_repository_it_says_that_nothing_is_drawn(self):
        (self.root / "git").write_text("#!/bin/sh\nexit 128\n")
        self.assertEqual(self.check(ci="true")[0], ["tests"])
        self.assertIn("no commit selects other stages", self.said)

    def test_what_is_named_runs_alone_in_CI_too(self):
        for ci in "", "true":
            ran, packages = self.check("--stage", "matrix", "clang", ci=ci)
            self.assertEqual(ran, ["matrix", "clang"])
            self.assertIn("emulation", packages)
            self.assertNotIn("coq", packages)
            self.assertEqual(self.check("--no-install", "--quick", ci=ci)[0], ["quick"])

    def test_all_run_until_one_fails(self):
        self.assertEqual(self.check("--full", failing="coq", status=1)[0], NAMES[:NAMES.index("coq")])
        self.assertNotIn("All tests passed", self.said)

    def test_the_list_names_all(self):
        self.check("--stages")
        self.assertEqual([line.split()[0] for line in self.said.splitlines()], NAMES)

    def test_what_it_does_not_understand_is_refused(self):
        for arguments, message in ((["--stage"], "--stage needs a name"), (["--stage", "--no-install"], "--stage needs a name"),
                                   (["--stage", "clang", "nonsense"], "no stage is called nonsense"),
                                   (["--stage", "clang", "--full"], "--stage and --full exclude each other"),
                                   (["--quick", "--full"], "--quick and --full exclude each other"), (["clang"], "unknown option clang")):
            self.assertEqual(self.check(*arguments, status=2), ([], []))
            self.assertIn(f"check: {message}", self.said)


if __name__ == "__main__":
    ROOT, BUILD = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))
    NAMES = bash('printf "%s\\n" "${stages[@]}"')
    unittest.main()
