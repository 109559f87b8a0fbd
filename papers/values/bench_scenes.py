# SPDX-License-Identifier: GPL-3.0-or-later
"""Queries against the largest scene."""
from studies.bench_scenes import OURS, Data, are_steady
from values.latex import count, decimal, escaped, table

PREFIX = "scenes"  # of the keys of \val


def largest(data):
    """The scene of most triangles, the first of equals, and how many it has."""
    scene = max(data.scenes, key=data.largest)
    return scene, data.largest(scene)


def values(study):
    data = Data(study)
    if data.wrong(OURS)[0]:
        raise ValueError(f"{OURS} is wrong")
    scene, triangles = largest(data)
    yield "triangles", count(triangles)
    found = {row["library"]: row for row in data.motions if (row["scene"], row["triangles"], row["motions"]) == (scene, triangles, "short")}
    for key, library in (("at-rest", f"{OURS}, at the start"), ("fcl", "FCL BVHModel"), ("bullet", "Bullet")):
        if library in found:
            base, other = (found[library], found[OURS]) if key == "at-rest" else (found[OURS], found[library])
            yield f"moving/{key}", decimal(other["nanoseconds"] / base["nanoseconds"]) if are_steady(base, other) else None


def tables(study):
    data = Data(study)
    scene, triangles = largest(data)
    of_scene = lambda rows: [row for row in rows if (row["scene"], row["triangles"]) == (scene, triangles)]
    memory = {row["library"]: row["bytes_a_triangle"] for row in of_scene(data.builds)}
    rows = of_scene(data.queries)
    lines = []
    for library, size in memory.items():
        here = {(row["balls"], row["question"]): row for row in rows if row["library"] == library}
        time = lambda *key: "" if key not in here else decimal(here[key]["nanoseconds"] / 1000) if are_steady(here[key]) else "too noisy"
        touching = here.get(("touching", "any"))
        lines.append([escaped(library), time("near", "any"), time("near", "all"), time("near", "nearest"),
                      time("anywhere", "any"), f"{size:.0f}",
                      f"{count(touching['wrong'])} of {count(touching['checked'])}" if touching else ""])
    head = ["", "any", "all", "nearest", "any, anywhere", "bytes", "wrong, just touching"]
    yield "scenes", table("lrrrrrr", head, lines)
