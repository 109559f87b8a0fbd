# SPDX-License-Identifier: GPL-3.0-or-later
"""Times of filtered beside fast and CGAL; and what each of its stages saves, measured once, as variants.json says."""
import json
import pathlib

from noise import of_contestant
from studies.bench import SET, WITHOUT_FLOATS, contests, named, polygons, sets
from values.latex import count, escaped, percent, table, times

TRIANGLES = {  # family: in words
    "random-triangles": "random triangles", "half-near": r"half of the balls at $2^{-50}$",
    "lattice-tangent": "exactly tangent, on lattices", "slivers": r"slivers of aspect $10^{-8}$",
    "far": r"$10^6$ sizes from the origin", "extreme": "extreme exponents"}


ASKED_ONCE = {"asked once": 1, "asked 2 times": 2, "asked 8 times": 8, "asked 32 times": 32, "asked 128 times": 128}


MEASURED_ONCE = json.loads((pathlib.Path(__file__).resolve().parents[1] / "variants.json").read_text())
ALL_STAGES = "all stages"  # compiled and called as the variants are, whose times are relative to its nanoseconds
VARIANTS = {
    "no double": "without doubles over the whole query", "no permanent": "without doubles for one sign",
    "no double-double": "without double-doubles", "no fixed-integer": "without integers of fixed width",
    "only unlimited": "doubles, then integers of any size", "only expansions": "doubles, then expansions",
    "generated filter": "intervals, then integers of any size"}
VARIANTS_ASKED = {"random-triangles": "anywhere", "2^-44": r"at $2^{-44}$", "near": r"at $2^{-50}$", "lattice-tangent": "tangent, lattices"}


def quoted(ratio):
    """None of a ratio whose spread within its run says that it tells nothing: text that quotes it is an error."""
    return None if ratio.get("too_noisy") else times(ratio["median"])


def nanoseconds(contestant):
    """The median; None as of a ratio."""
    return count(round(contestant["nanoseconds"]["median"])) if of_contestant(contestant) else None


def nearness(study):
    found = {int(name.removeprefix("2^-")): contest for name, contest in named(study, "nearness").items()}
    for key, exponent in (("near", max(found)), ("far", min(found))):
        yield key, nanoseconds(found[exponent]["contestants"]["filtered"])
    yield "onset", f"$2^{{-{min(k for k, contest in found.items() if contest['shares']['double'] < 0.99)}}}$"


def sets_without_floats(study):
    """Kind of set, and how many times as long a set takes without floats, which the text calls worth their place."""
    for name, contestants in sets(study).items():
        kind, ratio = "near" if name.endswith("surface") else "anywhere", contestants[WITHOUT_FLOATS]["ratio"]
        if ratio["median"] < 1 and not ratio.get("too_noisy"):
            raise ValueError(f"floats cost more than they save in sets, {kind}, against the text")
        if any(contestants[each]["wrong"]["count"] for each in (SET, WITHOUT_FLOATS)):
            raise ValueError(f"a set is wrong, {kind}")
        yield kind, quoted(contestants[SET]["ratio"]), quoted(ratio)


def values(study):
    every = contests(study)
    for kind, to_fast, without in sets_without_floats(study):
        yield f"sets/{kind}/to-fast", to_fast
        yield f"sets/{kind}/without-floats", without
    for family in ("random-triangles", "half-near"):
        for kernel in ("EPICK", "EPECK"):
            predicate, distance = (every[family, ""][name]["nanoseconds"]["median"] for name in (f"{kernel}, compare", kernel))
            if predicate < 0.95 * distance:
                raise ValueError(f"{kernel}'s compare_squared_distance is faster, against the text")
    yield "variants/commit", MEASURED_ONCE["commit"][:12]
    yield "variants/processor", escaped(MEASURED_ONCE["processor"])
    for key, value in nearness(study):
        yield f"nearness/{key}", value
    yield "queries", count(every["random-triangles", ""]["filtered"]["asked"])
    yield "repetitions", str(len(every["random-triangles", ""]["filtered"]["ratio"]["repetitions"]))
    for family in TRIANGLES:
        for name, contestant in every[family, ""].items():
            if "ratio" in contestant:
                yield f"{family}/{name}/ratio", quoted(contestant["ratio"])
    for vertices, contestants in polygons(every).items():
        yield f"polygons-{vertices}/vertices", count(vertices)
        yield f"polygons-{vertices}/filtered/ratio", quoted(contestants["filtered"]["ratio"])
        if contestants["filtered"].get("wrong", {"count": 0})["count"]:
            raise ValueError(f"filtered is wrong about polygons of {vertices} vertices")


def row(words, contestants):
    ratio, goal = contestants["filtered"]["ratio"], contestants["filtered"].get("goal")
    wrong, tree = contestants["fast"].get("wrong"), contestants.get("fast, same tree", {}).get("ratio")
    noisy = ratio.get("too_noisy", False)
    aim = "" if goal is None or noisy else rf"$\le{goal['at_most']:g}$ {'met' if goal['met'] else 'missed'}"
    return [words, *(nanoseconds(contestants[name]) or "too noisy" for name in ("fast", "filtered")),
            "too noisy" if noisy else f"{times(ratio['median'])} ({times(min(ratio['repetitions']))}--{times(max(ratio['repetitions']))})", aim,
            "" if tree is None else "too noisy" if tree.get("too_noisy") else times(1 / tree["median"]),
            "" if not wrong else percent(wrong["count"] / wrong["of"]) if wrong["count"] else "none"]


def preparation_rows(study):
    for vertices in (8, 32, 1024):
        found = {ASKED_ONCE[name]: contest["contestants"]["filtered"]["ratio"] for name, contest in named(study, f"polygons-{vertices}").items() if name in ASKED_ONCE}
        if found:
            yield [count(vertices), *("" if n not in found else quoted(found[n]) or "too noisy" for n in ASKED_ONCE.values())]


def variants():
    found = [MEASURED_ONCE["times"][asked] for asked in VARIANTS_ASKED]
    rows = [["all stages, nanoseconds", *(count(round(each[ALL_STAGES])) for each in found)], None]
    rows += [[words, *(times(each[name]) for each in found)] for name, words in VARIANTS.items()]
    return table("lrrrr", ["", *VARIANTS_ASKED.values()], rows)


def tables(study):
    every = contests(study)
    rows = [row(words, every[family, ""]) for family, words in TRIANGLES.items()]
    rows += [None, *(row(f"polygons of {count(vertices)} vertices", c) for vertices, c in polygons(every).items())]
    head = ["nanoseconds a query", r"\method{fast}", r"\method{filtered}", "ratio", "goal", "same tree", r"\method{fast} wrong"]
    yield "bench", table("@{}lrrrrrr@{}", head, rows)
    yield "variants", variants()
    yield "preparation", table("rrrrrr", ["vertices", "1 query", *(f"{n}" for n in list(ASKED_ONCE.values())[1:])], list(preparation_rows(study)))
