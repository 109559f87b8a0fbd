# SPDX-License-Identifier: GPL-3.0-or-later
"""The smallest results that the paper can be made of: a few rows of each file that it reads, in the formats of the studies."""
import csv
import itertools
import json

RUN = {"seed": 7, "samples_asked": 4, "samples_done": 4, "samples_missing": 0, "parts": 1, "threads": 2, "seconds": 1.5,
       "date": "2026-01-02T03:04:05Z", "commit": "0123456789abcdef", "compiler": "g++ 12", "flags": "-O3", "processor": "some_core",
       "cores": 2, "machine": "Linux", "interrupted": False,
       "engines": ["embree", "fcl", "libccd", "bullet", "ode", "bullet-float"]}
METHODS = ["fast", "fast-float", "thesis", "thesis-signed"]


def table(columns, *rows):
    """Rows of the product of each one's cells: a list stands for one row a cell."""
    names = columns.split()
    lines = []
    for row in rows:
        assert len(row) == len(names), (names, row)
        lines += itertools.product(*(cell if isinstance(cell, list) else [cell] for cell in row))
    return [names, *lines]


RATES = "family placement threshold test method offset failures trials contract lift rate lower upper"
OFFSETS = [-4294967296, -1, 0, 1, 4294967296]
PLACEMENTS = ["lattice-frame", "planar", "rotated"]
FAMILIES = ["all", "star", "triangle"]
AXES = "axis nearness test method"

