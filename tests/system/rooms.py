# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: rooms.py SOURCE BUILD [--write]

Holds the includes to the rooms: a file of experiments/ includes headers of its own room and of those that its room's
CMakeLists.txt names behind STANDS_ON, and no others; each of those is used; no study stands on another; no room of the
laboratory stands on one of experiments/thesis/; geometry/ includes nothing of robust/ or experiments/, robust/ and bindings/
nothing of experiments/, and only tests/ includes tests/. What lies in robust/ROOM/detail/ is in namespace
touchstone::ROOM::detail, and a folder in there has at most 12 files. Every source file is compiled, but those of absent
engines. The table of docs/architecture.md lists the same rooms and arrows, studies as one; --write updates it. Exit status 1, with the
file and line, otherwise.
"""

import json
import pathlib
import re
import sys
import tempfile

INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
BELOW = {"geometry": ("geometry",), "robust": ("geometry", "robust"), "bindings": ("geometry", "robust", "bindings")}
PAGE = "docs/architecture.md"
BEGIN, END = "<!-- rooms -->\n", "<!-- /rooms -->"
# Compiled only where the engine is installed.
ENGINES = ("experiments/methods/engines/",)


class Room:
    def __init__(self, line):
        head, _, lower = line.partition(": ")
        self.name, self.folder = head.split(" ")
        self.stands_on = lower.split()


def rooms_of(build):
    lines = (build / "rooms.txt").read_text().splitlines()
    return [Room(line if ": " in line else line + " ") for line in lines if line]


def includes_of(root, folder):
    for path in sorted((root / folder).rglob("*")):
        if path.suffix in (".h", ".cpp"):
            text = path.read_text()
            for match in INCLUDE.finditer(text):
                yield path.relative_to(root).as_posix(), text.count("\n", 0, match.start()) + 1, match[1]


def room_of(file, rooms):
    homes = [room for room in rooms if file.startswith(room.folder + "/")]
    return max(homes, key=lambda room: len(room.folder), default=None)


def faults_of_libraries(root):
    for folder, allowed in BELOW.items():
        for file, line, target in includes_of(root, folder):
            top = target.split("/")[0]
            if "/" in target and top not in allowed and (root / target).exists():
                yield f"{file}:{line}: {folder}/ may not include {target}"


def faults_of_rooms(root, rooms):
    used = set()
    for file, line, target in includes_of(root, "experiments"):
        home = room_of(file, rooms)
        if target.startswith("tests/"):
            yield f"{file}:{line}: includes {target}"
        if home is None or not target.startswith("experiments/"):
            continue
        room = room_of(target, rooms)
        if room is None:
            yield f"{file}:{line}: {target} is in no room"
        elif room is not home:
            used.add((home.name, room.name))
            if room.name not in home.stands_on:
                yield f"{file}:{line}: {home.name} does not stand on {room.name}, but includes {target}"
    studies = {room.name for room in rooms if "/studies/" in room.folder}
    thesis = {room.name for room in rooms if room.folder.startswith("experiments/thesis/")}
    for room in rooms:
        for lower in room.stands_on:
            if (room.name, lower) not in used:
                yield f"{room.folder}/CMakeLists.txt: {room.name} names {lower} and includes nothing of it"
            if room.name in studies and lower in studies:
                yield f"{room.folder}/CMakeLists.txt: the study {room.name} stands on the study {lower}"
            if room.name not in thesis and lower in thesis:
                yield f"{room.folder}/CMakeLists.txt: the laboratory's room {room.name} stands on the thesis's {lower}"


def faults_of_sources(root, build):
    compiled = {entry["file"] for entry in json.loads((build / "compile_commands.json").read_text())}
    for together in [file for file in compiled if "/Unity/" in file]:
        compiled.update(re.findall(r'^#include "(.+\.cpp)"', pathlib.Path(together).read_text(), re.MULTILINE))
    for folder in ("geometry", "robust", "experiments"):
        for path in sorted((root / folder).rglob("*.cpp")):
            file = path.relative_to(root).as_posix()
            if str(path) not in compiled and not file.startswith(ENGINES):
                yield f"{file}: no CMakeLists.txt lists it"


def faults_of_details(root):
    for detail in sorted(root.glob("robust/*/detail")):
        sources = [path for path in sorted(detail.rglob("*")) if path.suffix in (".h", ".cpp")]
        for path in sources:
            text = path.read_text()
            if "namespace touchstone" in text and not re.search(rf"::{detail.parent.name}::detail\b|namespace detail\b", text):
                yield f"{path.relative_to(root).as_posix()}: declares nothing in touchstone::{detail.parent.name}::detail"
        for folder in sorted({path.parent for path in sources} - {detail}):
            if (count := sum(path.parent == folder for path in sources)) > 12:
                yield f"{folder.relative_to(root).as_posix()}: has {count} files, more than 12"


def floor_of(room, by_name):
    return 1 + max((floor_of(by_name[lower], by_name) for lower in room.stands_on), default=0)


def drawing(rooms):
    """The rooms by floor, the highest first, then what each stands on; the studies, which lie side by side, as one."""
    studies = [room for room in rooms if "/studies/" in room.folder]
    lower = [room.name for room in rooms if any(room.name in study.stands_on for study in studies)]
    one = Room(f"studies experiments/studies: {' '.join(lower)}")
    rooms = [one if room is studies[0] else room for room in rooms if room not in studies[1:]]
    by_name = {room.name: room for room in rooms}
    floors = {}
    for room in rooms:
        floors.setdefault(floor_of(room, by_name), []).append(room.name)
    lines = [f"{floor:2}  {'  '.join(sorted(floors[floor]))}\n" for floor in sorted(floors, reverse=True)]
    return "```text\n" + "".join(lines) + "    robust\n    geometry\n```\n\n" + table(rooms)


def table(rooms):
    rows = [f"| `{room.folder}/` | {', '.join(room.stands_on) or 'the libraries'} |\n" for room in rooms]
    return "| room | stands on |\n|---|---|\n" + "".join(rows)


def faults_of_page(root, rooms, write):
    page = root / PAGE
    text = page.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    if write:
        page.write_text(text[:begin] + drawing(rooms) + text[end:])
    elif text[begin:end] != drawing(rooms):
        yield f"{PAGE}: its drawing of the rooms is not that of the CMakeLists.txt; call rooms.py with --write"


def self_test():
    """Each kind of wrong include is found."""
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        files = {"geometry/a.h": '#include "robust/b.h"\n', "robust/b.h": "", "experiments/low/c.h": '#include "experiments/high/d.h"\n',
                 "robust/a/detail/f.h": "namespace touchstone::a {\n", "robust/a/detail/g.h": "namespace touchstone::a::detail {\n",
                 "experiments/high/d.h": '\n#include "experiments/low/c.h"\n#include "tests/e.h"\n', "tests/e.h": "",
                 "experiments/thesis/hall/f.h": "", "experiments/high/g.h": '#include "experiments/thesis/hall/f.h"\n'}
        for file, text in files.items():
            (root / file).parent.mkdir(parents=True, exist_ok=True)
            (root / file).write_text(text)
        rooms = [Room("low experiments/low: "), Room("hall experiments/thesis/hall: "), Room("high experiments/high: low hall other")]
        found = [*faults_of_libraries(root), *faults_of_rooms(root, rooms), *faults_of_details(root)]
        wanted = ["geometry/a.h:1: geometry/ may not include robust/b.h", "experiments/high/d.h:3: includes tests/e.h",
                  "robust/a/detail/f.h: declares nothing in touchstone::a::detail",
                  "experiments/low/c.h:1: low does not stand on high, but includes experiments/high/d.h",
                  "experiments/high/CMakeLists.txt: high names other and includes nothing of it",
                  "experiments/high/CMakeLists.txt: the laboratory's room high stands on the thesis's hall"]
        return [] if sorted(found) == sorted(wanted) else [f"self-test: found {found}"]


def main(source, build, *options):
    root, build = pathlib.Path(source).resolve(), pathlib.Path(build).resolve()
    rooms = rooms_of(build)
    faults = [*self_test(), *faults_of_libraries(root), *faults_of_rooms(root, rooms), *faults_of_details(root),
              *faults_of_sources(root, build), *faults_of_page(root, rooms, "--write" in options)]
    print("\n".join([*faults, f"{len(rooms)} rooms, {len(faults)} faults"]))
    return 1 if faults or not rooms else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
