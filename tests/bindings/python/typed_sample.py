# SPDX-License-Identifier: GPL-3.0-or-later
"""Uses every class of the module as its annotations say; mypy checks it (test_types.py)."""

import pathlib
import types

import numpy as np
import touchstone_contact as touchstone
from numpy.typing import NDArray


def about_one_face() -> touchstone.Answer | touchstone.Answers:
    square = touchstone.Polygon([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 0]], holes=[], closed=True)
    assert touchstone.Polygon.of("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))") == square
    assert touchstone.Polygon.of({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}) == square
    touches: bool | NDArray[np.bool_] = touchstone.filtered.contact([0.5, 0.25, 1, 1], square)
    assert touches is True
    sides: NDArray[np.int8] = np.empty(3, np.int8)
    touchstone.exact.plane_side(np.zeros((3, 4)), square, out=sides)
    words: NDArray[np.str_] = touchstone.PlaneSide.words(sides)
    assert words[0] == touchstone.PlaneSide.intersects.name
    return touchstone.exact.answer(np.zeros((3, 4)), square)


def about_many_faces(file: pathlib.Path) -> float | None:
    with open(file, "rb") as stream:
        mesh = touchstone.Mesh.read(stream, format="obj", bad_faces="leave out")
    merged: touchstone.MergedMesh = touchstone.merge_faces(mesh, tolerance=0.5)
    scene = touchstone.Scene()
    number: int = scene.add("mesh", mesh, pose=np.eye(4), bad_faces="leave out")
    bad: list[int] = [left_out["face"] for left_out in scene.left_out(number)]
    assert len(scene.face_numbers(number)) + len(bad) == len(mesh.places)
    scene.add("merged", merged)
    scene.add("open3d", types.SimpleNamespace(vertices=mesh.vertices, triangles=mesh.faces))
    ways = scene.touched_in_order(np.zeros((3, 7)))
    if isinstance(ways, touchstone.FacesInOrder):
        ends: NDArray[np.int64] = ways.indptr[1:]
        assert ends[-1] == len(ways.time)
    scene.touches((np.zeros((3, 3)), 0.5))
    scene.add("triangles", np.zeros((0, 3, 3)))
    scene.add("others", types.SimpleNamespace(vertices=mesh.vertices, faces=mesh.faces))
    scene.set_pose("mesh", None)
    nearest = scene.nearest([0, 0, 0, 1], objects=[number, "triangles"])
    if isinstance(nearest, touchstone.NearestFaces):
        scene.nearest(np.zeros((len(nearest.face), 3)), out=nearest)
    if isinstance(nearest, touchstone.NearestFace):
        kind: str = nearest.feature["kind"]
        return nearest.distance if kind == "face" else None
    hit = touchstone.TriangleSet(np.zeros((0, 3, 3))).any_contact([0, 0, 0, 1])
    return float(np.count_nonzero(hit))


def about_a_function(file: pathlib.Path) -> tuple[float, str]:
    def contact(centre: NDArray[np.float32], radius: np.float32, vertices: NDArray[np.float32]) -> bool:
        return bool(np.linalg.norm(vertices - centre, axis=1).min() <= radius)

    judged = touchstone.judge(contact, [file], keys=["contact"], beyond=2**-20, known=file, triangles=True, floats=True, name="mine")
    judged.write_known(file)
    return judged.all.upper, "" if judged else judged.new[0].small.call


def about_a_solid(mesh: touchstone.Mesh) -> float | NDArray[np.float64]:
    solid = touchstone.Solid(mesh)
    if solid.locate([0, 0, 0]) == "inside" and solid.touches(np.zeros((2, 4))) is not False:
        return solid.signed_distance([0, 0, 0])
    return touchstone.Solid(mesh.vertices, mesh.faces).signed_distance(mesh.vertices)
