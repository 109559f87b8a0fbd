# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong answers double by double, and the furthest wrong ones."""
from names import TITLES
from studies.near_edge import Data
from values.latex import count, decimal, mean_limit, percent, power, table

METHODS = ["fast", "fast-float", "thesis", "thesis-signed"]
ROWS = ["face", "edge", "vertex", "foot-edge", "foot-vertex"]
ANSWERS = 6  # about an outline: in either placement at the threshold, and one double to either side
FAR = 1000000


def rates(data):
    """Shares of wrong answers by threshold and method."""
    sums = {(threshold, method): data.within_one_double(method, threshold) for threshold in ROWS for method in METHODS}
    return {key: failures / trials for key, (failures, trials) in sums.items()}


def values(study):
    data = Data(study)
    shares = rates(data)
    yield "seed", str(study.run["seed"])
    yield "families", str(data.families)
    trials = min(data.within_one_double(method, threshold)[1] for threshold in ROWS for method in METHODS)
    yield "trials", count(trials)
    yield "limit", decimal(100 * mean_limit(trials // ANSWERS))
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
    head = ["within one double of the threshold", *(rf"\method{{{method}}}" for method in METHODS)]
    yield "near-edge", table("l" + "r" * len(METHODS), head, rows)
