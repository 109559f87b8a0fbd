#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: page_tables.py TOUCHSTONE ROOT [--write]

Generates the tables of pages from small studies with fixed seeds. They are the same on every machine with this C
library. Compares each with the one between its page's markers (exit status 1 if one differs), or writes them there.
Tables of times are made by cost_tables.py.
"""

import contextlib
import functools
import pathlib
import subprocess
import sys
import tempfile

import markers
from results import Study
from shares import percents, upper_limit
from studies import motions, near_edge
from studies.regress import ENGINES, OVERALL, by_family, overall, polygons_of, rows_of

NEAR_EDGE_METHODS = ["fast", "fast-float", "thesis", "thesis-signed"]
SAMPLES = 60
MOTION_SAMPLES = 6
NO_SWEEP = ["thesis", "ode", "embree-fast", "bullet-defaults", "cgal-epeck-intersect", "cgal-epick-intersect", "cgal-double-intersect"]
ROWS = {  # threshold: what is asked about there, in words
    "face": "radius at the distance of a face",
    "edge": "radius at the distance of an edge",
    "vertex": "radius at the distance of a vertex",
    "foot-edge": "foot crosses an edge: is it inside?",
    "foot-vertex": "foot passes a vertex: is it inside?",
}


@contextlib.contextmanager
def results_of(touchstone, *call):
    """The study that a call writes, for as long as it is used."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([touchstone, *call, "--output", folder], check=True, stdout=subprocess.DEVNULL)
        yield Study(pathlib.Path(folder))


def cell(failures, trials):
    """A rate; where nothing failed, its upper 95 % limit (one-sided, Clopper-Pearson)."""
    if failures:
        return percents(failures, trials, ".0f")
    return f"0 of {trials} (< {100 * upper_limit(trials):.2f} %)"


@functools.cache
def near_edge_data(touchstone):
    with results_of(touchstone, "near-edge", "--methods", ",".join(NEAR_EDGE_METHODS), "--samples", str(SAMPLES), "--seed", "1", "--search", "0",
                    "--no-maps", "--no-pictures") as study:
        return near_edge.Data(study)


def near_edge_table(touchstone):
    """All families, within u x size of the threshold."""
    data = near_edge_data(touchstone)

    def of_kind(method, threshold, kind):
        failures, trials, lift = data.near(method, threshold, kind)
        return cell(failures, trials) + (f", lift {percents(lift, trials, '.0f')}" if lift else "")
    return markdown(["within u x size of the threshold", "polygons", *map("`{}`".format, NEAR_EDGE_METHODS)],
                    [[description, name, *(of_kind(method, threshold, kind) for method in NEAR_EDGE_METHODS)]
                     for threshold, description in ROWS.items() for kind, name in near_edge.KINDS.items()])


def law_table(touchstone):
    """Of `fast`, by clearance."""
    data = near_edge_data(touchstone)
    clearances = [2.0**k for k in near_edge.LAW]
    return markdown(["wrong answers of `fast`, radius off by", *(f"{k:g}" if k >= 1 else f"1/{1 / k:g}" for k in clearances)],
                    [[ROWS[threshold], *(cell(*data.near("fast", threshold, is_near=lambda offset, k=k: offset == k)[:2]) for k in clearances)]
                     for threshold in ("face", "edge", "vertex")])


@functools.cache
def absent_engines(touchstone):
    """Those whose libraries this build does without."""
    methods = subprocess.run([touchstone, "methods"], check=True, capture_output=True, text=True).stdout
    return set(ENGINES) - {line.split()[0] for line in methods.splitlines() if line.strip()}


@functools.cache
def outcomes(touchstone):
    """The rows of outcomes.csv, and how many polygons they are about. What is compared with is filtered, which must be exact."""
    present = ["exact", *(engine for engine in ENGINES if engine not in absent_engines(touchstone))]
    with results_of(touchstone, "regress", "--methods", ",".join(present)) as study:
        found = rows_of(study)
        if any(row["wrong"] for row in found if row["method"] == "exact"):
            raise SystemExit("touchstone regress: filtered differs from exact")
        return found, polygons_of(study, found)


def markdown(head, lines):
    head_line, *rows = (f"| {' | '.join(cells)} |\n" for cells in (head, *lines))
    return "".join([head_line, "|" + "---|" * len(head) + "\n", *rows])


def of_engines(head, lines):
    """The first cell of each line names an engine."""
    return markdown(head, [[f"`{engine}`", *cells] for engine, *cells in lines]).replace("|  |", "| |")


def engines_table(touchstone):
    return of_engines(OVERALL, overall(*outcomes(touchstone)))


def engines_by_family_table(touchstone):
    return of_engines(*by_family(outcomes(touchstone)[0]))


def moving_engines_table(touchstone):
    present = [engine for engine in ENGINES if engine not in absent_engines(touchstone) and engine not in NO_SWEEP]
    with results_of(touchstone, "motions", "--methods", ",".join(present), "--samples", str(MOTION_SAMPLES), "--no-pictures") as study:
        return of_engines(motions.ENGINE_HEADS, motions.engine_lines(motions.Data(study)))


TABLES = [  # page, name in its markers, what makes it
    ("docs/methods.md", "near-edge", near_edge_table),
    ("docs/methods.md", "clearance", law_table),
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
