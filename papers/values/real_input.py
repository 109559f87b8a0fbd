# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces of real meshes, with balls at single doubles from contact."""
from results import natural
from values.latex import count, percent

METHODS = ["fast", "thesis"]


def values(study):
    rows = study.rows("meshes.csv", mesh=str, faces=natural, rejected=natural, method=str, place=str, test=str,
                      trials=natural, wrong=natural)
    if any(row["wrong"] for row in rows if row["method"] == "filtered"):
        raise ValueError("filtered differs from exact")
    contact = [row for row in rows if row["test"] == "contact"]
    yield "meshes", str(len({row["mesh"] for row in rows}))
    yield "faces", count(sum({row["mesh"]: row["faces"] - row["rejected"] for row in rows}.values()))
    yield "answers", count(sum(row["trials"] for row in rows if row["method"] == "filtered"))
    for place in ("face", "edge", "vertex"):
        for method in METHODS:
            here = [row for row in contact if (row["place"], row["method"]) == (place, method)]
            yield f"{place}/{method}", percent(sum(row["wrong"] for row in here) / sum(row["trials"] for row in here))


def tables(study):
    return ()
