# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: waiting.py BUILD [--write PAGE]

What a build and its tests cost, from the logs of Ninja and CTest of a whole build and test run: for each room the number
of compilations and their seconds, and the seconds of its tests, the most expensive first. With --write the table between the
markers of PAGE is replaced.
"""

import collections
import os
import pathlib
import platform
import re
import sys

BEGIN, END = "<!-- waiting -->\n", "<!-- /waiting -->"
LEAST = 1  # seconds; cheaper steps stand together in the last line


def compiled(build):
    """Seconds and files by room; the last build of a file counts."""
    last = {}
    for line in (build / ".ninja_log").read_text().splitlines()[1:]:
        begin, end, _, output, _ = line.split("\t")
        last[output] = (int(end) - int(begin)) / 1000
    seconds, files = collections.Counter(), collections.Counter()
    for output, time in last.items():
        if output.endswith(".o"):
            room = output.split("/CMakeFiles/")[0]
            seconds[room] += time
            files[room] += 1
    return seconds, files


def tested(build):
    """Seconds by the first word of a test's name."""
    log = (build / "Testing/Temporary/LastTest.log").read_text(errors="replace")
    seconds = collections.Counter()
    for name, time in re.findall(r"^\d+/\d+ Testing: (\S+).*?^Test time = +([\d.]+) sec", log, re.MULTILINE | re.DOTALL):
        seconds[name.split(".")[0]] += float(time)
    return seconds


def table(head, rows):
    shown = [row for row in rows if row[-1] >= LEAST]
    rest = sum(row[-1] for row in rows if row[-1] < LEAST)
    text = f"| {' | '.join(head)} |\n|---{'|--:' * (len(head) - 1)}|\n"
    for row in shown:
        text += f"| {' | '.join([row[0], *(str(cell) for cell in row[1:-1]), f'{row[-1]:.0f}'])} |\n"
    if rest > 0:
        text += f"| all others {'| ' * (len(head) - 2)}| {rest:.0f} |\n"
    return text + f"| **together** {'| ' * (len(head) - 2)}| **{sum(row[-1] for row in rows):.0f}** |\n"


def report(build):
    seconds, files = compiled(build)
    rooms = sorted(((f"`{room}`", files[room], time) for room, time in seconds.items()), key=lambda row: -row[-1])
    tests = sorted(((f"`{name}`", time) for name, time in tested(build).items()), key=lambda row: -row[-1])
    return (f"Measured on {platform.machine()} with {os.cpu_count()} cores. Ninja compiles more at once than there are cores, so the\n"
            "seconds of a compilation include its waiting.\n\n" + table(["compiled", "compilations", "seconds"], rooms) +
            "\n" + table(["tests", "seconds"], tests))


def main(build, *options):
    text = report(pathlib.Path(build))
    if not options:
        print(text, end="")
        return 0
    page = pathlib.Path(options[1])
    whole = page.read_text()
    begin, end = whole.index(BEGIN) + len(BEGIN), whole.index(END)
    page.write_text(whole[:begin] + text + whole[end:])
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
