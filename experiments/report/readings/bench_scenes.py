# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole scenes beside other libraries."""
from noise import is_steady
from results import finite, maybe, natural

OURS = "Scene"


def are_steady(*rows):
    """Whether the times of these may be quoted, and their ratios."""
    return all(is_steady(row["lower_quartile"], row["upper_quartile"]) for row in rows)


class Data:
    def __init__(self, study):
        self.queries = study.rows("queries.csv", scene=str, triangles=natural, balls=str, question=str, library=str, nanoseconds=finite,
                                  lower_quartile=finite, upper_quartile=finite, wrong=natural, checked=natural)
        self.builds = study.rows("builds.csv", scene=str, triangles=natural, library=str, seconds=finite, bytes_a_triangle=finite)
        self.motions = study.rows("motions.csv", scene=str, triangles=natural, motions=str, library=str, nanoseconds=finite, lower_quartile=finite,
                                  upper_quartile=finite, wrong=maybe(natural),
                                  checked=maybe(natural))
        self.libraries = list(dict.fromkeys(row["library"] for row in self.queries))
        self.scenes = list(dict.fromkeys(row["scene"] for row in self.queries))

    def largest(self, scene):
        return max(row["triangles"] for row in self.queries if row["scene"] == scene)

    def wrong(self, library):
        rows = [row for row in [*self.queries, *self.motions] if row["library"] == library]
        return sum(row["wrong"] for row in rows), sum(row["checked"] for row in rows)
