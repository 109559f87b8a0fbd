#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Instructions a query of `fast` and `filtered`, counted by valgrind: unlike times they do not vary, so that a change
of a few percent shows. Each candidate is asked the same queries once and twice; the difference leaves out how the
queries were drawn. --baseline holds them against what they were: exit status 1 if a count has grown by more than
3 percent. They are a compiler's as much as ours: tests/experiments/studies/bench/instructions.json is g++ 12's, release,
and --json makes it anew.

Valgrind counts what the program runs on its virtual processor, which has AVX2 but no AVX-512, and evaluates with
round to nearest only: what relies on other rounding modes (CGAL's intervals) is not to be counted this way."""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

MOST_GROWTH = 0.03


def fail(message):
    print(f"instructions.py: {message}", file=sys.stderr)
    sys.exit(2)


def instructions(program, family, candidate, samples, seed, times):
    """(instructions of the whole run, queries asked in each of the times)."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={os.path.join(folder, 'out')}", program,
                   "bench", "--family", family, "--count", candidate, "--samples", str(samples), "--seed", str(seed),
                   "--repetitions", str(times)]
        run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        own = [line for line in run.stderr.splitlines() if line and not line.startswith("==")]
        fail(own[0] if own else f"{' '.join(command)}: failed")
    collected = re.search(r"Collected : (\d+)", run.stderr)
    asked = re.search(r": (\d+) queries", run.stdout)
    if not collected or not asked:
        fail(f"{' '.join(command)}: no count in what it printed")
    return int(collected.group(1)), int(asked.group(1))


def per_query(program, family, candidate, samples, seed):
    once, queries = instructions(program, family, candidate, samples, seed, 1)
    twice, _ = instructions(program, family, candidate, samples, seed, 2)
    return (twice - once) / queries


def read_baseline(path, asked):
    """Instructions a query by family and candidate, of the same samples and seed."""
    try:
        with open(path, encoding="utf-8") as file:
            held = json.load(file)
        rows = held["instructions_per_query"]
        found = {key: held[key] for key in asked}
    except OSError as error:
        fail(f"{path}: cannot be read: {error.strerror}")
    except (ValueError, KeyError, TypeError) as error:
        fail(f"{path}: is no baseline: {error!r}")
    if found != asked:
        fail(f"{path}: is of {found}, not of {asked}")
    return rows


def held_against(baseline, family, row):
    """Prints what differs by more than MOST_GROWTH; whether a count has grown so."""
    worse = False
    for name, now in row.items():
        before = baseline.get(family, {}).get(name)
        if before is None:
            fail(f"the baseline has no {name} of {family}")
        growth = now / before - 1
        if abs(growth) > MOST_GROWTH:
            print(f"  {name}: {growth:+.1%}, {before:.1f} before", flush=True)
        worse |= growth > MOST_GROWTH
    return worse


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("program", help="the touchstone to be run")
    parser.add_argument("--family", default="random-triangles,half-near,lattice-tangent,polygons-128",
                        help="families of `touchstone bench`, separated by commas (default: %(default)s)")
    parser.add_argument("--candidate", default="fast,filtered", help="default: %(default)s")
    parser.add_argument("--samples", type=int, default=2000, help="queries of each family (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", metavar="FILE", help="also write the numbers there")
    parser.add_argument("--baseline", metavar="FILE", help="numbers that --json wrote; exit status 1 where one has grown")
    options = parser.parse_args()
    if options.samples < 1:
        parser.error("--samples: at least 1")
    if shutil.which("valgrind") is None:
        fail("valgrind is not installed (Debian package valgrind)")
    if not os.access(options.program, os.X_OK):
        fail(f"{options.program}: not a program")

    candidates = options.candidate.split(",")
    asked = {"samples": options.samples, "seed": options.seed}
    baseline = read_baseline(options.baseline, asked) if options.baseline else None
    rows, worse = {}, False
    head = (f"{'instructions a query':<22}" + "".join(f"{name:>14}" for name in candidates)
            + "".join(f"{name + ' / ' + candidates[0]:>20}" for name in candidates[1:]))
    for family in options.family.split(","):
        row = {name: per_query(options.program, family, name, options.samples, options.seed) for name in candidates}
        if not rows:
            print(head)
        rows[family] = row
        print(f"{family:<22}" + "".join(f"{row[name]:>14.1f}" for name in candidates)
              + "".join(f"{row[name] / row[candidates[0]]:>20.3f}" for name in candidates[1:]), flush=True)
        if baseline is not None:
            worse |= held_against(baseline, family, row)
    if options.json:
        result = {**asked, "instructions_per_query": rows}
        try:
            with open(options.json, "w", encoding="utf-8") as file:
                json.dump(result, file, indent=2)
                file.write("\n")
        except OSError as error:
            fail(f"{options.json}: cannot be written: {error.strerror}")
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main())
