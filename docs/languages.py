# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: languages.py ROOT [--write]

The table of bindings/README.md: which question each language has, by the name that its header or its stubs declare. A name
that is not declared, and a question of C that the table does not have, are faults. Compares the table with the page (exit
status 1 if it differs), or writes it."""

import pathlib
import re
import sys

PAGE = "bindings/README.md"
# For each language where its names are declared, and how; `{}` is the name.
DECLARED = {
    "C++": (("robust/filtered/*.h", "robust/scene/*.h", "robust/mesh/*.h", "geometry/io/*.h"), r"\b{}\("),
    "Python": (("bindings/python/touchstone_contact/__init__.pyi",), r"\bdef {}\("),
    "C": (("bindings/c/touchstone.h",), r"\b{}\("),
    "CGAL": (("bindings/cgal/cgal.h",), r"\b{}\("),
}
# Each row: the question, and its names in these languages; "in NAME" if another question has its answer, and an empty one
# if the language does not have it.
ROWS = [
    ("does a ball touch a polygon", "filtered::contact", "filtered.contact", "touchstone_polygon_contact", "contact"),
    ("distance against radius", "filtered::relation", "filtered.relation", "in touchstone_polygon_answer", "relation"),
    ("the whole answer", "filtered::answer", "filtered.answer", "touchstone_polygon_answer", ""),
    ("closest point of a polygon", "in filtered::answer", "filtered.closest", "in touchstone_polygon_answer", ""),
    ("squared distance, exact", "", "", "", "squared_distance"),
    ("edges that a ball touches", "filtered::edges_hit", "filtered.edges_hit", "touchstone_polygon_edges_hit", ""),
    ("first contact of a moving ball with a polygon", "filtered::first_contact", "filtered.first_contact",
     "touchstone_polygon_first_contact", ""),
    ("triangles that a ball touches", "TriangleSet::triangles_hit", "TriangleSet.triangles_hit", "touchstone_triangles_contact", ""),
    ("closest points of triangles", "filtered::closest", "", "touchstone_triangles_closest", ""),
    ("first contact with triangles", "filtered::first_contact", "", "touchstone_triangles_first_contact", ""),
    ("objects under poses", "Scene::add", "Scene.add", "touchstone_scene_add", "add"),
    ("does a ball touch a scene", "Scene::touches", "Scene.touches", "touchstone_scene_touches", "touches"),
    ("faces that a ball touches", "Scene::touched", "Scene.touched", "touchstone_scene_touched", "touched"),
    ("the nearest face", "Scene::nearest", "Scene.nearest", "touchstone_scene_nearest", ""),
    ("the face that a moving ball touches first", "Scene::first_contact", "Scene.first_contact",
     "touchstone_scene_first_contact", ""),
    ("all faces on the way, in order", "Scene::touched_in_order", "Scene.touched_in_order", "", ""),
    ("does a ball touch a solid", "Solid::touches", "Solid.touches", "touchstone_solid_touches", ""),
    ("where a point lies", "Solid::locate", "Solid.locate", "touchstone_solid_locate", ""),
    ("signed distance", "Solid::signed_distance", "Solid.signed_distance", "touchstone_solid_signed_distance", ""),
    ("coplanar faces merged", "merge_faces", "merge_faces", "", ""),
    ("files of meshes", "read_mesh", "Mesh.read", "", ""),
    ("judging a function by certified cases", "", "judge", "", ""),
]
# Functions of C that ask nothing.
SERVES = r"_(create|free|complete|faces|offsets|remove|set_pose|name|version)$"


def main(root, write):
    texts = {language: "\n".join(file.read_text() for pattern in patterns for file in sorted(root.glob(pattern)))
             for language, (patterns, _) in DECLARED.items()}
    faults = []
    for question, *names in ROWS:
        for (language, (_, form)), name in zip(DECLARED.items(), names):
            last = re.split(r"::|\.| ", name)[-1]
            imported = re.search(rf"import {last} as {last}$", texts[language], re.MULTILINE)
            if name and not imported and not re.search(form.format(re.escape(last)), texts[language]):
                faults.append(f"{question}: {language} declares no {name}")
    in_c = {name for name in re.findall(r"\b(touchstone_\w+)\(", texts["C"]) if not re.search(SERVES, name)}
    faults += [f"{name} is not in the table" for name in sorted(in_c - {row[3] for row in ROWS})]
    cells = [["question", *DECLARED], ["---"] * (1 + len(DECLARED))]
    cells += [[question, *(re.sub(r"\S+$", r"`\g<0>`", name) for name in names)] for question, *names in ROWS]
    table = "\n".join(f"| {' | '.join(row)} |".replace("|  |", "| |").replace("|  |", "| |") for row in cells)
    page = root / PAGE
    text = re.sub(r"^\| question .*?(?=^$)", lambda _: table + "\n", page.read_text(), flags=re.MULTILINE | re.DOTALL)
    if write:
        page.write_text(text)
    elif text != page.read_text():
        faults.append(f"{PAGE} differs: run docs/languages.py . --write")
    print("\n".join([*faults, f"{len(ROWS)} questions, {len(faults)} faults"]))
    return bool(faults)


sys.exit(main(pathlib.Path(sys.argv[1]), "--write" in sys.argv[2:]))
