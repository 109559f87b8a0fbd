# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone merge`: a mesh's coplanar faces as polygons."""
from page import count, escaped, percent, rounded, table, upper_limit
from results import finite, natural

TITLE = "Coplanar faces merged into polygons"


def rows_of(study):
    return study.rows("merge.csv", mesh=str, faces=natural, rejected=natural, polygons=natural, holes=natural, any_asked=natural,
                      any_differ=natural, all_asked=natural, all_differ=natural, nearest_asked=natural, nearest_differ=natural)


def asked(study):
    return {}


def verdict(study):
    return []


def chapter(study):
    rows = rows_of(study)
    faces, polygons = sum(row["faces"] for row in rows), sum(row["polygons"] for row in rows)
    differ = sum(row[f"{q}_differ"] for row in rows for q in ("any", "all", "nearest"))
    balls = sum(row[f"{q}_asked"] for row in rows for q in ("any", "all", "nearest"))
    times = study.rows("merge-times.csv", mesh=str, scene=str, any_ns=finite)
    by_mesh = {}
    for row in times:
        by_mesh.setdefault(row["mesh"], {})[row["scene"]] = row["any_ns"]
    answers = ("" if not balls else f" Scenes of either were asked {count(balls)} times, and "
               + (f"differed {count(differ)} times." if differ else f"never differed (< {percent(upper_limit(balls))})."))
    return f"""<p>A mesh's exactly coplanar triangles can be merged into polygons with holes: {count(faces)} faces of {len(rows)} meshes become
{count(polygons)} polygons, {rounded(faces / polygons)} faces each.{answers}</p>""" + table(
        "Meshes; the last columns: time of “touches any?” as a multiple of that of the mesh's own faces (below 1 is a gain). mixed: only polygons "
        "that stand for many faces.", ["mesh", "faces", "polygons", "holes", "merged", "mixed"],
        [[escaped(row["mesh"]), count(row["faces"]), count(row["polygons"]), count(row["holes"]),
          *(f"{rounded(by_mesh[row['mesh']][scene] / by_mesh[row['mesh']]['faces'])} ×" if scene in by_mesh.get(row["mesh"], {}) else "not timed"
            for scene in ("merged", "mixed"))] for row in rows], range(1, 6))