FILES = {
    "near-edge": {
        "rates.csv": table(RATES, ("all", PLACEMENTS, ["face", "edge", "vertex"], "contact", METHODS, OFFSETS, 2, 8, 3, 1, 0.25, 0, 0.9),
                           (FAMILIES[1:], PLACEMENTS, ["face", "edge", "vertex"], "contact", METHODS, OFFSETS, 1, 4, 1, 0, 0.25, 0, 0.9),
                           ("all", PLACEMENTS, ["foot-edge", "foot-vertex"], "foot", METHODS, OFFSETS, 4, 8, 4, 0, 0.5, 0, 0.9),
                           (FAMILIES[1:], PLACEMENTS, ["foot-edge", "foot-vertex"], "foot", METHODS, OFFSETS, 2, 4, 2, 0, 0.5, 0, 0.9)),
        "properties.csv": table("property from to threshold method offset failures trials rate lower upper",
                                ("tilt", [0, 0.75], 1, "face", METHODS, [-0.5, 0.5], 1, 4, 0.25, 0, 0.9)),
        "bands.csv": table("family placement threshold test method samples failures trials rate",
                           (["all", "star"], PLACEMENTS, ["face", "edge", "vertex"], "contact", METHODS, 4, 1, 20, 0.05),
                           (["all", "star"], PLACEMENTS, ["foot-edge", "foot-vertex"], "foot", METHODS, 4, 2, 20, 0.1)),
        "worst.csv": table("threshold origin_distance method test samples sampled_share climbed_share",
                           ("face", [0, 1000, 1000000], METHODS, "contact", 4, 1e-16, 1e-12)),
        **{f"map-reflex-vertex-foot-{distance}.csv": table("row column truth " + " ".join(METHODS),
                                                           ([0, 1], [0, 1], "i", "=", "-", "=", "+")) for distance in (0, 1000)}},
    "stability": {
        "failures.csv": table(AXES + " level failed_samples samples wrong_answers answers",
                              ("aspect", "one-double", "contact", ["fast", "filtered"], "1", 0, 4, 0, 16),
                              ("vertices", "one-double", "contact", "filtered", ["1e1", "1e3"], 0, 2, 0, 8),
                              ("chain-motion", "one-double", "contact", "filtered", "1", 4, 4, 4, 16)),
        "first-failure.csv": table(AXES + " first_failure failed_samples samples", ("aspect", "close", "contact", "fast", "1e4", 1, 4)),
        "onset.csv": table("origin_distance method offset_exponent failed_triangles triangles wrong_answers answers rate lower upper",
                           ([0, 1000000], ["ericson-absolute", "fast"], -36, 0, 4, 0, 8, 0, 0, 0.5),
                           ([0, 1000000], ["ericson-absolute", "fast"], -51, 1, 4, 2, 8, 0.25, 0, 0.9))},
    "tradeoff": {
        "points.csv": table("family method quantity asked correctly_rounded worst", ("all", "fast", "distance", 8, 4, 17),
                            ("all", "filtered", "distance", 8, 8, 0)),
        "bands.csv": table("family placement threshold test method samples wrong unsure lift answers",
                           ("all", ["planar", "rotated"], ["face", "edge"], "contact", "fast", 4, 1, 0, 1, 8),
                           ("all", ["planar", "rotated"], ["face", "edge"], "contact", "filtered", 4, 0, 0, 0, 8)),
        "timings.csv": table("family placement balls question method lower_quartile_ns median_ns upper_quartile_ns",
                             (["star", "u"], ["planar", "rotated"], ["near", "away"], "contact", ["fast", "filtered"], 90, 100, 110)),
        "front.csv": table("measure family placement method nanoseconds lower_quartile_ns upper_quartile_ns error lower upper finite_error "
                           "not_finite samples front",
                           ("not-right", "all", ["planar", "rotated"], ["fast", "fast-long-double", "fast-double-double", "fast-mpfr-101"], 100, 90, 110, 0.2,
                            0.1, 0.3, 0.2, 0, 8, "on"),
                           ("not-right", "all", ["planar", "rotated"], "filtered", 300, 290, 310, 0, 0, 0.3, 0, 0, 8, "on"))},
    "regress": {
        "outcomes.csv": table("method numbers family wrong unsure cases first_offset_exponent", *(
            (method, numbers, ["star", "u"], wrong, 0, 8, first) for method, wrong, first in
            (("exact", 0, ""), ("filtered", 0, ""), ("fast", 1, 28), ("cgal-epeck-distance", 0, ""), ("fcl", 2, 8)) for numbers in ("doubles", "floats")))},
    "soak": {"soak.csv": table("family way cases double permanent double-double fixed-integer unlimited differences",
                               (["general", "all"], ["triangle", "answer"], 4, 3, 2, 1, 1, 1, 0))},
    "soak-moving": {"soak.csv": table("family way cases double permanent double-double fixed-integer unlimited differences",
                                      (["general", "all"], ["moving-triangle", "moving-prepared"], 4, 3, 2, 1, 1, 1, 0))},
    "motions": {
        "ways.csv": table("way method samples failed answers missed invented unsure furthest timed correctly_rounded median_ulps worst_ulps "
                          "median_size worst_size",
                          (["across", "all"], ["exact", "filtered"], 8, 0, 80, 0, 0, 0, "", 40, 40, 0, 0, 0, 0),
                          (["across", "all"], ["fast", "bullet", "fcl"], 8, 2, 80, 2, 1, 0, 0.0625, 40, 20, 0, 4, 0, 0.25),
                          (["across", "all"], "libccd", 8, 1, 80, 1, 0, 0, 0, 0, 0, "", "", "", "")),
        "thresholds.csv": table("event feature method offset trials missed invented rate",
                                ("graze", "edge", ["filtered", "fast"], [-0.0625, 0.0625], 8, 0, 0, 0)),
        "steps.csv": table("radius steps passes contacts missed rate lower upper", ([0, 0.00390625, 0.0625], [1, 4, 64], 9, 8, 2, 0.25, 0, 0.9))},
    "recorded": {
        "recorded.csv": table("simulation radius method questions touching wrong upper failed_piles piles furthest",
                              (["bullet", "bullet-float"], ["own", "with threshold"], "filtered", 8, 4, 0, 0.3, 0, 2, 0),
                              *((name, ["own", "with threshold"], [name, "fast"], 8, 4, 2, 0.7, 2, 2, 0.25) for name in ("bullet", "bullet-float"))),
        "near.csv": table("simulation radius exponent near questions", (["bullet", "bullet-float"], ["own", "with threshold"], [0, 20, 50], 4, 8))},
    "meshes": {
        "meshes.csv": table("mesh faces rejected method place test trials wrong",
                            ("arm", 4, 1, ["filtered", "exact"], ["face", "edge", "vertex"], "contact", 8, 0),
                            ("arm", 4, 1, ["fast", "thesis"], ["face", "edge", "vertex"], "contact", 8, 1))},
    "bench-scenes": {
        "queries.csv": table("scene triangles balls question library nanoseconds lower_quartile upper_quartile wrong checked",
                             ("torus", [100, 1000], "near", ["any", "all", "nearest"], ["Scene", "Embree 3"], 500, 490, 510, 0, 8),
                             ("torus", 1000, ["anywhere", "touching"], "any", "Scene", 300, 290, 310, 0, 8),
                             ("torus", 1000, ["anywhere", "touching"], "any", "Embree 3", 112_345, 112_000, 113_000, 3, 8)),
        "motions.csv": table("scene triangles motions library nanoseconds lower_quartile upper_quartile wrong checked",
                             ("torus", 1000, "short", "Scene, at the start", 200, 190, 210, "", ""), ("torus", 1000, "short", "Scene", 400, 390, 410, 0, 8),
                             ("torus", 1000, "short", ["FCL BVHModel", "Bullet"], 9000, 8900, 9100, 2, 8)),
        "builds.csv": table("scene triangles library seconds bytes_a_triangle", ("torus", 1000, ["Scene", "Embree 3"], 0.5, 91))},
    "cell": {f"{case}/{name}": rows for case in ("case-1", "case-2") for name, rows in {
        "methods.csv": table("method asked wrong_hits wrong_misses unsure", (["fast", "thesis"], 100, 0, 0, 0)),
        "near.csv": table("exponent near questions", (0, 50, 100), (1, 9, 100), (2, 3, 100), (3, 0, 100))}.items()},
    "thesis": {
        "entries.csv": table("id status", ("4.1", "reproduced with chosen values"), ("E.1", "differs"), ("4.4", "self-check"), ("4.6", "derived"), ("2.1", "not computable"),
                             ("table 5.1", "differs")),
        "numbers.csv": table("id what ours", ("table 6.1", "values of the layout that are chosen freely", 12),
                             ("table 6.1", "captioned moves of both cases that it must reproduce", 10), ("table 6.1", "home poses that were tried", 400),
                             ("table 6.1", "of these with a layout in which all captions hold", 45)),
        "predictions.csv": table("basis base_to_storage_deg base_to_storage_implied_deg base_to_machine_deg base_to_machine_implied_deg elbow_at_machine_deg "
                                 "elbow_at_machine_implied_deg shoulder_at_machine_deg shoulder_at_machine_implied_deg",
                                 ("fitted", -149, -149, 66, 66, 35, 35, 28, 28), ("predicted", -150, -150, 67, 67, 35, 35, 28, 28)),
        "moves.csv": table("phase joint degrees", ("to-storage", "elbow", -3), ("to-storage", "base", -149), ("to-machine", "base", 66), ("to-home", "base", 149)),
        "areas.csv": table("outline points share lower upper hull parts", (["U3x3", "square"], 100, 0.86, 0.8, 0.9, 0.29, 3)),
        "touching.csv": table("balls missed", (8, 7))},
}


