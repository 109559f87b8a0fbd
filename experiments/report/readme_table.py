#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: readme_table.py TOUCHSTONE README [--write]

Runs a small near-edge study (seed 1, the same on every machine with this C library) and makes the README's table of it.
Compares the table with the one between the README's markers (exit status 1 if they differ), or writes it there.
"""

import collections
import csv
import pathlib
import subprocess
import sys
import tempfile

BEGIN, END = "<!-- near-edge table: begin -->\n", "<!-- near-edge table: end -->\n"
METHODS = ["fast", "fast-float", "thesis", "thesis-signed"]
SAMPLES = 60
ROWS = {  # threshold: what is asked about there, in words; the test of rates.csv
    "face": ("radius at the distance of a face", "contact"),
    "edge": ("radius at the distance of an edge", "contact"),
    "vertex": ("radius at the distance of a vertex", "contact"),
    "foot-edge": ("foot crosses an edge: is it inside?", "foot"),
    "foot-vertex": ("foot passes a vertex: is it inside?", "foot"),
}


def study(touchstone):
    """Failures and trials by (threshold, method), all families and placements, within one double of the threshold."""
    counts = collections.defaultdict(lambda: [0, 0])
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([touchstone, "near-edge", "--method", ",".join(METHODS), "--samples", str(SAMPLES), "--seed", "1",
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
        return f"{100 * failures / trials:.0f} %"
    return f"0 of {trials} (< {100 * (1 - 0.05 ** (1 / trials)):.2f} %)"


def table(counts):
    lines = ["| within one double of the threshold | " + " | ".join(f"`{method}`" for method in METHODS) + " |",
             "|---|" + "---|" * len(METHODS)]
    for threshold, (description, _) in ROWS.items():
        lines.append(f"| {description} | " + " | ".join(cell(*counts[threshold, method]) for method in METHODS) + " |")
    return "\n".join(lines) + "\n"


def main(touchstone, readme, *options):
    path = pathlib.Path(readme)
    before, _, rest = path.read_text().partition(BEGIN)
    old, _, after = rest.partition(END)
    new = table(study(touchstone))
    if "--write" in options:
        path.write_text(before + BEGIN + new + END + after)
        return 0
    if new != old:
        print("The README's table is not what the study gives; readme_table.py --write mends it:\n" + new)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
