# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong answers double by double, and the furthest wrong ones."""
from names import TITLES
from studies.near_edge import LAW, Data, law
from values.latex import count, decimal, mean_limit, percent, power, table

METHODS = ["fast", "fast-float", "thesis", "thesis-signed"]
ROWS = ["face", "edge", "vertex", "foot-edge", "foot-vertex"]
NEAREST = 15  # offsets within u x size, to either side: the most answers about a polygon
FAR = 1000000


def rates(data):
    """Shares of wrong answers about exactly planar polygons, by threshold and method."""
    sums = {(threshold, method): data.near(method, threshold) for threshold in ROWS for method in METHODS}
    return {key: failures / trials for key, (failures, trials, _) in sums.items()}


def values(study):
    data = Data(study)
    shares = rates(data)
    yield "seed", str(study.run["seed"])
    yield "families", str(data.families)
    trials = min(data.near(method, threshold)[1] for threshold in ROWS for method in METHODS)
    yield "trials", count(trials)
    yield "nearest", str(NEAREST)
    yield "limit", decimal(100 * mean_limit(trials // NEAREST))
    for threshold in ("edge", "vertex"):
        failures, of, lift = data.near("fast", threshold, "loops", lambda offset: offset == 0)
        yield f"given/{threshold}", percent(failures / of)
        yield f"lift/{threshold}", percent(lift / of)
    yield "searched", count(min(row["samples"] for row in data.worst))
    yield "least/fast", percent(min(shares[threshold, "fast"] for threshold in ROWS))
    yield "most/fast", percent(max(shares[threshold, "fast"] for threshold in ROWS))
    for (threshold, method), share in shares.items():
        yield f"{threshold}/{method}", percent(share)
    for method in METHODS:
        yield f"furthest/{method}", power(data.furthest(method, 0, ["sampled_share"]))
        yield f"climbed/{method}", power(data.furthest(method, 0))
        yield f"climbed-far/{method}", power(data.furthest(method, FAR))


def tables(study):
    shares = rates(Data(study))
    rows = [[TITLES[threshold], *(percent(shares[threshold, method]) for method in METHODS)] for threshold in ROWS]
    head = [r"within $u\cdot$size of the threshold", *(rf"\method{{{method}}}" for method in METHODS)]
    yield "near-edge", table("l" + "r" * len(METHODS), head, rows)
    heads = [rf"$2^{{{k}}}$" if k else "1" for k in LAW]
    yield "law", table("l" + "r" * len(LAW), [r"clearance, $u\cdot$size", *heads],
                       [[TITLES[threshold], *("--" if s is None else percent(s) if s else "none" for s in shares)]
                        for threshold, shares in law(Data(study), "fast").items()])
