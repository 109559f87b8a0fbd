# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python3 run.py [--corpus] [--part I/N] SOURCE BUILD [NAME...]

A suite that cannot fail proves nothing. Each entry of mutants.json plants one bug in a copy of one file; translation
units that see it are compiled again, with those that CMake compiles together with them, and linked before the
libraries into a program of tests, which is run: it must fail. Where the program is the recorder of the proofs, Gappa must
refuse what it records. A program that crashes has noticed the bug only if it
passes with the unchanged file compiled and linked the same way. Exit status 1 if a mutant survives. Before any is
planted, exit status 2 if the text of one, asked for or not, is not found exactly once in its file, or one of its files
is missing.

--part I/N plants the I-th of N parts, which together are all.

With --corpus nothing but the cases of tests/corpus may tell of the bug, and the case that does is named. Those planted
in the files of other subjects than the fast, exact and filtered paths (CORPUS_PATHS) are left out, those planted in
proofs and tests alone (NO_CORPUS_UNITS), those that change no answer ("changes_answers": false), and those of which no
case of the corpus tells ("in_corpus": false); those of tests/corpus/mutants.json, about constants, stages and guards of
the filtered path, come in.
"""

import argparse
import concurrent.futures
import functools
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import threading

CRASH = "exit status"
SECONDS = 90  # a suite that does not end has noticed something
# The suites that are run where a mutant names none. Those left out are slow, or see their own copy of the headers.
SUITES = {
    "boost_numbers_tests": "*",
    "cell_tests": "*",
    "cell_handling_tests": "*",
    "cell_simulation_tests": "*",
    "contact_tests": "*",
    "filtered_tests": "-FilteredEnvironment.*:FilteredErrorFree.*:FilteredDoubleDouble*:FilteredInteger.*:Signs.*",
    "geometry_tests": "*",
    "lattice_tests": "*",
    "scene_tests": "*",
    "mesh_tests": "*",
    "motion_tests": "*",
    "touchstone_record": "",
}


CORPUS_PATHS = ("geometry/contact/", "robust/exact/", "robust/filtered/")
NO_CORPUS_UNITS = ("robust/proofs/", "tests/")


class Workshop:
    def __init__(self, source, build, programs):
        self.source, self.build = pathlib.Path(source).resolve(), pathlib.Path(build).resolve()
        self.scratch = self.build / "tests" / "mutants"
        self.commands = {program: self.commands_of(program) for program in programs}
        self.controls = {}
        self.at_controls = threading.Lock()

    def commands_of(self, program):
        """The commands that compile and link what the program is made of."""
        return subprocess.run(["ninja", "-C", self.build, "-t", "commands", program],
                              check=True, capture_output=True, text=True).stdout.splitlines()

    def program_with(self, mutant, text):
        """The program of the mutant, linked with `text` as the content of the mutant's file."""
        folder, program = self.scratch / mutant["name"], program_of(mutant)
        shutil.rmtree(folder, ignore_errors=True)  # headers of an earlier run would replace today's
        for unit in units(mutant):
            (folder / unit).parent.mkdir(parents=True, exist_ok=True)
            (folder / unit).write_text((self.source / unit).read_text())
        (folder / mutant["file"]).parent.mkdir(parents=True, exist_ok=True)
        (folder / mutant["file"]).write_text(text)
        for top in re.findall(r'^#include "(?:\.\./)+(\w+)/', text, re.MULTILINE):  # as public headers have it
            if not (folder / top).exists():
                (folder / top).symlink_to(self.source / top)
        commands = {}  # by the objects that they make
        for unit in units(mutant):
            command = compile_command(self.commands[program], str(self.source / unit))
            commands[command[command.index("-o") + 1]] = command
        objects = [self.compile(folder, f"{number}.o", command, units(mutant)) for number, command in enumerate(commands.values())]
        return self.link_tests(folder, program, objects, commands)

    def plant(self, mutant):
        text = (self.source / mutant["file"]).read_text()
        return self.program_with(mutant, text.replace(mutant["old"], mutant["new"]))

    def control(self, mutant):
        """What fails in the mutant's program with its units compiled again, and no bug in them."""
        with self.at_controls:
            of = (program_of(mutant), suites_of(mutant), *units(mutant))
            if of not in self.controls:
                unchanged = dict(mutant, name=f"{mutant['name']}-control")
                program = self.program_with(unchanged, (self.source / mutant["file"]).read_text())
                self.controls[of] = first_failure(program, program.parent, suites_of(mutant))
                program.unlink()
            return self.controls[of]

    def compile(self, folder, target, command, replaced):
        """Compiles what the command does, with the units of the mutant in place of their originals."""
        file = command[command.index("-c") + 1]
        copy = folder / f"{target}.cpp"
        planted = {str(self.source / unit): folder / unit for unit in replaced}
        copy.write_text("".join(f'#include "{planted.get(path, path)}"\n' for path in files_of(file)))
        command[command.index("-o") + 1] = str(folder / target)
        command[command.index("-c") + 1] = str(copy)
        dependencies = [i for i, word in enumerate(command) if word in ("-MF", "-MT")]
        for i in reversed(dependencies):
            del command[i:i + 2]
        command = [word for word in command if word not in ("-MD", "-O1", "-O2", "-O3")]
        # Found first: the mutated header. Answers do not depend on -O; the kernels compile three times faster at -O0
        # than at -O1, but the simulations of a cell run thirty times slower.
        level = "-O1" if any(unit.startswith("experiments/") for unit in replaced) else "-O0"
        command[1:1] = [f"-I{folder}", level, "-w"]
        run(command, self.build, "does not compile")
        return str(folder / target)

    def link_tests(self, folder, program, objects, replaced):
        # A unit of the program itself takes the place of its object, whose inline functions would win.
        command = [word for word in link_command(self.commands[program], program) if word not in replaced]
        at = command.index("-o") + 1
        command[at] = str(folder / program)
        command[at + 1:at + 1] = objects  # before the archives, so that theirs are not taken
        run(command, self.build, "does not link")
        return folder / program


