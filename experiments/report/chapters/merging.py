# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone merging`: a mesh's coplanar faces as polygons."""
import math

from noise import is_steady
from page import count, counted, escaped, multiple, percent, rounded, table, upper_limit, words
from results import finite, natural

TITLE = "Coplanar faces merged into polygons"
SCENES = ("merged", "mixed")


def rows_of(study):
    return study.rows("merge.csv", mesh=str, faces=natural, rejected=natural, polygons=natural, holes=natural, any_asked=natural,
                      any_differ=natural, all_asked=natural, all_differ=natural, nearest_asked=natural, nearest_differ=natural)


def asked(study):
    return {}


def finding(study):
    rows = rows_of(study)
    faces, polygons = sum(row["faces"] for row in rows), sum(row["polygons"] for row in rows)
    differ, balls = (sum(row[f"{question}_{what}"] for row in rows for question in ("any", "all", "nearest")) for what in ("differ", "asked"))
    text = f"{count(faces)} faces of {counted(len(rows), 'meshes', 'mesh')} become {count(polygons)} polygons, {rounded(faces / polygons)} faces each."
    if balls:
        text += f" Scenes of either were asked {count(balls)} times, and " + (
            f"differed {count(differ)} times." if differ else f"never differed (&lt; {percent(upper_limit(balls))}).")
    return text


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


def chapter(study):
    by_mesh = ratios(study)
    text = "<p>A mesh's exactly coplanar triangles can be merged into polygons with holes: fewer faces, but each costs more to ask.</p>"
    means = {scene: mean([own[scene] for own in by_mesh.values() if scene in own]) for scene in SCENES
             if any(scene in own for own in by_mesh.values())}
    follows = (f" <b>What follows:</b> on average (geometric) "
               f"{words(f'{scene} {multiple(ratio)}' for scene, ratio in means.items())}: asking is "
               f"{'no quicker for merging' if min(means.values()) >= 1 else 'quicker where few faces are merged into one' if means.get('merged', 0) >= 1 else 'quicker'}."
               if means else "")
    return text + table(
        "Meshes; the last columns: time of “touches any?” as a multiple of that of the mesh's own faces (below 1 is a gain). "
        f"merged: a scene of all polygons; mixed: polygons only where one stands for many faces.{follows}", ["mesh", "faces", "polygons", "holes", *SCENES],
        [[escaped(row["mesh"]), count(row["faces"]), count(row["polygons"]), count(row["holes"]),
          *(multiple(by_mesh[row['mesh']][scene]) if scene in by_mesh.get(row["mesh"], {}) else "not timed, or too noisy to tell" for scene in SCENES)]
         for row in rows_of(study)], range(1, 6))
