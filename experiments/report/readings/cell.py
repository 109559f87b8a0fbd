# SPDX-License-Identifier: GPL-3.0-or-later
"""What the cell asks: every face at every stop of both case studies, as if no boxes were compared first."""
from readings.asked import Asked
from results import natural

CASES = ("case-1", "case-2")  # folders of runs with --every-face


class Questions:
    def __init__(self, study):
        self.cases = [case for case in CASES if (study.folder / case).is_dir()]
        self.methods, self.near = {}, {}  # name: asked, wrong hits, wrong misses, unsure; k: questions within 2^-k
        self.asked = 0
        for case in self.cases:
            for row in study.rows(f"{case}/methods.csv", method=str, asked=natural, wrong_hits=natural, wrong_misses=natural, unsure=natural):
                before = self.methods.get(row["method"], (0, 0, 0, 0))
                self.methods[row["method"]] = tuple(a + row[name] for a, name in zip(before, ("asked", "wrong_hits", "wrong_misses", "unsure")))
            rows = study.rows(f"{case}/near.csv", exponent=natural, near=natural, questions=natural)
            self.asked += rows[0]["questions"]
            for row in rows:
                self.near[row["exponent"]] = self.near.get(row["exponent"], 0) + row["near"]

    def nearest(self):
        """The greatest k with a question within 2^-k of a face's size from contact."""
        return max((k for k, near in self.near.items() if near), default=None)

    def wrong(self, method):
        _, hits, misses, _ = self.methods[method]
        return hits + misses


def asked(study):
    """Where the boxes of the sphere and of a face meet: the other questions are far from contact, and would dilute sums."""
    rows = study.rows("methods.csv", method=str, asked=natural, wrong_hits=natural, wrong_misses=natural, unsure=natural)
    return {row["method"]: Asked(row["asked"], row["wrong_hits"] + row["wrong_misses"], row["asked"], "questions", row["unsure"]) for row in rows}
