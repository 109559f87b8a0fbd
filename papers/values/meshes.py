# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces of real meshes, with balls at single doubles from contact."""
from studies.meshes import Data
from values.latex import count, percent

PREFIX = "real"  # of the keys of \val


def values(study):
    data = Data(study)
    certified = [row for row in data.rows if row["method"] == "filtered"]
    if any(row["wrong"] for row in certified):
        raise ValueError("filtered differs from exact")
    yield "meshes", str(len(data.faces))
    yield "faces", count(sum(data.faces.values()))
    yield "answers", count(sum(row["trials"] for row in certified))
    for place in ("face", "edge", "vertex"):
        for method in ("fast", "thesis"):
            wrong, trials = data.counts(method, place=place)
            yield f"{place}/{method}", percent(wrong / trials)
