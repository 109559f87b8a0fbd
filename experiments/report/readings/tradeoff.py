# SPDX-License-Identifier: GPL-3.0-or-later
"""Run time and error of methods near contact."""
from methods import asks_the_question
from names import PLACEMENTS
from noise import is_steady
from readings.asked import by_method
from results import finite, natural, number


class Data:
    def __init__(self, study):
        self.front = [row for row in study.rows("front.csv", measure=str, family=str, placement=str, method=str, nanoseconds=finite,
                                                lower_quartile_ns=finite, upper_quartile_ns=finite,
                                                error=number, lower=number, upper=number, samples=natural, front=str)
                      if row["family"] == "all"]
        self.bands = [row for row in study.rows("bands.csv", family=str, placement=str, threshold=str, test=str, method=str, samples=natural,
                                                wrong=natural, unsure=natural, answers=natural)
                      if row["family"] == "all" and row["test"] == "contact"]
        self.timings = study.rows("timings.csv", family=str, placement=str, balls=str, question=str, method=str, lower_quartile_ns=finite, median_ns=finite,
                                  upper_quartile_ns=finite)
        self.placements = [p for p in PLACEMENTS if any(row["placement"] == p for row in self.front)]
        self.methods = list(dict.fromkeys(row["method"] for row in self.front))

    def rate(self, method, placement):
        """The row of not-right answers; None where the method gives no final answer."""
        return next((row for row in self.front if (row["measure"], row["method"], row["placement"]) == ("not-right", method, placement)), None)

    def nanoseconds(self, method, placement, balls, which="median_ns"):
        """The mean over families of the medians, or quartiles, of a question about contact; None where it was not timed."""
        times = [row[which] for row in self.timings if
                 (row["method"], row["placement"], row["balls"], row["question"]) == (method, placement, balls, "contact")]
        return sum(times) / len(times) if times else None

    def ratio(self, method, placement, balls):
        """To fast; None where one was not timed."""
        own, fast = (self.nanoseconds(m, placement, balls) for m in (method, "fast"))
        return own / fast if own and fast else None

    def is_noisy(self, method, placement, balls):
        """Whether the times of the method, or those of fast, vary too much to quote their ratio."""
        return not all(is_steady(*(self.nanoseconds(m, placement, balls, f"{which}_quartile_ns") for which in ("lower", "upper"))) for m in (method, "fast"))


def asked(study):
    """Final answers. A sample has the same outline at all thresholds and in both placements."""
    data = Data(study)
    outlines = {}
    for row in data.bands:
        outlines[row["method"]] = max(outlines.get(row["method"], 0), row["samples"])
    return by_method([row for row in data.bands if asks_the_question(row["method"], row["placement"])], outlines, "outlines")
