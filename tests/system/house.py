# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: house.py SOURCE [--write]

Prints the size of each room of the house, and refuses growth beyond the budgets of budgets.txt beside this file. A room
is a folder that budgets.txt names; its lines and files do not count for the folder around it. `headers with one reader`
counts the headers that exactly one file besides their own source and the tests includes; `files below 40 lines` counts
both kinds of C++ files. --write lowers budgets to what is there. Only an editor raises one, so that a reviewer sees it.
Exit status 1 if a budget is exceeded, a folder with sources has none, or a budget names no folder.
"""

import pathlib
import re
import sys
import tempfile

SUFFIXES = {".h": "C++", ".cpp": "C++", ".py": "Python", ".js": "JavaScript"}
SKIPPED = ("build", "cache", "dist", "results", ".git")  # folders of the root
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
SHORT = 40
HEADERS, SHORTS = "headers with one reader", "files below 40 lines"


def sources(root):
    for path in sorted(root.rglob("*")):
        file = path.relative_to(root)
        if path.suffix in SUFFIXES and path.is_file() and file.parts[0] not in SKIPPED and "__pycache__" not in file.parts:
            yield file.as_posix(), SUFFIXES[path.suffix], path.read_text()


def budgets_of(text):
    """The budget of each (room, language), and the lines of the file around them."""
    budgets = {}
    for line in text.splitlines():
        if line and not line.startswith("#"):
            room, language, lines, files = line.rsplit(None, 3)
            budgets[room, language] = [int(lines), int(files)]
    return budgets


def measured(root, budgets):
    """The lines and files of each (room, language), and the faults of files without a budget."""
    sizes = {key: [0, 0] for key in budgets}
    faults, includes, shorts = [], {}, {}
    for file, language, text in sources(root):
        homes = [room for room, of in budgets if of == language and file.startswith(room + "/")]
        if not homes:
            faults.append(f"{file}: no budget of {language} holds its folder")
            continue
        room = max(homes, key=len)
        sizes[room, language][0] += text.count("\n")
        sizes[room, language][1] += 1
        if language == "C++" and not file.startswith("tests/"):
            shorts[file] = text.count("\n") < SHORT
            for target in INCLUDE.findall(text):
                if pathlib.PurePath(target).with_suffix("") != pathlib.PurePath(file).with_suffix(""):
                    includes.setdefault(target, set()).add(file)
    lone = [target for target, readers in includes.items() if len(readers) == 1 and target in shorts]
    for name, count in ((HEADERS, len(lone)), (SHORTS, sum(shorts.values()))):
        if (name, "C++") in sizes:
            sizes[name, "C++"] = [count, 0]
    return sizes, faults


def faults_of(root, text):
    budgets = budgets_of(text)
    sizes, faults = measured(root, budgets)
    for (room, language), (lines, files) in sizes.items():
        most_lines, most_files = budgets[room, language]
        if lines > most_lines or files > most_files:
            faults.append(f"{room}: {lines} in {files} files of {language}, the budget is {most_lines} in {most_files}")
        elif lines == 0 and room not in (HEADERS, SHORTS):
            faults.append(f"{room}: nothing of {language} is there")
    return sizes, budgets, faults


def lowered(text, sizes):
    def line_of(line):
        if not line or line.startswith("#"):
            return line
        room, language, lines, files = line.rsplit(None, 3)
        now = sizes[room, language]
        return f"{room:44} {language:10} {min(int(lines), now[0]):6} {min(int(files), now[1]):4}"
    return "".join(line_of(line) + "\n" for line in text.splitlines())


def self_test():
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        for file, text in {"a/b/c.h": "1\n2\n", "a/d.cpp": '#include "a/b/c.h"\n', "e/f.py": "1\n"}.items():
            (root / file).parent.mkdir(parents=True, exist_ok=True)
            (root / file).write_text(text)
        text = f"a C++ 1 1\na/b C++ 1 1\n{HEADERS} C++ 0 0\ng C++ 1 1\n"
        sizes, _, found = faults_of(root, text)
        wanted = ["e/f.py: no budget of Python holds its folder", "a/b: 2 in 1 files of C++, the budget is 1 in 1",
                  f"{HEADERS}: 1 in 0 files of C++, the budget is 0 in 0", "g: nothing of C++ is there"]
        if sorted(found) != sorted(wanted) or "a/b" not in lowered(text, sizes):
            return [f"self-test: found {found}"]
    return []


def main(source, *options):
    root = pathlib.Path(source).resolve()
    page = pathlib.Path(__file__).parent / "budgets.txt"
    text = page.read_text()
    sizes, budgets, faults = faults_of(root, text)
    for (room, language), (lines, files) in sizes.items():
        print(f"{room:44} {language:10} {lines:6} in {files:3}   budget {budgets[room, language][0]:6} in {budgets[room, language][1]:3}")
    if "--write" in options:
        page.write_text(lowered(text, sizes))
    print("\n".join([*self_test(), *faults, f"{len(sizes)} budgets, {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
