# SPDX-License-Identifier: GPL-3.0-or-later
"""Times and wrong answers near contact, and errors of the computed distance in units in the last place."""
from noise import is_steady
from studies.tradeoff import Data
from results import maybe, natural, number
from values.latex import count, decimal, percent, times


def values(study):
    sums = {}
    for row in study.rows("points.csv", family=str, method=str, quantity=str, asked=natural, correctly_rounded=natural,
                          worst=maybe(number)):
        if row["family"] == "all" and row["quantity"] == "distance":
            sum_ = sums.setdefault(row["method"], [0, 0, 0.0])
            sum_[0] += row["asked"]
            sum_[1] += row["correctly_rounded"]
            sum_[2] = max(sum_[2], row["worst"] or 0)
    for method, (asked, right, worst) in sums.items():
        yield f"distance-asked/{method}", count(asked)
        yield f"distance-right/{method}", "all" if right == asked else percent(right / asked)
        yield f"distance-worst/{method}", decimal(worst)
    data = Data(study)
    near = {method: row for method in data.methods if (row := data.rate(method, "planar"))}
    if near["filtered"]["error"]:
        raise ValueError("filtered is wrong")
    for method, row in near.items():
        noisy = not all(is_steady(each["lower_quartile_ns"], each["upper_quartile_ns"]) for each in (row, near["fast"]))
        yield f"time/{method}", None if noisy else times(row["nanoseconds"] / near["fast"]["nanoseconds"])
        yield f"wrong/{method}", percent(row["error"]) if row["error"] else "none"
