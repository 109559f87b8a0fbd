# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of a room are compiled several at once, in batches that move with every file that is added or removed. So no
two of them may define the same function, type or constant in an unnamed namespace.

Usage: unnamed_names.py SOURCES

A function is the same if its name and its parameters are. Definitions begin a line, as clang-format writes them.
"""
import collections
import re
import subprocess
import sys
from pathlib import Path

UNNAMED = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.M | re.S)
FUNCTION = re.compile(r"^(?! |using|static_assert|struct|class|enum)[\w:<>,&*\[\] ]+?[ &*](\w+)\(([^;{}]*?)\)(?: const)?(?: noexcept)? \{",
                      re.M)
TYPE = re.compile(r"^(?:struct|class|enum class|enum) (\w+)[^;{]*?\{", re.M)
CONSTANT = re.compile(r"^(?:inline |static )*(?:constexpr|const|thread_local) [\w:<>,&* ]+? (\w+) ?(?:\[|\{|=|;)", re.M)


def names(text):
    """The names that unnamed namespaces of a file define, each with the namespace around it."""
    for block in UNNAMED.finditer(text):
        around = re.findall(r"^namespace ([\w:]+) \{", text[:block.start()], re.M)[-1:]
        for name, parameters in FUNCTION.findall(block[1]):
            types = re.sub(r"\s*\b\w+(?= = |,|$)(?: = [^,]*)?", "", " ".join(parameters.split()))
            yield *around, f"{name}({types})"
        for name in TYPE.findall(block[1]) + CONSTANT.findall(block[1]):
            yield *around, name


def room(path):
    """The nearest folder with a CMakeLists.txt."""
    folder = path.parent
    while not (folder / "CMakeLists.txt").exists():
        folder = folder.parent
    return folder


def main():
    files = subprocess.run(["git", "-C", sys.argv[1], "ls-files", "*.cpp"], check=True, capture_output=True, text=True)
    found = collections.defaultdict(set)
    for path in (Path(sys.argv[1], name) for name in files.stdout.split()):
        for name in names(path.read_text()) if path.exists() else ():
            found[room(path), name].add(str(path))
    assert len(found) > 1000, f"only {len(found)} names were found: the patterns fit no longer"
    twice = {name[-1]: sorted(paths) for (_, name), paths in found.items() if len(paths) > 1}
    for name, paths in twice.items():
        print(f"{name} is defined in the unnamed namespaces of {', '.join(paths)}")
    sys.exit(bool(twice))


main()
