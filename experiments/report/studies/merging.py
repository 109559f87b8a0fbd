# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone merging`: a mesh's coplanar faces as polygons."""
import math

from noise import is_steady
from page import count, escaped, multiple
from results import finite, natural
from studies import MESHES, OUTPUT, Run

RUN = Run(14, "coplanar faces as polygons", resumes=True, full=[["merging", MESHES, "--skip-bad", "--output", OUTPUT]],
          tiny=["merging", MESHES, "--compare", "10", "--repetitions", "1"])
TITLE = "Coplanar faces merged into polygons"
SCENES = ("merged", "mixed")


def ratios(study):
    """By mesh and scene: the time of "touches any?" as a multiple of that of the mesh's own faces; without times that are too noisy to tell."""
    times = {}
    for row in study.rows("merge-times.csv", mesh=str, scene=str, any_ns=finite, any_lower_ns=finite, any_upper_ns=finite):
        if is_steady(row["any_lower_ns"], row["any_upper_ns"]):
            times.setdefault(row["mesh"], {})[row["scene"]] = row["any_ns"]
    return {mesh: {scene: ns / own["faces"] for scene, ns in own.items()} for mesh, own in times.items() if own.get("faces")}


def mean(values):
    """Geometric, as of ratios."""
    return math.exp(sum(map(math.log, values)) / len(values))


def told(study):
    rows = study.rows("merge.csv", mesh=str, faces=natural, rejected=natural, polygons=natural, holes=natural, any_asked=natural,
                      any_differ=natural, all_asked=natural, all_differ=natural, nearest_asked=natural, nearest_differ=natural)
    differ, balls = (sum(row[f"{question}_{what}"] for row in rows for question in ("any", "all", "nearest")) for what in ("differ", "asked"))
    by_mesh = ratios(study)
    means = {scene: mean(own) for scene in SCENES if (own := [times[scene] for times in by_mesh.values() if scene in times])}
    gain = ("" if not means else "no quicker for merging" if min(means.values()) >= 1 else
            "quicker where few faces are merged into one" if means.get("merged", 0) >= 1 else "quicker")
    return {
        "faces": sum(row["faces"] for row in rows), "polygons": sum(row["polygons"] for row in rows), "balls": balls, "differ": differ,
        "means": [f"{scene} {multiple(ratio)}" for scene, ratio in means.items()], "gain": gain,
        "rows": [[escaped(row["mesh"]), count(row["faces"]), count(row["polygons"]), count(row["holes"]),
                  *(multiple(by_mesh[row["mesh"]][scene]) if scene in by_mesh.get(row["mesh"], {}) else "not timed, or too noisy to tell" for scene in SCENES)]
                 for row in rows]}
