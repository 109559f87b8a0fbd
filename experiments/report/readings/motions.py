# SPDX-License-Identifier: GPL-3.0-or-later
"""Moving balls: wrong answers to whether they touch, and the errors of their times."""
from readings.asked import by_method
from results import finite, maybe, natural, number, share


class Data:
    def __init__(self, study):
        rows = study.rows("ways.csv", way=str, method=str, samples=natural, failed=natural, answers=natural, missed=natural,
                          invented=natural, unsure=natural, furthest=maybe(finite), timed=natural, correctly_rounded=natural,
                          median_ulps=maybe(number), worst_ulps=maybe(number), median_size=maybe(number), worst_size=maybe(number))
        self.methods = list(dict.fromkeys(row["method"] for row in rows))
        self.ways = [way for way in dict.fromkeys(row["way"] for row in rows) if way != "all"]
        self.at = {(row["way"], row["method"]): row for row in rows}
        self.thresholds = study.rows("thresholds.csv", event=str, feature=str, method=str, offset=finite, trials=natural,
                                     missed=natural, invented=natural, rate=share)

    def all(self, method):
        return self.at["all", method]

    def furthest(self, method, event, feature):
        """The largest share of the size by which a radius with a wrong answer is off such a threshold; None without one."""
        return max((abs(row["offset"]) for row in self.thresholds if row["method"] == method and row["event"] == event and
                    row["feature"] == feature and row["missed"] + row["invented"]), default=None)


def asked(study):
    """Whether the ball touches."""
    data = Data(study)
    rows = [dict(data.all(method), wrong=data.all(method)["missed"] + data.all(method)["invented"]) for method in data.methods]
    return by_method(rows, {row["method"]: row["samples"] for row in rows}, "motions")
