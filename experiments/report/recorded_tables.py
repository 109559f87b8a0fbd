#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: recorded_tables.py RESULTS [--write]

Compares the tables in RESULTS, which ./reproduce has made with small samples, with the checksums in recorded_tables.json: those
of a program without the engines of other projects, on one x86-64 machine. Tables with times are not recorded. Those that
were not made are only named: without the meshes some studies are skipped, and after --full others keep its samples. Exit
status 1 if a table differs, unless the program has other engines, or if none is equal. --write records the tables of
RESULTS, a new folder, made by

  cmake --preset release -B build/plain -DTOUCHSTONE_ENGINES=OFF -DTOUCHSTONE_TESTS=OFF
  cmake --build build/plain --target touchstone
  python3 -B experiments/report/run_studies.py build/plain/touchstone build/plain/results
"""
import hashlib
import json
import pathlib
import re
import sys

from studies import modules, shown

ROOT = pathlib.Path(__file__).resolve().parents[2]
RECORD = pathlib.Path(__file__).with_suffix(".json")
TIME = re.compile(r"(\b|_)(ns|nanoseconds)\b|_seconds\b")  # in the name of a column; `seconds` alone are those of a simulation
WHY = 'docs/reproducibility.md, "What is equal, and what is not", says what makes tables differ.'


def tables(results):
    """The checksum of each table without times, by its path, of the studies that ran with small samples."""
    asked = {name: [shown(call, name) for call in module.RUN.calls("quick") or ()] for name, module in modules().items()}
    marks = {path.parent.name: json.loads(path.read_text(encoding="utf-8")) for path in results.glob("*/reproduce.json")}
    contents = {path.relative_to(results).as_posix(): path.read_bytes() for name, mark in sorted(marks.items())
                if mark["done"] and mark["calls"] == asked[name] for path in sorted((results / name).rglob("*.csv"))}
    return {name: hashlib.sha256(content).hexdigest() for name, content in contents.items()
            if not TIME.search(content.partition(b"\n")[0].decode())}


def engines(results):
    """Those of the programs that made the tables."""
    records = [json.loads(path.read_text(encoding="utf-8")) for path in results.rglob("run.json")]
    return sorted({engine for record in records for engine in record.get("engines", [])})


def write(results, record):
    if found := engines(results):
        sys.exit(f"recorded_tables.py: {results}: made with {', '.join(found)}")
    version = re.search(r"project\(Touchstone VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    made = tables(results)
    record.write_text(json.dumps({"version": version, "tables": made}, indent=1) + "\n", encoding="utf-8")
    print(f"{len(made)} tables of version {version} are recorded.")


def compare(results, record):
    """Says what is equal. Returns the exit status."""
    known = json.loads(record.read_text(encoding="utf-8"))
    made, wanted = tables(results), known["tables"]
    equal = sum(made.get(name) == checksum for name, checksum in wanted.items())
    differing = [name for name, checksum in wanted.items() if made.get(name, checksum) != checksum]
    missing = [name for name in wanted if name not in made]
    print(f"{equal} of {len(wanted)} tables equal those of version {known['version']}.")
    found = engines(results)
    if differing:
        print(f"These differ{', of a program that also has ' + ', '.join(found) if found else ''}: {', '.join(differing)}")
    if missing:
        print(f"These were not made with small samples: {', '.join(missing)}")
    if differing or missing:
        print(WHY)
    return 1 if (differing and not found) or not equal else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--write"]):
        sys.exit(__doc__)
    sys.exit((write if sys.argv[2:] else compare)(pathlib.Path(sys.argv[1]), RECORD))
