# SPDX-License-Identifier: GPL-3.0-or-later
"""Random polygons, double by double: wrong answers at thresholds, and the furthest from them."""
from names import DISTANCES, OWN_TEST, PLACEMENTS, THRESHOLDS
from readings.asked import by_method
from results import finite, maybe, natural, share

CONTACT = ("face", "edge", "vertex", "tangent")  # thresholds of the radius, which the final answer crosses


def final_test(threshold):
    """Of the test that is decided at a threshold: the final answer, or where an ample ball hides the foot, the foot's."""
    return "contact" if threshold in CONTACT else OWN_TEST[threshold]


class Data:
    def __init__(self, study):
        rates = study.rows("rates.csv", family=str, placement=str, threshold=str, test=str, method=str, offset=int, failures=natural,
                           trials=natural)
        self.rates = [row for row in rates if row["family"] == "all"]
        bands = study.rows("bands.csv", family=str, placement=str, threshold=str, test=str, method=str, samples=natural,
                           failures=natural, trials=natural, rate=share)
        self.families = len({row["family"] for row in bands} - {"all"})
        self.bands = [row for row in bands if row["family"] == "all"]
        self.worst = [] if not (study.folder / "worst.csv").exists() else study.rows(
            "worst.csv", threshold=str, origin_distance=natural, method=str, samples=natural, sampled_share=maybe(finite),
            climbed_share=maybe(finite))
        self.methods = list(dict.fromkeys(row["method"] for row in self.bands))
        self.thresholds = [t for t in THRESHOLDS if any(row["threshold"] == t for row in self.bands)]
        self.placements = [p for p in PLACEMENTS if any(row["placement"] == p for row in self.bands)]

    def within_one_double(self, method, threshold):
        """Failures and answers of the test that is decided there."""
        rows = [row for row in self.rates if row["method"] == method and row["threshold"] == threshold and abs(row["offset"]) <= 1 and
                row["test"] == final_test(threshold)]
        return sum(row["failures"] for row in rows), sum(row["trials"] for row in rows)

    def samples(self, threshold):
        return sum(row["samples"] for row in self.bands if row["threshold"] == threshold and row["test"] == final_test(threshold) and
                   row["method"] == self.methods[0])

    def furthest(self, method, distance, thresholds, names=("sampled_share", "climbed_share")):
        """Of wrong answers, as a share of the polygon's size, of random samples and of the search; 0 where none was seen."""
        return max((row[name] or 0 for row in self.worst for name in names if row["method"] == method and
                    row["origin_distance"] == distance and row["threshold"] in thresholds), default=0)

    @property
    def distances(self):
        return [d for d in DISTANCES if any(row["origin_distance"] == d for row in self.worst)]


def asked(study):
    """Final answers, at all offsets. A sample has the same outline at all thresholds and in both placements."""
    data = Data(study)
    outlines = max(row["samples"] for row in data.bands)
    return by_method([dict(row, answers=row["trials"], wrong=row["failures"]) for row in data.bands if row["test"] == "contact"],
                     dict.fromkeys(data.methods, outlines), "outlines")