def quartiles(median):
    return {"median": median, "lower_quartile": median, "upper_quartile": median, "repetitions": [median]}


def contest(family, name):
    first = {"name": "fast", "asked": 8, "nanoseconds": quartiles(20), "wrong": {"count": 1, "of": 8}}
    names = ("filtered", "EPICK", "EPICK, compare", "EPECK", "EPECK, compare")
    if family == "batches":
        names = ("filtered", "filtered, set", "filtered, no floats")
    others = [{"name": other, "asked": 8, "nanoseconds": quartiles(30), "wrong": {"count": 0, "of": 8},
               "ratio": quartiles(1.5)} for other in names]
    return {"family": family, "name": name, "contestants": [first, *others]}


STAGES = ("double", "permanent", "double-double", "fixed-integer", "unlimited")
BENCH = {"contests": [*(contest(family, "") for family in ("random-triangles", "half-near", "lattice-tangent", "slivers", "far", "extreme")),
                      contest("motions", "contact, random triangles"), contest("polygons-8", "all outlines"), contest("polygons-100000", "all outlines"),
                      *(contest("polygons-8", f"asked {how}") for how in ("once", "2 times", "8 times")),
                      *(contest("batches", f"one ball, 1024 triangles{where}") for where in ("", ", all near its surface")),
                      *(contest("nearness", f"2^-{k}") | {"shares": {stage: 0.2 for stage in STAGES} if k > 20 else dict(zip(STAGES, (1, 0, 0, 0, 0)))}
                        for k in (52, 24, 1))]}


RATES_OF_SEED = {name: FILES["near-edge"][name] for name in ("rates.csv", "bands.csv", "properties.csv")}
FILES["seeds"] = {f"{part}{name}": rows for part in ("", *(f"seed-{seed}/" for seed in range(3, 7))) for name, rows in RATES_OF_SEED.items()}


def write(results):
    for study, files in {**FILES, "bench": {}}.items():
        folder = results / study
        folder.mkdir(parents=True)
        (folder / "run.json").write_text(json.dumps(RUN | {"command": f"touchstone {study} --seed 7"}))
        for name, rows in files.items():
            (folder / name).parent.mkdir(exist_ok=True)
            with open(folder / name, "w", newline="") as file:
                csv.writer(file).writerows(rows)
    (results / "bench" / "bench.json").write_text(json.dumps(BENCH))
