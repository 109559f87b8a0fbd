# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: public_functions.py SOURCE

Every public function of geometry/ and robust/ that takes or returns a double stands in the tables of this folder, as
often as it has overloads: a new one that nobody asks about in every state of the floating-point unit is a failure. What
is public is what is installed; the hierarchy of boxes, which the studies use too, is held to the same. universal-ctags
reads the declarations. Exit status 1 otherwise.
"""

import collections
import json
import pathlib
import re
import subprocess
import sys

# Types of arguments and results without a double in them, and words around types.
WITHOUT_DOUBLES = re.compile(
    r"\b(const|constexpr|void|bool|int|std|size_t|u?int\d+_t|string|string_view|optional|vector|span|unique_ptr|path|"
    r"filesystem|touchstone|filtered|scene|io|Stage|StageCounts|FaceId|RejectionCode|Rejection|SourceLocation|"
    r"PlaneSide|PointLocation|Relation|Feature|Kind|FirstContactKind|Objects|PreparedPolygon|Options|Parts|Lifted)\b")
# Functions that take the floating-point unit as it is; the header that declares them says so, in these words.
ASSUMED = "in the default state of the floating-point unit"
ASSUMES = re.compile(r"fast::|thesis::|dropped_axis$|box$|Box::(empty|joined)$|meet$|operator\*$")


def public_headers(source):
    headers = [source / "geometry/bvh/box.h", source / "geometry/bvh/box_tree.h"]
    for folder in (source / "geometry", source / "robust"):
        for installed in re.findall(r"^ *install_headers\(([^)]*)\)", (folder / "CMakeLists.txt").read_text(), re.MULTILINE):
            headers += [folder / name for name in re.findall(r"\S+\.h\b", installed)]
    return headers


def declarations(headers):
    """(header, qualified name, all that is said of types) of each public function."""
    printed = subprocess.run(
        ["ctags", "--languages=C++", "--langmap=C++:.h", "--c++-kinds=pf", "--fields=+SsaKt", "--sort=no", "-o", "-",
         "--output-format=json", *map(str, headers)], check=True, capture_output=True, text=True).stdout
    for line in printed.splitlines():
        tag = json.loads(line)
        if tag.get("access") == "private" or tag["name"].startswith("__anon"):
            continue
        name = f"{tag.get('scope', '')}::{tag['name'].replace(' ', '')}".removeprefix("touchstone::")
        types = re.sub(r"=[^,)]*", "", tag.get("signature") or "") + " " + (tag.get("typeref") or "").partition(":")[2]
        yield tag["path"], name, types


def has_doubles(name, types):
    """Could a double be in an argument or the result? Prepared polygons are asked about with a ball or a polygon."""
    scope, _, own = name.rpartition("::")
    if own.startswith("~") or "&&" in types or own == "operator=":
        return False
    arguments = re.sub(r"(\w+)\s*([,)=])", r"\2", types)  # without the names of arguments
    return bool(re.search(r"\w", WITHOUT_DOUBLES.sub("", arguments)))


def main(source):
    source = pathlib.Path(source)
    headers = public_headers(source)
    wanted, assume = collections.Counter(), {}
    for header, name, types in declarations(headers):
        if not has_doubles(name, types):
            continue
        if ASSUMES.search(name):
            assume[name] = header
        else:
            wanted[name] += 1
    tables = "".join(table.read_text() for table in sorted((source / "tests/robust/every_state").glob("*_functions.cpp")))
    asked = collections.Counter(re.findall(r'\b(?:gives|hands_on)\(\s*"([^"]+)"', tables))

    faults = [f"{name}: declared {count} times, asked {asked[name]} times"
              for name, count in sorted(wanted.items()) if asked[name] < count]
    faults += [f"{name}: asked {count} times, declared {wanted[name]} times"
               for name, count in sorted(asked.items()) if count > wanted[name]]
    faults += [f"{header}: {name} is in no table, and the header does not say '{ASSUMED}'"
               for name, header in sorted(assume.items())
               if ASSUMED not in " ".join(re.sub(r"///?", " ", pathlib.Path(header).read_text()).split())]
    print("\n".join(faults) or f"{sum(wanted.values())} functions in {len(headers)} headers are asked in every state; "
          f"{len(assume)} assume the default one and say so")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
