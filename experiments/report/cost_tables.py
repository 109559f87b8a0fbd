#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: cost_tables.py ROOT [--write | --measured BENCH_JSON]

Compares the tables of costs in the pages with those of the stored measurements (exit status 1 if one differs), or
writes them there. --measured first stores the times of a run of `touchstone bench`, with the machine, in docs/cost.json:

    touchstone bench --family random-triangles,half-near,lattice-tangent,polygons-128 --output FOLDER

Times differ on every run, so no test measures them again. Instructions do not, and tests/experiments/studies/bench/instructions.json stores
them. Without docs/cost.json the README shows instructions in place of times.
"""

import json
import pathlib
import sys

import markers
import noise
from shares import unless_whole

FAMILIES = {  # of `touchstone bench`: family, the contest in it, in words
    ("random-triangles", ""): "triangles, balls anywhere",
    ("half-near", ""): "triangles, half of the balls at a relative distance of 2^-50 from contact",
    ("lattice-tangent", ""): "triangles, all balls exactly tangent",
    ("polygons-128", "all outlines"): "prepared polygons of 128 vertices, small balls near their planes",
}
CONTESTANTS = {"fast": "`fast`", "filtered": "`filtered`", "EPECK": "CGAL's EPECK"}
RUN = ["command", "date", "commit", "compiler", "flags", "processor"]
DATA, INSTRUCTIONS = "docs/cost.json", "tests/experiments/studies/bench/instructions.json"


def kept(bench):
    """What the pages need of the file that `touchstone bench` wrote: medians, wrong answers and the machine."""
    contests, noisy = [], []
    for contest in bench["contests"]:
        if (contest["family"], contest["name"]) in FAMILIES:
            contests.append({"family": contest["family"], "name": contest["name"], "contestants": [
                {"name": c["name"], "nanoseconds": c["nanoseconds"]["median"], "wrong": c.get("wrong")}
                for c in contest["contestants"] if c["name"] in CONTESTANTS]})
            noisy += [f"{contest['family']}, {c['name']}" for c in contest["contestants"] if c["name"] in CONTESTANTS and not noise.of_contestant(c)]
    found = {(contest["family"], contest["name"]) for contest in contests}
    if missing := [family for family, name in FAMILIES if (family, name) not in found]:
        raise SystemExit(f"no times of {', '.join(missing)}")
    if noisy:
        raise SystemExit(f"too noisy to quote: {'; '.join(noisy)}; measure again on an idle machine")
    return {"run": {key: bench["run"][key] for key in RUN}, "repetitions": bench["repetitions"], "contests": contests}


def markdown(head, rows):
    return "".join(f"| {' | '.join(row)} |\n" for row in (head, ["---"] + ["--:"] * (len(head) - 1), *rows))


def share(wrong):
    if not wrong:
        return ""
    if not wrong["count"]:
        return f"0 of {wrong['of']:,}"
    return unless_whole(wrong["count"] / wrong["of"], f"{100 * wrong['count'] / wrong['of']:.0f}") + " %"


def times(data):
    rows = []
    for contest in data["contests"]:
        by_name = {contestant["name"]: contestant for contestant in contest["contestants"]}
        rows.append([FAMILIES[contest["family"], contest["name"]],
                     *(f"{by_name[name]['nanoseconds']:,.0f}" if name in by_name else "" for name in CONTESTANTS),
                     *(share(by_name.get(name, {}).get("wrong")) for name in CONTESTANTS)])
    run = data["run"]
    return (f"Nanoseconds per contact query on one core of {run['processor']} ({run['compiler']}, {run['flags']}; medians of "
            f"{data['repetitions']} runs), and wrong answers:\n\n" +
            markdown(["", *CONTESTANTS.values(), *(f"{name} wrong" for name in CONTESTANTS.values())], rows))


def instructions(data):
    rows = []
    for (family, _), words in FAMILIES.items():
        counts = data["instructions_per_query"][family]
        rows.append([words, *(f"{counts[name]:,.0f}" for name in ("fast", "filtered"))])
    return ("Instructions per contact query, counted by valgrind (g++ 12, release build):\n\n" +
            markdown(["", "`fast`", "`filtered`"], rows))


def tables(root):
    """Page, name in its markers, table."""
    counted = instructions(json.loads((root / INSTRUCTIONS).read_text()))
    measured = times(json.loads((root / DATA).read_text())) if (root / DATA).exists() else None
    return [("README.md", "cost", measured or counted), ("docs/cost.md", "instructions", counted)]


def main(root, *options):
    root = pathlib.Path(root)
    if options[:1] == ("--measured",):
        bench = json.loads(pathlib.Path(options[1]).read_text())
        (root / DATA).write_text(json.dumps(kept(bench), indent=1) + "\n")
    status = 0
    for page, name, new in tables(root):
        before, old, after = markers.split(root / page, name)
        if options:
            (root / page).write_text(before + new + after)
        elif old != new:
            print(f"{page}: the table '{name}' differs from the stored measurements; cost_tables.py --write updates it:\n{new}")
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
