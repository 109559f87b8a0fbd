# SPDX-License-Identifier: GPL-3.0-or-later
"""Queries against the largest scene."""
from results import finite, natural
from values.latex import count, escaped, table


def largest(study):
    rows = study.rows("queries.csv", scene=str, triangles=natural, balls=str, question=str, library=str, nanoseconds=finite,
                      wrong=natural, checked=natural)
    most = max(row["triangles"] for row in rows)
    return most, [row for row in rows if row["triangles"] == most]


def values(study):
    most, rows = largest(study)
    if any(row["wrong"] for row in rows if row["library"] == "Scene"):
        raise ValueError("Scene is wrong")
    yield "triangles", count(most)


def tables(study):
    most, rows = largest(study)
    memory = {row["library"]: row["bytes_a_triangle"] for row in
              study.rows("builds.csv", triangles=natural, library=str, bytes_a_triangle=finite) if row["triangles"] == most}
    lines = []
    for library, size in memory.items():
        here = {(row["balls"], row["question"]): row for row in rows if row["library"] == library}
        time = lambda *key: f"{here[key]['nanoseconds'] / 1000:.2g}" if key in here else ""
        touching = here.get(("touching", "any"))
        lines.append([escaped(library), time("near", "any"), time("near", "all"), time("near", "nearest"),
                      time("anywhere", "any"), f"{size:.0f}",
                      f"{count(touching['wrong'])} of {count(touching['checked'])}" if touching else ""])
    head = ["", "any", "all", "nearest", "any, anywhere", "bytes", "wrong, just touching"]
    yield "scenes", table("lrrrrrr", head, lines)
