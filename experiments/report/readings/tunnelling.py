# SPDX-License-Identifier: GPL-3.0-or-later
"""What discrete steps of a moving ball miss, and what the exact sweep costs beside them."""
from noise import is_steady
from results import finite, maybe, natural, share

CONTACT, FIRST = "contact of the motion", "first contact of the motion"


class Data:
    def __init__(self, study):
        self.misses = study.rows("misses.csv", radius=finite, steps=natural, contacts=natural, missed=natural, rate=share, lower=share,
                                 upper=share)
        self.radii = list(dict.fromkeys(row["radius"] for row in self.misses))
        self.steps = list(dict.fromkeys(row["steps"] for row in self.misses))
        self.at = {(row["radius"], row["steps"]): row for row in self.misses}
        self.cost = {} if not (study.folder / "cost.csv").exists() else {
            row["asked"]: row for row in study.rows("cost.csv", asked=str, median_ns=finite, lower_quartile_ns=finite, upper_quartile_ns=finite, lower_quartile_ratio=maybe(finite),
                                                 median_ratio=maybe(finite), upper_quartile_ratio=maybe(finite))}

    def cost_of(self, steps):
        return self.cost[f"{steps} step{'' if steps == 1 else 's'}"]


def has_steady_time(row):
    return is_steady(row["lower_quartile_ns"], row["upper_quartile_ns"])


def has_steady_ratio(row):
    """Whether it has a ratio that may be quoted."""
    return bool(row["median_ratio"]) and is_steady(row["lower_quartile_ratio"], row["upper_quartile_ratio"])


def asked(study):
    """Steps are not a method: they are asked by filtered, as the sweep is."""
    return {}
