# SPDX-License-Identifier: GPL-3.0-or-later
"""Times of filtered beside fast and CGAL."""
from readings.bench import contests, polygons
from values.latex import count, percent, table, times

TRIANGLES = {  # family: in words
    "random-triangles": "random triangles", "half-near": r"half of them at $2^{-50}$",
    "lattice-tangent": "exactly tangent, on lattices", "slivers": r"slivers of aspect $10^{-8}$",
    "far": r"$10^6$ sizes from the origin", "extreme": "extreme exponents"}


def values(study):
    every = contests(study)
    yield "queries", count(every["random-triangles", ""]["filtered"]["asked"])
    yield "repetitions", str(len(every["random-triangles", ""]["filtered"]["ratio"]["repetitions"]))
    for family in TRIANGLES:
        for name, contestant in every[family, ""].items():
            if "ratio" in contestant:
                yield f"{family}/{name}/ratio", times(contestant["ratio"]["median"])
    for vertices, contestants in polygons(every).items():
        yield f"polygons-{vertices}/vertices", count(vertices)
        yield f"polygons-{vertices}/filtered/ratio", times(contestants["filtered"]["ratio"]["median"])
        if contestants["filtered"].get("wrong", {"count": 0})["count"]:
            raise ValueError(f"filtered is wrong about polygons of {vertices} vertices")


def row(words, contestants):
    ratio, goal = contestants["filtered"]["ratio"], contestants["filtered"].get("goal")
    wrong = contestants["fast"].get("wrong")
    aim = "" if goal is None else rf"$\le{goal['at_most']:g}$ {'met' if goal['met'] else 'missed'}"
    nanoseconds = lambda name: count(round(contestants[name]["nanoseconds"]["median"]))
    return [words, nanoseconds("fast"), nanoseconds("filtered"),
            times(ratio["median"]), f"{times(min(ratio['repetitions']))} to {times(max(ratio['repetitions']))}", aim,
            "" if not wrong else percent(wrong["count"] / wrong["of"]) if wrong["count"] else "none"]


def tables(study):
    every = contests(study)
    rows = [row(words, every[family, ""]) for family, words in TRIANGLES.items()]
    rows += [None, *(row(f"polygons of {count(vertices)} vertices", c) for vertices, c in polygons(every).items())]
    head = ["nanoseconds a question", r"\method{fast}", r"\method{filtered}", "ratio", "seen", "goal", r"\method{fast} wrong"]
    yield "bench", table("@{}lrrrrrr@{}", head, rows)
