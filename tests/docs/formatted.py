# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: formatted.py SOURCE

Checks that clang-format, with the project's .clang-format, would change no C++ file, and that no comment, which it does not
wrap, is wider than its column limit. Names each file with its first fault, and exits with status 1. Different versions of clang-format produce different layouts, so without
version 14, which is Debian 12's, it prints the reason and exits with status 77, which CTest reports as skipped.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

VERSION = 14
FOLDERS = ("bindings", "cmake", "experiments", "geometry", "robust", "tests")
SKIPPED = 77


def clang_format():
    """Returns a clang-format of that version, or None and the reason."""
    found = []
    for name in (f"clang-format-{VERSION}", "clang-format"):
        if program := shutil.which(name):
            said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
            if re.search(rf"version {VERSION}\.", said):
                return program, ""
            found.append(said.strip())
    return None, "; ".join(found) or "clang-format is not installed"


def limit_of(root):
    return int(re.search(r"^ColumnLimit: (\d+)$", (root / ".clang-format").read_text(), re.MULTILINE)[1])


def long_comments(text, limit):
    """The lines, the last one first, of comments that are too wide."""
    lines = [str(number) for number, line in enumerate(text.splitlines(), 1) if len(line) > limit and re.match(r" *//", line)]
    return lines[::-1]


def faults_of(program, root):
    """Returns the first difference of each file, and the number of files."""
    files = sorted(file.relative_to(root).as_posix() for folder in FOLDERS for file in (root / folder).rglob("*")
                   if file.suffix in (".h", ".cpp"))

    def laid_out(file):
        return subprocess.run([program, "--style=file", file], cwd=root, capture_output=True, text=True, check=True).stdout

    def warnings(some):
        done = subprocess.run([program, "--dry-run", "--style=file", *some], cwd=root, capture_output=True, text=True,
                              check=True, env=dict(os.environ, LC_ALL="C"))
        found = re.findall(r"^(\S+):(\d+):\d+: warning: ", done.stderr, re.MULTILINE)
        # It also warns of the end of a nested inline namespace, which it leaves as it is.
        same = {file for file, _ in found if laid_out(file) == (root / file).read_text()}
        return [(file, line) for file, line in found if file not in same]

    first = {file: line for file in files for line in long_comments((root / file).read_text(), limit_of(root))}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for found in pool.map(warnings, (files[begin:begin + 50] for begin in range(0, len(files), 50))):
            for file, line in found:
                first.setdefault(file, line)
    return [f"{file}:{line}: run clang-format -i {file}, or wrap its comment" for file, line in sorted(first.items())], len(files)


def self_test(program, root):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copy(root / ".clang-format", folder)
        (folder / "geometry").mkdir()
        (folder / "geometry/good.h").write_text("int f();\n")
        (folder / "geometry/bad.cpp").write_text("int f() { return 1; }\nint  g() { return 2; }\n")
        (folder / "geometry/wide.cpp").write_text("\n// " + 60 * "ab " + "\nint f();\n")
        found, count = faults_of(program, folder)
    return 0 if ([fault.partition(" ")[0] for fault in found], count) == (["geometry/bad.cpp:2:", "geometry/wide.cpp:2:"], 3) else 1


def main(root):
    program, why = clang_format()
    if not program:
        print(f"skipped: needs clang-format {VERSION}: {why}")
        return SKIPPED
    root = pathlib.Path(root)
    if self_test(program, root):
        print("the check did not find a file with a planted fault")
        return 1
    faults, count = faults_of(program, root)
    print("\n".join([*faults, f"{count} files, {len(faults)} differ from the layout of clang-format {VERSION}"]))
    return 1 if faults or not count else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