def units(mutant):
    """What has to be compiled again: for a header, the units that include it."""
    return mutant.get("units", [mutant["file"]])


def program_of(mutant):
    return mutant.get("program", "contact_tests")


def suites_of(mutant):
    return mutant["suites"] if "suites" in mutant else SUITES[program_of(mutant)]


@functools.cache
def files_of(file):
    """The source files that are compiled with this file: itself, or those that CMake has it include."""
    if "/Unity/" not in file:
        return [file]
    return re.findall(r'^#include "(.+)"$', pathlib.Path(file).read_text(), re.MULTILINE)


def compile_command(commands, file):
    """The one command among those of a program that compiles the file: targets may compile a file in several ways."""
    found = [words for words in map(shlex.split, commands) if "-c" in words and file in files_of(words[words.index("-c") + 1])]
    if len(found) != 1:
        raise ValueError(f"{len(found)} commands of the program compile {file}")
    words = found[0]
    launcher = [i for i, word in enumerate(words) if pathlib.Path(word).name == "ccache"]
    return words[launcher[0] + 1:] if launcher else words  # a cache would not see the mutated header


def link_command(commands, program):
    # The last command that makes the program; what CMake chains before and after it is no concern of ours.
    link = [line for line in commands if f"-o {program}" in line or f"-o tests/{program}" in line][-1]
    return shlex.split(re.sub(r"^: && | && :$", "", link).split(" && ")[0])


def run(command, folder, complaint):
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if result.returncode != 0:
        raise ValueError(f"{complaint}: {result.stderr[-600:]}")


def first_fault_of_proof(program):
    """The first sign that a function takes to be certain and that is not proved to be, as what is recorded says."""
    prove = pathlib.Path(__file__).resolve().parents[3] / "robust" / "proofs" / "prove.py"
    result = subprocess.run([sys.executable, "-B", prove, program, "gappa", "--uses"], capture_output=True, text=True)
    return None if result.returncode == 0 else f"the proof: {(result.stdout + result.stderr).strip().splitlines()[-1]}"


