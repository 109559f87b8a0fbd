# SPDX-License-Identifier: GPL-3.0-or-later
"""How often a method was asked in a study, of how many things drawn independently, and how often it was wrong."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Asked:
    answers: int  # that were compared with the exact ones
    wrong: int
    trials: int  # polygons, outlines, faces or cases: answers about the same one depend on each other
    trial: str  # what these are called, in the plural
    unsure: int = 0  # answers "don't know"


def by_method(rows, trials, trial):
    """Of rows that have `method`, `answers`, `wrong` and perhaps `unsure`; `trials` by method."""
    sums = {}
    for row in rows:
        sum_ = sums.setdefault(row["method"], [0, 0, 0])
        sum_[0] += row["answers"]
        sum_[1] += row["wrong"]
        sum_[2] += row.get("unsure", 0)
    return {method: Asked(answers, wrong, trials[method], trial, unsure) for method, (answers, wrong, unsure) in sums.items()}
