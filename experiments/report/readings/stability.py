# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons under stress: how many of them methods fail on, and from which level."""
from names import AXES, MODES
from readings.asked import Asked
from results import finite, maybe, natural, number, share

STAND_IN = "-motion"  # axes on which filtered and exact stand for the motion of doubles, and err as that does


class Data:
    def __init__(self, study):
        rows = study.rows("failures.csv", axis=str, level=str, nearness=str, test=str, method=str, failed_samples=natural, samples=natural,
                          wrong_answers=natural, answers=natural)
        self.all_tests = rows
        self.rows = [row for row in rows if row["test"] == "contact"]
        self.first = [row for row in study.rows("first-failure.csv", axis=str, nearness=str, test=str, method=str, first_failure=str,
                                                failed_samples=natural, samples=natural) if row["test"] == "contact"]
        self.tightness = [row for row in study.rows("tightness.csv", stage=str, quantity=str, axis=str, observations=natural,
                                                    exceeded=natural, max=maybe(number)) if row["axis"] == "all"]
        self.onset = study.rows("onset.csv", origin_distance=finite, method=str, offset_exponent=int, failed_triangles=natural,
                                triangles=natural, wrong_answers=natural, answers=natural, rate=share)
        self.contraction = study.rows("contraction.csv", sign=str, family=str, trials=natural, plain_wrong=natural, plain_lower=share,
                                      plain_upper=share, fused_wrong=natural, fused_lower=share, fused_upper=share)
        self.methods = list(dict.fromkeys(row["method"] for row in self.rows))
        self.axes = [axis for axis in AXES if any(row["axis"] == axis for row in self.rows)]

    def failed(self, method, nearness):
        """Polygons that the method was wrong about, and all; without axes whose truth is another one."""
        own = [row for row in self.rows if row["method"] == method and row["nearness"] == nearness and row["axis"] not in MODES
               and not row["axis"].endswith(STAND_IN)]
        return sum(row["failed_samples"] for row in own), sum(row["samples"] for row in own)

    def first_failure(self, axis, nearness, method):
        """The level, "" where none failed; None where it was not asked."""
        return next((row["first_failure"] for row in self.first
                     if (row["axis"], row["nearness"], row["method"]) == (axis, nearness, method)), None)


def asked(study):
    data = Data(study)
    counts = {}
    for method in data.methods:
        rows = [row for row in data.rows if row["method"] == method and not row["axis"].endswith(STAND_IN)]
        polygons = sum(row["samples"] for row in rows if row["nearness"] == rows[0]["nearness"])
        counts[method] = Asked(sum(row["answers"] for row in rows), sum(row["wrong_answers"] for row in rows), polygons, "polygons")
    return counts
