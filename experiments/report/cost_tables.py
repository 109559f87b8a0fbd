#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: cost_tables.py ROOT [--write | --measure TOUCHSTONE | --landed]

Compares the tables of costs in the pages with those of the stored measurements (exit status 1 if one differs), or
writes them there. --measure first runs `touchstone bench` and stores its times, with their quartiles, the machine and the
commit, in docs/cost.json. It needs an idle machine and a program that was built from a landed commit without changes.
--landed checks that HEAD descends from the stored commit (exit status 1 if not, 77 if this clone cannot tell).

Times differ on every run, so no test measures them again. Instructions do not, and tests/experiments/studies/bench/instructions.json stores
them. Without docs/cost.json the README shows instructions in place of times.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

import markers
import noise
from shares import percents

FAMILIES = {  # of `touchstone bench`: family, the contest in it, in words
    ("random-triangles", ""): "triangles, balls anywhere",
    ("half-near", ""): "triangles, half of the balls at a relative distance of 2^-50 from contact",
    ("lattice-tangent", ""): "triangles, all balls exactly tangent",
    ("polygons-128", "all outlines"): "prepared polygons of 128 vertices, small balls near their planes",
}
PLAIN = {"polygons-128": "fast, same tree"}  # the plain doubles that filtered is compared with; elsewhere fast
KERNELS = {"EPICK": "EPICK, `do_intersect`", "EPICK, compare": "EPICK, predicate", "EPECK, compare": "EPECK, predicate", "EPECK": "EPECK, distance"}
RUN = ["command", "date", "commit", "compiler", "flags", "processor"]
DATA, INSTRUCTIONS = "docs/cost.json", "tests/experiments/studies/bench/instructions.json"
QUARTILES = ("median", "lower_quartile", "upper_quartile")
CANNOT_TELL = 77


class CannotTell(Exception):
    """What this clone lacks."""


def fault_of(commit, root):
    """Why times of a commit may not be quoted: a clause; None if HEAD descends from it. Throws CannotTell."""
    if not commit or commit.endswith("+"):
        return "is not a commit alone: the sources had changes" if commit else "is unknown"

    def git(*words):
        return subprocess.run(["git", "-C", root, *words], capture_output=True, text=True)

    if (found := git("rev-parse", "--is-shallow-repository")).returncode:
        raise CannotTell(found.stderr.strip())
    if git("merge-base", "--is-ancestor", commit, "HEAD").returncode == 0:
        return None
    if found.stdout.strip() == "true":
        raise CannotTell("the clone is shallow, and does not hold it; git fetch --unshallow")
    return "is not an ancestor of HEAD"


def ratio_of(contestants, family):
    """Of filtered to plain doubles: median and quartiles within the run; `touchstone bench` has that to the tree inverted."""
    if family not in PLAIN:
        return [contestants["filtered"]["ratio"][which] for which in QUARTILES]
    median, lower, upper = (contestants[PLAIN[family]]["ratio"][which] for which in QUARTILES)
    return [1 / median, 1 / upper, 1 / lower]


def refuse(commit, root):
    if fault := fault_of(commit, root):
        raise SystemExit(f"the program's commit, {commit}, {fault}; measure with one that was built from a landed commit")


def kept(bench, root):
    """What the pages need of the file that `touchstone bench` wrote: times, ratios, wrong answers and the machine."""
    refuse(bench["run"]["commit"], root)
    contests, noisy = [], []
    for contest in bench["contests"]:
        if (contest["family"], contest["name"]) in FAMILIES:
            names = [PLAIN.get(contest["family"], "fast"), "filtered", *KERNELS]
            found = {c["name"]: c for c in contest["contestants"] if c["name"] in names}
            contests.append({"family": contest["family"], "name": contest["name"], "ratio": ratio_of(found, contest["family"]), "contestants": [
                {"name": name, "nanoseconds": [c["nanoseconds"][which] for which in QUARTILES], "wrong": c.get("wrong")} for name, c in found.items()]})
            noisy += [f"{contest['family']}, {name}" for name, c in found.items() if not noise.of_contestant(c)]
            noisy += [f"{contest['family']}, ratio"] if not noise.is_steady(*contests[-1]["ratio"][1:]) else []
    found = {(contest["family"], contest["name"]) for contest in contests}
    if missing := [family for family, name in FAMILIES if (family, name) not in found]:
        raise SystemExit(f"no times of {', '.join(missing)}")
    if noisy:
        raise SystemExit(f"too noisy to quote: {'; '.join(noisy)}; measure again on an idle machine")
    run = {key: bench["run"][key] for key in RUN}
    run["command"] = re.sub(r" --output \S+", "", run["command"])  # a folder of this machine
    return {"run": run, "repetitions": bench["repetitions"], "contests": contests}


