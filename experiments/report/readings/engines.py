# SPDX-License-Identifier: GPL-3.0-or-later
"""Others' engines on the cases of `touchstone regress`."""
from engines import families_of
from names import UNSURE
from readings.asked import Asked
from results import maybe, natural


def rows_of(study):
    return study.rows("standing.csv", method=str, family=str, wrong=natural, cases=natural, first_offset_exponent=maybe(natural))


def cases_of(rows):
    """Of each method, in all families."""
    return sum(row["cases"] for row in rows if row["method"] == rows[0]["method"])


def polygons_of(study, rows):
    return len(families_of(rows)) * study.run["samples_done"]


def asked(study):
    """The balls of a family share polygons. `filtered` is what the study compares with, and `exact` is asked where another
    differs: so it was tested only if the method exact was asked too. Whether a method that may say "don't know" was wrong,
    the study does not say."""
    rows = rows_of(study)
    polygons = polygons_of(study, rows)
    methods = dict.fromkeys(row["method"] for row in rows if row["method"] not in UNSURE)
    counts = {method: sum(row["wrong"] for row in rows if row["method"] == method) for method in methods}
    return {method: Asked(cases_of(rows), wrong, polygons, "polygons") for method, wrong in counts.items()
            if method != "filtered" or "exact" in methods}
