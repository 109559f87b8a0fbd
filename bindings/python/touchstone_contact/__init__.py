# SPDX-License-Identifier: Apache-2.0
"""Does a ball touch a planar polygon, possibly non-convex and with holes, where, and how sure is the answer?

    import touchstone_contact as touchstone
    square = touchstone.Polygon([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    touchstone.filtered.answer([0.5, 0.25, 1, 1], square).relation    # 'touching'
    touchstone.filtered.contact([[0.5, 0.25, 1, 1], [0.5, 0.25, 2, 1]], square)    # array([True, False])

A ball is a row x, y, z, r; many balls are an array of n x 4, which is not copied where it is of doubles and C-contiguous.
A tuple of centres, n x 3, and one or n radii stands for balls, too. A row of seven numbers, x, y, z, r, x', y', z', is a
ball whose centre moves along a segment.
Coordinates are doubles taken as exact real numbers. The paths ask the same questions: `filtered` is exact at about the
price of `fast`; `exact` states the truth by an exact kernel; `fast` is plain doubles, and wrong near a boundary. Batches
let other threads go on. What the contract does not accept raises Rejected: a ValueError with a `code` and a sentence.

Many faces: TriangleSet asks about one ball and all triangles of an array; Mesh reads files and takes what trimesh, Open3D,
PyVista and meshio have; merge_faces merges its coplanar faces; Scene holds meshes under poses, and finds the faces that a
ball touches and the nearest one. These are surfaces: a ball inside a mesh touches nothing. Solid is what a closed mesh
bounds.
"""

from typing import NamedTuple as _NamedTuple

try:
    import numpy as _numpy  # noqa: F401
except ImportError as _error:
    raise ImportError("touchstone needs NumPy: install python3-numpy, or numpy by pip") from _error

from ._touchstone import (Answer, BrokenMesh, FirstContact, FirstFace, Mesh, NearestFace, Polygon, Rejected, Scene, Solid, TriangleSet, __version__,
                          exact, fast, filtered, merge_faces)

for _kind in (Answer, BrokenMesh, FirstContact, FirstFace, Mesh, NearestFace, Polygon, Rejected, Scene, Solid, TriangleSet):
    _kind.__module__ = __name__  # where users find them


class MergedMesh(_NamedTuple):
    """The result of merge_faces: polygons, ordered by the lowest face of each, and what each was merged from."""

    polygons: list
    faces: list  # for each polygon, the numbers of its faces in the mesh
    off_plane: object  # for each polygon, the largest displacement of a vertex of its faces onto its plane
    left_out: list  # the faces that the contract rejects, as Scene.left_out has them


def _remade(kind, base, arguments):
    """Makes an object of a class, or of a subclass of it, whose __init__ is not called: for `pickle` and `copy`."""
    made = base.__new__(kind)
    base.__init__(made, *arguments)
    return made


__all__ = ["Answer", "BrokenMesh", "FirstContact", "FirstFace", "MergedMesh", "Mesh", "NearestFace", "Polygon", "Rejected", "Scene", "Solid",
           "TriangleSet", "__version__", "exact", "fast", "filtered", "merge_faces"]