def first_failure(program, folder, suites):
    if pathlib.Path(program).name == "touchstone_record":
        return first_fault_of_proof(program)
    environment = dict(os.environ, RC_PARAMS="seed=2026 noshrink=1 max_success=150")
    try:
        result = subprocess.run([program, "--gtest_fail_fast", f"--gtest_filter={suites}"], cwd=folder,
                                env=environment, capture_output=True, text=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return "the time limit"
    if result.returncode == 0:
        return None
    failed = re.search(r"\[  FAILED  \] (\S+?)[,\s]", result.stdout)
    case = re.search(r"case (\S+) of (\S+)", result.stdout)
    name = failed.group(1) if failed else f"{CRASH} {result.returncode}"
    return f"{name}, case {case.group(1)} of {case.group(2)}" if case else name


def misplaced(source, mutants):
    """A sentence for each mutant that the sources have no place for."""
    for mutant in mutants:
        missing = [file for file in {mutant["file"], *units(mutant)} if not (pathlib.Path(source) / file).is_file()]
        if missing:
            yield f"{mutant['name']}: there is no {', '.join(sorted(missing))}"
        elif (count := (pathlib.Path(source) / mutant["file"]).read_text().count(mutant["old"])) != 1:
            yield f"{mutant['name']}: its text stands {count} times in {mutant['file']}"


def judge(workshop, mutant):
    """(killed, sentence) of one mutant."""
    try:
        program = workshop.plant(mutant)
        killer = first_failure(program, program.parent, suites_of(mutant))
        program.unlink()
        if killer and killer.startswith(CRASH) and (failure := workshop.control(mutant)):
            raise ValueError(f"without the bug, the program that is linked for it fails too: {failure}")
    except ValueError as error:
        return False, f"cannot be planted: {error}"
    return (True, f"killed by {killer}") if killer else (False, "SURVIVES")


def read_mutants(source, corpus):
    """Each with the program and the suites that are to tell of it."""
    tests = pathlib.Path(source) / "tests"
    mutants = json.loads((tests / "system" / "mutants" / "mutants.json").read_text())
    if not corpus:
        return mutants
    mutants = [mutant for mutant in mutants
               if mutant["file"].startswith(CORPUS_PATHS) and not all(unit.startswith(NO_CORPUS_UNITS) for unit in units(mutant))
               and mutant.get("changes_answers", True) and mutant.get("in_corpus", True)]
    mutants += json.loads((tests / "corpus" / "mutants.json").read_text())
    return [dict(mutant, program="corpus_tests", suites="Corpus.*") for mutant in mutants]


def part_of(mutants, part):
    """The I-th part of N, from "I/N": every N-th mutant, because neighbours take about as long as each other."""
    i, n = map(int, part.split("/"))
    if not 1 <= i <= n:
        raise ValueError(f"there is no part {part}")
    return mutants[i - 1::n]


def parsed(arguments):
    parser = argparse.ArgumentParser()
    parser.add_argument("--corpus", action="store_true")
    parser.add_argument("--part", default="1/1")
    parser.add_argument("source")
    parser.add_argument("build")
    parser.add_argument("names", nargs="*")
    return parser.parse_args(arguments)


def main(*arguments):
    options = parsed(list(arguments))
    source, build, corpus = options.source, options.build, options.corpus
    known = read_mutants(source, corpus)
    faults = [*misplaced(source, known), *(f"{name}: there is no such mutant" for name in
                                           set(options.names) - {mutant["name"] for mutant in known})]
    if faults:
        print("\n".join(faults))
        return 2
    mutants = [mutant for mutant in known if not options.names or mutant["name"] in options.names]
    mutants = part_of(mutants, options.part)
    workshop = Workshop(source, build, sorted({program_of(mutant) for mutant in mutants}))
    programs = sorted({(program_of(mutant), suites_of(mutant)) for mutant in mutants})
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        failures = pool.map(lambda of: first_failure(workshop.build / "tests" / of[0], workshop.build, of[1]), programs)
        for (program, _), failure in zip(programs, failures):
            if failure:
                print(f"{program} fails without any bug planted: {failure}")
                return 1
    survivors = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        for mutant, (killed, sentence) in zip(mutants, pool.map(lambda m: judge(workshop, m), mutants)):
            survivors += not killed
            print(f"{mutant['name']}: {sentence} ({mutant['bug']})", flush=True)
    print(f"{len(mutants) - survivors} of {len(mutants)} mutants killed{' by the corpus' if corpus else ''}")
    return 1 if survivors or not mutants else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
