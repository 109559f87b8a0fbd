# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: every_command.py TOUCHSTONE SOURCE SCRATCH

What holds of every subcommand, as the program's own help lists them: with --json it prints its tables as JSON, with --quiet
nothing, and no file of its names a folder of the machine; a result that cannot be written to standard output never ends with status 0; a folder or file of results is neither
written by two runs nor written over unasked, and all this is known before a run computes. A new subcommand needs a line in
COMMANDS, unless it is a study with a chapter. Exit status 1 otherwise.
"""
import csv
import json
import math
import os
import pathlib
import pty
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

TOUCHSTONE, SOURCE, SCRATCH = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
sys.path.append(str(SOURCE / "experiments/report"))

import studies

PATIENCE = 300  # seconds, for what takes a few
CELL = "cells/aristo.json"
MAPS = "map-<spot>-<test>-<distance>.csv"
OUTPUT = "OUTPUT"  # stands for a folder or file that is not there yet

MESH = "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n"
CASE = ('{"id":"a","ball":{"center":[1,1,1],"radius":1},"polygon":{"outer":[[0,0,0],[4,0,0],[0,4,0]]},'
        '"expected":{"contact":true}}\n')

# Of each subcommand, calls that take a moment: they print something, and those with OUTPUT write it. Those of the studies with a
# chapter follow.
COMMANDS = {
    "ask": [["--ball", "1,1,1,1", "--polygon", "0 0, 4 0, 0 4"]],
    "judge": [["--methods", "fast", "case.jsonl"]],
    "methods": [[]],
    "angles": [["--methods", "fast", "--families", "l", "--samples", "1", "--output", OUTPUT]],
    "cases": [["--samples", "3"]],
    "bench": [["--family", "far", "--samples", "5", "--repetitions", "1", "--output", OUTPUT]],
    "merge": [["part", "--output", OUTPUT]],
    "plan": [[]],
    "soak": [["--samples", "5", "--output", OUTPUT], ["--samples", "5", "--print"]],
    "scenes": [["mesh.obj", "--samples", "2"], ["mesh.obj", "--samples", "2", "--output", OUTPUT]],
    "show": [["case.jsonl"]],
    "completion": [["bash"], ["zsh"]],
    "manual": [["--output", OUTPUT]],
    "cell new": [[OUTPUT]],
    "cell show": [[CELL], [CELL, "--output", OUTPUT]],
    "cell run": [[CELL, "--methods", "fast", "--output", OUTPUT]],
    "cell area": [[CELL, "--angle-step", "90", "--length-step", "2000", "--no-pictures", "--output", OUTPUT]],
    "cell layout": [["--quick", "--no-pictures", "--output", OUTPUT]],
    "cell missed": [["--samples", "5", "--no-pictures", "--output", OUTPUT]],
    "cell export": [[CELL, "exported.html"]],
    "cell serve": [["--port", "0"]],
    "regress": [["--methods", "fast", "--samples", "1", "--output", OUTPUT]],
    "columns": [[]],
    "corpus make": [[OUTPUT]],
    "corpus check": [[str(SOURCE / "tests/corpus/features.jsonl")]],
    "cell cases": [[CELL]],
    "corpus shrink": [["wrong.jsonl", "--method", "thesis"]],
    "thesis": [["--quick", "--samples", "100", "--no-pictures", "--output", OUTPUT]],
}
for study in studies.modules().values():
    name, *options = study.RUN.tiny or [""]
    if name and name not in {command.split()[0] for command in COMMANDS}:
        COMMANDS[name] = [[*("mesh.obj" if word == studies.MESHES else word for word in options), "--output", OUTPUT]]

# What prints no table: cases, pages, scripts, or a line that says what was written.
WITHOUT_TABLE = ("ask", "cases", "show", "completion", "manual", "cell new", "cell export", "cell serve", "cell cases", "corpus make",
                 "corpus check", "corpus shrink", "plan", "soak --samples 5 --print")
WITHOUT_JSON = WITHOUT_TABLE + ("scenes",)  # its answers are lines of JSON already
LISTS = ("methods", "columns")  # one JSON array; they print nothing else, so that --quiet would mean nothing
ANSWERS = ("judge", "scenes mesh.obj --samples 2")  # on standard output, also with --quiet
# These write a folder only if --output names one; all others write to results/NAME.
WITHOUT_FOLDER = {"judge", "merge", "scenes", "regress", "cell show", "cell run"}


def subcommands(*words):
    """The names of all that can be called, from the help."""
    text = subprocess.run([TOUCHSTONE, *words, "--help"], capture_output=True, text=True, check=True, timeout=PATIENCE).stdout
    listed = text.partition("\n\nUsage:")[2].partition("\nOptions:\n")[0]
    names = re.findall(r"^  ([a-z]\S*)", listed, re.MULTILINE)
    return [name for word in names for name in subcommands(*words, word)] if names else [" ".join(words)]


def writes(way):
    return any(OUTPUT in word for word in way)


def is_one_of(call, beginnings):
    return any((" ".join(call) + " ").startswith(words + " ") for words in beginnings)


def json_of(field):
    """A field of a CSV file, as --json prints it: a number, null where it is empty, or a text."""
    try:
        number = json.loads(field or "null")
        return number if number is None or type(number) in (int, float) and math.isfinite(number) else field
    except ValueError:
        return field


def calls():
    return [[*name.split(), *way] for name, ways in COMMANDS.items() for way in ways]


def content(folder):
    return {str(path.relative_to(folder)): path.read_bytes() if path.is_file() else None for path in sorted(folder.rglob("*"))}


def places_in(folder):
    """The files that name a folder of this machine, with that folder."""
    places = [SOURCE.resolve(), pathlib.Path(TOUCHSTONE).resolve().parent, pathlib.Path.home(), tempfile.gettempdir(), SCRATCH]
    return [(str(file), str(place)) for file in sorted(folder.rglob("*")) if file.is_file() for place in places
            if f"{place}/".encode() in file.read_bytes()]


class EveryCommand(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        SCRATCH.mkdir(parents=True)
        self.addCleanup(shutil.rmtree, SCRATCH)
        shutil.copytree(SOURCE / "experiments/thesis/cell/cells", SCRATCH / "cells")
        (SCRATCH / "mesh.obj").write_text(MESH)
        (SCRATCH / "case.jsonl").write_text(CASE)
        drawn = subprocess.run([TOUCHSTONE, "cases", "--samples", "1", "--failing", "thesis"], capture_output=True, text=True, check=True)
        (SCRATCH / "wrong.jsonl").write_text(drawn.stdout)
        subprocess.run([TOUCHSTONE, "soak", "--samples", "5", "--part", "1/1", "--quiet", "--output", SCRATCH / "part"], check=True)

    def run_in(self, call, output, **options):
        words = [TOUCHSTONE, *(word.replace(OUTPUT, str(output)) for word in call)]
        return subprocess.run(words, cwd=SCRATCH, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True, timeout=PATIENCE, **options)

    def help_of(self, name):
        return self.run_in([*name.split(), "--help"], "", stdout=subprocess.PIPE).stdout

    def test_has_a_call_here(self):
        self.assertEqual(sorted(subcommands()), sorted(COMMANDS))

    def test_keeps_its_help_within_the_width_of_the_terminal(self):
        for name in ("", *COMMANDS, "cell", "corpus"):
            for width in (80, 120):
                with self.subTest(command=name, width=width):
                    text = self.run_in([*name.split(), "--help"], "", stdout=subprocess.PIPE, env={**os.environ, "COLUMNS": str(width)}).stdout
                    self.assertEqual([line for line in text.splitlines() if len(line) > width and len(line.split()) > 1], [])
                    self.assertNotIn("\n\n\n", text)
                    self.assertIsNone(re.search("Needs:|Excludes:|UINT|FLOAT|TEXT:|18446744073709551615", text), text)

    def test_says_that_it_reads_a_terminal(self):
        for call, what in ((["judge"], "cases"), (["show", "-"], "cases"), (["scenes", "mesh.obj", "--balls", "-"], "balls")):
            with self.subTest(call=call):
                ours, theirs = pty.openpty()
                process = subprocess.Popen([TOUCHSTONE, *call], cwd=SCRATCH, stdin=theirs, stdout=subprocess.DEVNULL,
                                           stderr=subprocess.PIPE, text=True)
                said = process.stderr.readline()
                os.write(ours, b"\x04")
                process.communicate(timeout=PATIENCE)
                os.close(ours)
                os.close(theirs)
                self.assertEqual(said, f"touchstone: reading {what} from standard input; control-D on an empty line ends it\n")

    def test_complains_once_and_begins_with_its_name(self):
        (SCRATCH / "half.jsonl").write_text('{"id":\n')
        calls = [[*name.split(), "--no-such-option", "5"] for name in COMMANDS] + [
            [], ["cell"], ["jugde"], ["near-edge", "--samples", "many"], ["near-edge", "--oracle", "exakt"], ["meshes"],
            *([command, "nowhere"] for command in ("judge", "show", "cell run", "cell show")), ["meshes", "nowhere.obj"], ["merging", "nowhere.obj"],
            ["judge", "half.jsonl"], ["show", "half.jsonl"], ["scenes", "mesh.obj", "--balls", "nowhere"],
            ["corpus", "shrink", "nowhere", "--method", "fast"], ["regress", "--baseline", "nowhere"]]
        for call in calls:
            with self.subTest(call=call):
                done = self.run_in(" ".join(call).split(), "", stdout=subprocess.DEVNULL)
                self.assertEqual(done.returncode, 2)
                complaints = [line for line in done.stderr.splitlines() if line.startswith("touchstone: ")]
                self.assertEqual(len(complaints), 1, done.stderr)
                if call not in ([], ["cell"]):  # these print what there is first
                    self.assertEqual(done.stderr, complaints[0] + "\n")
                if "nowhere" in " ".join(call):
                    self.assertIn("No such file or directory", done.stderr)
                if "--no-such-option" in call:
                    self.assertRegex(done.stderr, r"--no-such-option( 5)?\b")

    def test_ends_its_help_with_an_example_that_is_understood(self):
        """The example names a command and options that there are: its help, asked for behind them, is printed."""
        for name in COMMANDS:
            with self.subTest(command=name):
                text = self.help_of(name)
                self.assertNotIn(str(SOURCE), text)
                examples = text.rpartition("\nExample")[2].replace(" \\\n", "").splitlines()[1:]
                self.assertTrue(examples)
                for example in examples:
                    words = shlex.split(example.partition("&&")[0])
                    self.assertEqual(words[:1 + len(name.split())], ["touchstone", *name.split()])
                    known = self.help_of(name)
                    for word in words:
                        if word.startswith("--"):
                            self.assertRegex(known, rf"(?m)^  {re.escape(word)}\b")

    def test_is_in_the_completion_and_the_manual(self):
        bash = self.run_in(["completion", "bash"], "", stdout=subprocess.PIPE).stdout
        self.run_in(["manual"], SCRATCH, stdout=subprocess.DEVNULL)
        for name in COMMANDS:
            with self.subTest(command=name):
                self.assertIn(f"'{name}') words=", bash)
                page = (SCRATCH / "results/manual" / f"touchstone-{name.replace(' ', '-')}.1").read_text()
                self.assertIn(".SH EXAMPLES", page)
        self.assertEqual(subprocess.run(["bash", "-n"], input=bash, text=True).returncode, 0)

    def described(self, call, table):
        """The columns of the file as the program describes them, as a pattern."""
        name = re.escape(" ".join(call[:2]) if call[0] == "cell" else "soak" if call[0] == "merge" else call[0])  # of the part
        described = self.run_in(["columns", table, "--markdown"], "", stdout=subprocess.PIPE).stdout
        section = re.search(rf"^## `{re.escape(table)}` \({name}\)\n(.*?)(?=^##|\Z)", described, re.M | re.S)
        self.assertTrue(section, described)
        columns = re.findall(r"^\| `(.*?)` \|", section[1], re.M)
        return ",".join(re.sub(r"<\w+>", ".+", re.escape(column)) for column in columns)

    def test_prints_its_tables_as_json_and_describes_them(self):
        for number, call in enumerate(calls()):
            if is_one_of(call, WITHOUT_JSON):
                continue
            with self.subTest(call=call):
                output = SCRATCH / f"tables-{number}"
                done = self.run_in([*call, "--json"], output.name, stdout=subprocess.PIPE)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                printed = json.loads(done.stdout)
                self.assertIsInstance(printed, list if is_one_of(call, LISTS) else dict)
                self.assertTrue(printed)
                self.assertEqual(places_in(output), [])
                written = sorted(output.rglob("*.csv"))
                if writes(call) and call[0] != "bench":
                    self.assertEqual(sorted(printed), [table.name for table in written if not table.name.startswith("map-")])
                for table in written:
                    with open(table, newline="") as file:
                        heading, *rows = csv.reader(file)
                    self.assertRegex(",".join(heading), rf"\A{self.described(call, re.sub('^map-.*', MAPS, table.name))}\Z")
                    if table.name in printed:
                        self.assertEqual(printed[table.name], [dict(zip(heading, map(json_of, row))) for row in rows])

    def test_prints_nothing_where_it_is_to_be_quiet(self):
        for number, call in enumerate(calls()):
            if is_one_of(call, WITHOUT_TABLE) or (is_one_of(call, LISTS + ANSWERS) and not writes(call)):
                continue
            with self.subTest(call=call):
                done = self.run_in([*call, "--quiet"], SCRATCH / f"quiet-{number}", stdout=subprocess.PIPE)
                self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        done = self.run_in(["soak", "--samples", "5", "--quiet"], "", stdout=None, preexec_fn=lambda: os.close(1))
        self.assertEqual((done.returncode, done.stderr), (0, ""))  # it needs no standard output

    def test_names_its_folder_alike(self):
        without = set()
        for name in COMMANDS:
            with self.subTest(command=name):
                option = re.search(r"^  --output FOLDER(.*?)^  --", self.help_of(name), re.M | re.S)
                default = option and re.search(r"\sDefault:\s+(\S+)\.\s", option[1])
                if default:
                    self.assertEqual(default[1], "results/" + name.replace(" ", "-"))
                elif option:
                    without.add(name)
        self.assertEqual(without, WITHOUT_FOLDER)

    def test_says_that_standard_output_cannot_be_written_before_it_computes(self):
        asked = [*calls(), *([*name.split(), "--help"] for name in COMMANDS), ["--help"]]
        for number, call in enumerate(asked):
            for how, reason in (("full", "No space left on device"), ("closed", "Bad file descriptor")):
                with self.subTest(call=call, stdout=how):
                    with open("/dev/full" if how == "full" else os.devnull, "w") as out:
                        close = {} if how == "full" else {"preexec_fn": lambda: os.close(1)}
                        done = self.run_in(call, SCRATCH / f"{how}-{number}", stdout=out, **close)
                    self.assertEqual(done.returncode, 2, done.stderr)
                    self.assertIn("cannot be written: " + reason, done.stderr)
                    self.assertEqual(sorted(path.name for path in SCRATCH.iterdir()), ["case.jsonl", "cells", "mesh.obj", "part", "wrong.jsonl"])

    def test_fails_where_what_it_printed_is_lost(self):
        """A pipe without a reader takes no byte, and no command knows before it writes one."""
        for number, call in enumerate(calls()):
            with self.subTest(call=call):
                done = self.run_unread(call, SCRATCH / f"unread-{number}", signal.SIG_IGN)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn("standard output: cannot be written: Broken pipe\n", done.stderr)

    def test_ends_by_the_signal_where_nobody_reads_standard_output(self):
        self.assertEqual(self.run_unread(["methods"], "", signal.SIG_DFL).returncode, -signal.SIGPIPE)

    def run_unread(self, call, output, on_pipe):
        reading, writing = os.pipe()
        os.close(reading)
        with open(writing, "w") as out:
            return self.run_in(call, output, stdout=out, restore_signals=False,
                               preexec_fn=lambda: signal.signal(signal.SIGPIPE, on_pipe))

    def hold(self, folder):
        """A run that holds the folder until what is returned is closed: it waits for balls from a pipe, which it opens when it
        has its folder."""
        pipe = SCRATCH / f"{folder.name}.balls"
        os.mkfifo(pipe)
        process = subprocess.Popen([TOUCHSTONE, "scenes", "mesh.obj", "--balls", str(pipe), "--output", str(folder)], cwd=SCRATCH,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process, open(pipe, "w")

    def test_writes_nothing_into_a_folder_that_another_run_holds(self):
        folder = SCRATCH / "held"
        process, balls = self.hold(folder)
        with balls:
            for call in filter(writes, calls()):
                for more in ([], ["--force"], ["--resume"]):
                    if more == ["--resume"] and "--resume" not in self.help_of(call[0]):
                        continue
                    with self.subTest(call=call, more=more):
                        before = content(folder)
                        done = self.run_in([*call, *more], folder, stdout=subprocess.PIPE)
                        self.assertEqual(done.returncode, 2, done.stderr)
                        self.assertIn(f"{folder}: another run writes there: process {process.pid} on ", done.stderr)
                        self.assertIn("Z: touchstone scenes mesh.obj --balls ", done.stderr)
                        self.assertEqual(content(folder), before)
            balls.write("0 0 0 1\n")
        self.assertEqual(process.wait(PATIENCE), 0)
        self.assertEqual(sorted(content(folder)), ["answers.jsonl", "left-out.txt", "run.json"])

    def test_frees_the_folder_where_it_is_killed(self):
        folder = SCRATCH / "killed"
        process, balls = self.hold(folder)
        process.kill()
        process.wait()
        balls.close()
        self.assertEqual(self.run_in(["soak", "--samples", "5", "--output", OUTPUT], folder, stdout=subprocess.DEVNULL).returncode, 0)

    def test_of_two_runs_at_once_one_is_refused_whole(self):
        seeded = lambda seed, output: [TOUCHSTONE, "soak", "--samples", "1000", "--threads", "1", "--seed", seed, "--output", str(output)]
        data = lambda folder: {name: bytes for name, bytes in content(folder).items() if name != "run.json"}
        alone = {}
        for seed in "1", "5":
            subprocess.run(seeded(seed, SCRATCH / seed), check=True, stdout=subprocess.DEVNULL, timeout=PATIENCE)
            alone[seed] = data(SCRATCH / seed)
        self.assertNotEqual(alone["1"]["soak.csv"], alone["5"]["soak.csv"])
        for turn in range(4):
            folder = SCRATCH / f"both-{turn}"
            running = {seed: subprocess.Popen(seeded(seed, folder), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
                       for seed in alone}
            told = {seed: process.communicate(timeout=PATIENCE)[1] for seed, process in running.items()}
            self.assertEqual(sorted(process.returncode for process in running.values()), [0, 2], told)
            won = next(seed for seed, process in running.items() if process.returncode == 0)
            self.assertEqual(data(folder), alone[won])

    def test_writes_over_nothing_unasked(self):
        for number, call in enumerate(filter(writes, calls())):
            output = SCRATCH / f"precious-{number}"
            output.mkdir()
            (output / "kept.txt").write_text("precious\n")
            before = content(SCRATCH)
            with self.subTest(call=call):
                done = self.run_in(call, output, stdout=subprocess.PIPE)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn("--force overwrites ", done.stderr)
                self.assertEqual(content(SCRATCH), before)
        for name in (name for name, ways in COMMANDS.items() if any(map(writes, ways))):
            with self.subTest(command=name):
                self.assertIn(" --force ", self.help_of(name))

    def test_follows_no_link_out_of_its_folder(self):
        folder, victim = SCRATCH / "links", SCRATCH / "victim.txt"
        folder.mkdir()
        victim.write_text("precious\n")
        written = ["soak.csv", "differences.jsonl", "checkpoint.json", "run.json"]
        for name in written:
            (folder / name).symlink_to(victim)
        done = self.run_in(["soak", "--samples", "5", "--force", "--output", OUTPUT], folder, stdout=subprocess.DEVNULL)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(victim.read_text(), "precious\n")
        self.assertFalse(any((folder / name).is_symlink() for name in written))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
