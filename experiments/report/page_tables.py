#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: page_tables.py TOUCHSTONE ROOT [--write]

Generates the tables of pages from small studies with fixed seeds. They are the same on every machine with this C
library. Compares each with the one between its page's markers (exit status 1 if one differs), or writes them there.
Tables of times are made by cost_tables.py.
"""

import collections
import csv
import functools
import json
import pathlib
import subprocess
import sys
import tempfile

import markers
from names import ENGINES
from results import Study
from shares import unless_whole
from studies import motions
from studies.regress import OVERALL, by_family, families_of, overall

NEAR_EDGE_METHODS = ["fast", "fast-float", "thesis", "thesis-signed"]
SAMPLES = 60
MOTION_SAMPLES = 6
NO_SWEEP = ["thesis", "ode", "embree-fast", "bullet-defaults", "cgal-epeck-intersect", "cgal-epick-intersect", "cgal-double-intersect"]
ROWS = {  # threshold: what is asked about there, in words; the test of rates.csv
    "face": ("radius at the distance of a face", "contact"),
    "edge": ("radius at the distance of an edge", "contact"),
    "vertex": ("radius at the distance of a vertex", "contact"),
    "foot-edge": ("foot crosses an edge: is it inside?", "foot"),
    "foot-vertex": ("foot passes a vertex: is it inside?", "foot"),
}


def near_edge_counts(touchstone):
    """Failures and trials by (threshold, method), all families and placements, within one double of the threshold."""
    counts = collections.defaultdict(lambda: [0, 0])
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([touchstone, "near-edge", "--methods", ",".join(NEAR_EDGE_METHODS), "--samples", str(SAMPLES), "--seed", "1",
                        "--search", "0", "--no-pictures", "--output", folder],
                       check=True, stdout=subprocess.DEVNULL)
        with open(pathlib.Path(folder, "rates.csv"), newline="") as rates:
            for row in csv.DictReader(rates):
                wanted = ROWS.get(row["threshold"])
                if row["family"] == "all" and wanted and row["test"] == wanted[1] and abs(int(row["offset"])) <= 1:
                    count = counts[row["threshold"], row["method"]]
                    count[0] += int(row["failures"])
                    count[1] += int(row["trials"])
    return counts


def cell(failures, trials):
    """A rate; where nothing failed, its upper 95 % limit (one-sided, Clopper-Pearson)."""
    if failures:
        return unless_whole(failures / trials, f"{100 * failures / trials:.0f}") + " %"
    return f"0 of {trials} (< {100 * (1 - 0.05 ** (1 / trials)):.2f} %)"


def near_edge_table(touchstone):
    counts = near_edge_counts(touchstone)
    lines = ["| within one double of the threshold | " + " | ".join(f"`{method}`" for method in NEAR_EDGE_METHODS) + " |",
             "|---|" + "---|" * len(NEAR_EDGE_METHODS)]
    for threshold, (description, _) in ROWS.items():
        lines.append(f"| {description} | " + " | ".join(cell(*counts[threshold, method]) for method in NEAR_EDGE_METHODS) + " |")
    return "\n".join(lines) + "\n"


@functools.cache
def absent_engines(touchstone):
    """Those whose libraries this build does without."""
    methods = subprocess.run([touchstone, "methods"], check=True, capture_output=True, text=True).stdout
    return set(ENGINES) - {line.split()[0] for line in methods.splitlines() if line.strip()}


@functools.cache
def outcomes(touchstone):
    """The rows of outcomes.csv, and how many polygons they are about. What is compared with is filtered, which must be exact."""
    with tempfile.TemporaryDirectory() as folder:
        present = ["exact", *(engine for engine in ENGINES if engine not in absent_engines(touchstone))]
        subprocess.run([touchstone, "regress", "--methods", ",".join(present), "--output", folder],
                       check=True, stdout=subprocess.DEVNULL)
        with open(pathlib.Path(folder, "outcomes.csv"), newline="") as rows:
            found = list(csv.DictReader(rows))
        samples = json.loads(pathlib.Path(folder, "run.json").read_text())["samples_done"]
    if any(row["method"] == "exact" and row["wrong"] != "0" for row in found):
        raise SystemExit("touchstone regress: filtered differs from exact")
    return found, samples * len(families_of(found))


def markdown(head, lines):
    return "".join(["| " + " | ".join(head) + " |\n", "|" + "---|" * len(head) + "\n",
                    *(f"| `{engine}` | " + " | ".join(cells) + " |\n" for engine, *cells in lines)])


def engines_table(touchstone):
    return markdown(OVERALL, overall(*outcomes(touchstone))).replace("|  |", "| |")


def engines_by_family_table(touchstone):
    return markdown(*by_family(outcomes(touchstone)[0]))


def columns_page(touchstone):
    return "\n" + subprocess.run([touchstone, "columns", "--markdown"], check=True, capture_output=True, text=True).stdout


def moving_engines_table(touchstone):
    present = [engine for engine in ENGINES if engine not in absent_engines(touchstone) and engine not in NO_SWEEP]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([touchstone, "motions", "--methods", ",".join(present), "--samples", str(MOTION_SAMPLES), "--no-pictures", "--output", folder],
                       check=True, stdout=subprocess.DEVNULL)
        return markdown(motions.ENGINE_HEADS, motions.engine_lines(motions.Data(Study(pathlib.Path(folder))))).replace("|  |", "| |")


TABLES = [  # page, name in its markers, what makes it
    ("docs/methods.md", "near-edge", near_edge_table),
    ("docs/tables.md", "columns", columns_page),
    ("docs/judging.md", "engines", engines_table),
    ("docs/judging.md", "moving engines", moving_engines_table),
    ("tests/experiments/judge/regress/README.md", "engines by family", engines_by_family_table),
]


def without_lines_of(engines, table):
    return "".join(line for line in table.splitlines(keepends=True)
                   if not any(line.startswith(f"| `{engine}` |") for engine in engines))


def main(touchstone, root, *options):
    status = 0
    for page, name, make in TABLES:
        path = pathlib.Path(root, page)
        before, old, after = markers.split(path, name)
        new = make(touchstone)
        if "--write" in options:
            if absent_engines(touchstone):
                raise SystemExit(f"this build lacks {', '.join(sorted(absent_engines(touchstone)))}")
            path.write_text(before + new + after)
        elif new != without_lines_of(absent_engines(touchstone), old):
            print(f"{path}: the table '{name}' differs from what the study gives; page_tables.py --write updates it:\n{new}")
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