def measured(touchstone, root):
    version = subprocess.run([touchstone, "--version"], check=True, capture_output=True, text=True).stdout
    refuse(re.search(r"^commit: (\S+)", version, re.MULTILINE)[1], root)  # before the wait
    with tempfile.TemporaryDirectory() as folder:
        families = ",".join(family for family, _ in FAMILIES)
        subprocess.run([touchstone, "bench", "--family", families, "--quiet", "--output", folder, "--force"], check=True)
        return kept(json.loads(pathlib.Path(folder, "bench.json").read_text()), root)


def markdown(head, rows):
    return "".join(f"| {' | '.join(row)} |\n" for row in (head, ["---"] + ["--:"] * (len(head) - 1), *rows))


def share(wrong):
    if not wrong:
        return ""
    if not wrong["count"]:
        return f"0 of {wrong['of']:,}"
    return percents(wrong["count"], wrong["of"])


def spread(numbers, form):
    """The median, and the quartiles in brackets."""
    median, lower, upper = (format(number, form) for number in numbers)
    return f"{median} ({lower} to {upper})"


def times(data):
    rows = []
    for contest in data["contests"]:
        by_name = {contestant["name"]: contestant for contestant in contest["contestants"]}
        names = [PLAIN.get(contest["family"], "fast"), "filtered", *KERNELS]
        times = [spread(by_name[name]["nanoseconds"], ",.0f") if name in by_name else "" for name in names]
        words = FAMILIES[contest["family"], contest["name"]] + (", both by the same hierarchy" if contest["family"] in PLAIN else "")
        rows.append([words, *times[:2], spread(contest["ratio"], ".2f"), *times[2:],
                     *(share(by_name.get(name, {}).get("wrong")) for name in names[:3])])
    run = data["run"]
    return (f"Nanoseconds per contact query on one core of {run['processor']} ({run['compiler']}, {run['flags']}, commit "
            f"{run['commit'][:12]}): medians of {data['repetitions']} repetitions in turns, quartiles in brackets. CGAL's kernels where their "
            "question is the same. And wrong answers:\n\n" +
            markdown(["", "plain doubles", "`filtered`", "ratio", *KERNELS.values(), "plain doubles wrong", "`filtered` wrong", "EPICK wrong"], rows))


def price(data):
    """The first number that a reader of the README sees: neither side has a hierarchy."""
    ratio = next(contest["ratio"] for contest in data["contests"] if contest["family"] == "random-triangles")
    return (f"**The price.** With balls anywhere, a contact query about a triangle takes `filtered` {ratio[0]:.2f} times as long as `fast` "
            f"(quartiles {ratio[1]:.2f} to {ratio[2]:.2f}). Near contact it takes longer: see [what it costs](#what-it-costs).\n")


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
    measured = json.loads((root / DATA).read_text()) if (root / DATA).exists() else None
    return [("README.md", "price", price(measured) if measured else "**The price.** [What it costs](#what-it-costs), in instructions per query.\n"),
            ("README.md", "cost", times(measured) if measured else counted), ("docs/cost.md", "instructions", counted)]


def landed(root):
    """The exit status of --landed, which says why."""
    if not (root / DATA).exists():
        return 0
    commit = json.loads((root / DATA).read_text())["run"]["commit"]
    try:
        fault = fault_of(commit, root)
    except CannotTell as error:
        print(f"{DATA}: whether HEAD descends from {commit} cannot be told: {error}")
        return CANNOT_TELL
    if fault:
        print(f"{DATA}: {commit} {fault}; cost_tables.py --measure measures again")
    return 1 if fault else 0


def main(root, *options):
    root = pathlib.Path(root)
    if options == ("--landed",):
        return landed(root)
    if options[:1] == ("--measure",):
        (root / DATA).write_text(json.dumps(measured(options[1], root), indent=1) + "\n")
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
