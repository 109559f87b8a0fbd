# SPDX-License-Identifier: GPL-3.0-or-later
"""The rates of random polygons with other seeds."""
import dataclasses
import pathlib
import typing

from names import TITLES
from studies.near_edge import Data
from studies.seeds import SEEDS
from values.latex import percent, table
from values.near_edge import METHODS, ROWS, rates


@dataclasses.dataclass
class OfSeed:
    """What was written with one seed, in a folder of the study."""
    study: typing.Any
    part: str

    @property
    def folder(self):
        return pathlib.Path(self.study.folder, self.part)

    def rows(self, name, **columns):
        return self.study.rows(self.part + name, **columns)


def of_seeds(study):
    return [Data(OfSeed(study, "" if seed == SEEDS[0] else f"seed-{seed}/")) for seed in SEEDS]


def span(shares):
    """The least and the largest, as 21 to 31 %."""
    least, most = percent(min(shares)), percent(max(shares))
    return most if least == most else least.removesuffix(r"\,\%") + "--" + most


def values(study):
    every = of_seeds(study)
    if any(row["failures"] for data in every for row in data.bands if row["method"] == "filtered"):
        raise ValueError("filtered was wrong with another seed")
    shares = [rates(data) for data in every]
    yield "count", str(len(every))
    yield "widest", f"{100 * max(max(s[key] for s in shares) - min(s[key] for s in shares) for key in shares[0]):.1f}"


def tables(study):
    shares = [rates(data) for data in of_seeds(study)]
    rows = [[TITLES[threshold], *(span([s[threshold, method] for s in shares]) for method in METHODS)] for threshold in ROWS]
    yield "seeds", table("l" + "r" * len(METHODS), [r"within $u\cdot$size of the threshold", *(rf"\method{{{method}}}" for method in METHODS)], rows)
