# SPDX-License-Identifier: GPL-3.0-or-later
"""Moving balls: what methods and engines answer near their thresholds, and what steps miss."""
from shares import upper_limit
from studies import steps
from studies.motions import Data
from studies.regress import ENGINES
from values.latex import count, decimal, percent, power, table

CERTIFIED = ("exact", "filtered")
SMALL, LARGE = 2.0**-8, 2.0**-4  # radii of balls that steps move, in sizes of the polygon
FEW, MANY = 4, 64  # steps


def furthest(row):
    return "none" if row["furthest"] is None else power(row["furthest"]) if row["furthest"] else "0"


def values(study):
    data = Data(study)
    if any(data.all(method)["failed"] for method in CERTIFIED if method in data.methods):
        raise ValueError("exact and filtered differ")
    samples = data.all("filtered")["samples"]
    yield "motions", count(samples)
    yield "limit", percent(upper_limit(samples))
    yield "answers", count(data.all("filtered")["answers"])
    for method in ("fast", "bullet", "fcl"):
        row = data.all(method)
        yield f"wrong/{method}", percent(row["failed"] / row["samples"])
        yield f"furthest/{method}", furthest(row)
        yield f"worst-size/{method}", decimal(row["worst_size"])
    walked = steps.Data(study)
    yield "passes", count(walked.passes)
    for name, radius in (("small", SMALL), ("large", LARGE)):
        yield f"{name}/radius", power(radius)
        for kind, number in (("few", FEW), ("many", MANY)):
            yield f"{name}/{kind}", percent(walked.at[radius, number]["rate"])
    yield "few", count(FEW)
    yield "many", count(MANY)


def tables(study):
    data = Data(study)
    rows = []
    for method in data.methods:
        if method not in ENGINES:
            continue
        row = data.all(method)
        rows.append([rf"\method{{{method}}}", percent(row["failed"] / row["samples"]) if row["failed"] else "none", count(row["missed"]),
                     count(row["invented"]), furthest(row), percent(row["correctly_rounded"] / row["timed"]) if row["timed"] else "no time",
                     decimal(row["worst_size"]) if row["timed"] else ""])
    yield "motions", table("lrrrrrr", ["engine", "wrong", "missed", "invented", "furthest", "times exact", "worst time"], rows)
