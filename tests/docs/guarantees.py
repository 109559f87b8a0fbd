# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: guarantees.py SOURCE
       guarantees.py --self-test

Checks the numbered guarantees of the documentation comments of headers: each `(n)` begins a line of its own, the numbers of
a list are 1, 2, 3 and so on, and the lines that continue a guarantee are indented as its text. Names file and line. Exit
status 1 if it finds a fault.
"""

import pathlib
import re
import sys

FOLDERS = ("bindings", "experiments", "geometry", "robust", "tests")
BLOCK = re.compile(r"(?:^ *///(?!<).*\n)+", re.MULTILINE)
ITEM = re.compile(r"/// {1,2}\((\d+)\) ")
WITHIN = re.compile(r"(?<=[.;:] )\(\d+\) ")
TEXT = " " * 6  # before the text of a guarantee, after the slashes


def faults_of(name, text):
    for block in BLOCK.finditer(text):
        first, last, listed = text.count("\n", 0, block.start()) + 1, 0, False
        for line, words in enumerate(map(str.strip, block[0].splitlines()), first):
            found = WITHIN.search(words)
            if found:
                yield f"{name}:{line}: {found[0].strip()} does not begin its line"
            if item := ITEM.match(words):
                if int(item[1]) not in (1, last + 1):
                    yield f"{name}:{line}: ({item[1]}) follows ({last})"
                last, listed = int(item[1]), True
                continue
            indented = re.match(r"/// *", words)[0][3:]
            if not listed and last and indented == TEXT:
                yield f"{name}:{line}: this line continues no guarantee"
            if listed and indented not in ("", " ", TEXT):
                yield f"{name}:{line}: a guarantee is continued {len(TEXT)} columns behind the slashes"
            listed = listed and indented == TEXT


def main(root):
    root, faults, lists = pathlib.Path(root), [], 0
    for file in sorted(file for folder in FOLDERS for file in (root / folder).rglob("*.h")):
        text = file.read_text()
        lists += text.count("///  (1) ")
        faults += faults_of(file.relative_to(root).as_posix(), text)
    print("\n".join([*faults, f"{lists} lists, {len(faults)} faults"]))
    return 1 if faults or not lists else 0


def self_test():
    good = "/// Guarantees\n///  (1) one\n///      and more;\n///  (2) as (1) says, (3) is not here.\n/// Cost: 1 us.\n"
    wrong = {  # the line of the fault
        "/// Guarantees\n///  (1) one; (2) two.\n": 2,
        "/// Marks it. (1) All of it.\n": 1,
        "///  (1) one;\n///  (3) three.\n": 2,
        "///  (1) one\n///  and\n": 2,
        "///  (1) one\n/// and\n///      more.\n": 3,
    }
    lines = {text: [int(fault.split(":")[1]) for fault in faults_of("a.h", text)] for text in (good, *wrong)}
    faults = [text for text, found in lines.items() if found != ([wrong[text]] if text in wrong else [])]
    print("\n".join(faults) or f"{len(wrong)} faults are found")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main(*sys.argv[1:]))
