# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong answers double by double, and the furthest wrong ones."""
from results import finite, maybe, natural
from values.latex import count, percent, power, table

METHODS = ["fast", "fast-float", "thesis", "thesis-signed"]
ROWS = {"face": ("contact", "radius at a face"), "edge": ("contact", "radius at an edge"),
        "vertex": ("contact", "radius at a vertex"), "foot-edge": ("foot", "foot crosses an edge"),
        "foot-vertex": ("foot", "foot passes a vertex")}


def within_one_double(study):
    """Wrong answers and answers by threshold and method."""
    sums = {}
    for row in study.rows("rates.csv", family=str, threshold=str, test=str, method=str, offset=int, failures=natural,
                          trials=natural):
        threshold = ROWS.get(row["threshold"])
        if row["family"] == "all" and threshold and row["test"] == threshold[0] and abs(row["offset"]) <= 1:
            sum_ = sums.setdefault((row["threshold"], row["method"]), [0, 0])
            sum_[0] += row["failures"]
            sum_[1] += row["trials"]
    return sums


def furthest(rows, column, method, distance):
    """The largest share of the size at which the final answer was wrong."""
    return max(row[column] for row in rows if row["method"] == method and row["origin_distance"] == distance
               and row["test"] == "contact" and row[column] is not None)


def values(study):
    sums = within_one_double(study)
    rates = {key: failures / trials for key, (failures, trials) in sums.items()}
    worst = study.rows("worst.csv", threshold=str, origin_distance=int, method=str, test=str, samples=natural,
                       sampled_share=maybe(finite), climbed_share=maybe(finite))
    families = {row["family"] for row in study.rows("rates.csv", family=str)} - {"all"}
    of_fast = [rates[threshold, "fast"] for threshold in ROWS]
    yield "seed", str(study.run["seed"])
    yield "samples", count(study.run["samples_done"])
    yield "families", str(len(families))
    yield "trials", count(min(trials for _, trials in sums.values()))
    yield "searched", count(min(row["samples"] for row in worst))
    yield "least/fast", percent(min(of_fast))
    yield "most/fast", percent(max(of_fast))
    for (threshold, method), rate in rates.items():
        yield f"{threshold}/{method}", percent(rate)
    for method in METHODS:
        yield f"furthest/{method}", power(furthest(worst, "sampled_share", method, 0))
        yield f"climbed/{method}", power(furthest(worst, "climbed_share", method, 0))
        yield f"climbed-far/{method}", power(furthest(worst, "climbed_share", method, 1000000))


def tables(study):
    sums = within_one_double(study)
    rows = [[words, *(percent(sums[threshold, m][0] / sums[threshold, m][1]) for m in METHODS)]
            for threshold, (_, words) in ROWS.items()]
    yield "near-edge", table("l" + "r" * len(METHODS), ["within one double of the threshold", *(rf"\method{{{m}}}" for m in METHODS)],
                             rows)
