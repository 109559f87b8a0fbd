# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python3 run.py SOURCE BUILD [NAME...]

A suite that cannot fail proves nothing. Each entry of mutants.json plants one bug in a copy of one file of the fast or
the exact path; its translation unit is compiled again, linked before the libraries into the contact tests, and the
tests are run: they must fail. Exit status 1 if a mutant survives, or if its text is not found exactly once.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

SECONDS = 90  # a suite that does not end has noticed something


class Workshop:
    def __init__(self, source, build):
        self.source, self.build = pathlib.Path(source), pathlib.Path(build)
        self.scratch = self.build / "tests" / "mutants"
        commands = json.loads((self.build / "compile_commands.json").read_text())
        self.commands = {entry["file"]: shlex.split(entry["command"]) for entry in commands}
        ninja = subprocess.run(["ninja", "-C", self.build, "-t", "commands", "contact_tests"],
                               check=True, capture_output=True, text=True).stdout
        # The last command that makes the program; what CMake chains before and after it is no concern of ours.
        link = [line for line in ninja.splitlines() if "-o contact_tests" in line or "-o tests/contact_tests" in line][-1]
        self.link = shlex.split(re.sub(r"^: && | && :$", "", link).split(" && ")[0])

    def plant(self, mutant):
        """The mutated copy of the file, and the unit to compile with it."""
        original = self.source / mutant["file"]
        text = original.read_text()
        if text.count(mutant["old"]) != 1:
            raise ValueError(f"its text stands {text.count(mutant['old'])} times in {mutant['file']}")
        folder = self.scratch / mutant["name"]
        copy = folder / mutant["file"]
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(text.replace(mutant["old"], mutant["new"]))
        unit = mutant.get("unit", mutant["file"])
        if unit != mutant["file"]:  # a header: the unit that includes it is compiled with the copy found first
            (folder / unit).write_text((self.source / unit).read_text())
        return folder, folder / unit, self.source / unit

    def compile(self, folder, unit, original):
        command = list(self.commands[str(original)])
        target = folder / "mutant.o"
        command[command.index("-o") + 1] = str(target)
        command[command.index("-c") + 1] = str(unit)
        dependencies = [i for i, word in enumerate(command) if word in ("-MF", "-MT")]
        for i in reversed(dependencies):
            del command[i:i + 2]
        command = [word for word in command if word not in ("-MD", "-O2", "-O3")]
        command[1:1] = [f"-I{folder}", "-O1", "-w"]  # quicker to compile; answers do not depend on it
        run(command, self.build, "does not compile")
        return target

    def link_tests(self, folder, mutated):
        command = list(self.link)
        at = command.index("-o") + 1
        program = folder / "contact_tests"
        command[at] = str(program)
        command.insert(at + 1, str(mutated))  # before the archives, so that theirs is not taken
        run(command, self.build, "does not link")
        return program


def run(command, folder, complaint):
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if result.returncode != 0:
        raise ValueError(f"{complaint}: {result.stderr[-600:]}")


def first_failure(program, folder):
    environment = dict(os.environ, RC_PARAMS="seed=2026 noshrink=1 max_success=150")
    try:
        result = subprocess.run([program, "--gtest_fail_fast"], cwd=folder, env=environment, capture_output=True,
                                text=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return "the time limit"
    if result.returncode == 0:
        return None
    failed = re.search(r"\[  FAILED  \] (\S+?)[,\s]", result.stdout)
    return failed.group(1) if failed else f"exit status {result.returncode}"


def judge(workshop, mutant):
    """(killed, sentence) of one mutant."""
    try:
        folder, unit, original = workshop.plant(mutant)
        program = workshop.link_tests(folder, workshop.compile(folder, unit, original))
        killer = first_failure(program, folder)
        program.unlink()
    except ValueError as error:
        return False, f"cannot be planted: {error}"
    return (True, f"killed by {killer}") if killer else (False, "SURVIVES")


def main(source, build, *names):
    workshop = Workshop(source, build)
    mutants = json.loads((pathlib.Path(__file__).parent / "mutants.json").read_text())
    mutants = [mutant for mutant in mutants if not names or mutant["name"] in names]
    if failure := first_failure(workshop.build / "tests" / "contact_tests", workshop.build):
        print(f"the suite fails without any bug planted: {failure}")
        return 1
    survivors = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        for mutant, (killed, sentence) in zip(mutants, pool.map(lambda m: judge(workshop, m), mutants)):
            survivors += not killed
            print(f"{mutant['name']}: {sentence} ({mutant['bug']})", flush=True)
    print(f"{len(mutants) - survivors} of {len(mutants)} mutants killed")
    return 1 if survivors or not mutants else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
