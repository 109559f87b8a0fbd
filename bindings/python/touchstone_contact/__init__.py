# SPDX-License-Identifier: Apache-2.0
"""Does a ball touch a planar polygon, possibly non-convex and with holes, where, and how sure is the answer?

    import touchstone_contact as touchstone
    square = touchstone.Polygon([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    touchstone.filtered.answer([0.5, 0.25, 1, 1], square).relation    # 'touching'
    touchstone.filtered.contact([[0.5, 0.25, 1, 1], [0.5, 0.25, 2, 1]], square)    # array([True, False])

A ball is a row x, y, z, r; many balls are an array of n x 4, which is not copied where it is of doubles and C-contiguous.
A tuple of centres, n x 3, and one or n radii stands for balls, too. A row of seven numbers, x, y, z, r, x', y', z', is a
ball whose centre moves along a segment.
One question is answered by a word, a number or an object; a batch by arrays: one, or a named tuple of them whose fields have
the names of that object's attributes. Words stand there as the codes of Relation, PlaneSide, PointLocation, FeatureKind and
FirstContactKind, and -1 and NaN for no answer. `out=` takes what the same question returned before, and writes there.
Coordinates are doubles taken as exact real numbers. The paths ask the same questions: `filtered` is exact at about the
price of `fast`; `exact` states the truth by an exact kernel; `fast` is plain doubles, and wrong near a boundary. Batches
let other threads go on. What the contract does not accept raises Rejected: a ValueError with a `code` and a sentence.

Many faces: TriangleSet asks about one ball and all triangles of an array; Mesh reads files and takes what trimesh, Open3D,
PyVista and meshio have; merge_faces merges its coplanar faces; Scene holds meshes under poses, and finds the faces that a
ball touches and the nearest one. These are surfaces: a ball inside a mesh touches nothing. Solid is what a closed mesh
bounds.

judge asks a function of the user about certified cases and says where it is wrong.
"""

from enum import IntEnum as _IntEnum
from typing import NamedTuple as _NamedTuple

try:
    import numpy as _numpy  # noqa: F401
except ImportError as _error:
    raise ImportError("touchstone needs NumPy: install python3-numpy, or numpy by pip") from _error

from ._touchstone import (Answer, BrokenMesh, FirstContact, FirstFace, Mesh, NearestFace, Polygon, Rejected, Scene, Solid, TriangleSet, __version__,
                          exact, fast, filtered, merge_faces)

for _kind in (Answer, BrokenMesh, FirstContact, FirstFace, Mesh, NearestFace, Polygon, Rejected, Scene, Solid, TriangleSet):
    _kind.__module__ = __name__  # where users find them


class _Code:
    """What the codes in arrays of int8 mean; each name is a word of the contract."""

    @classmethod
    def words(cls, codes):
        """Returns the word of each code, in an array of the same shape; '' for -1, where there is no answer."""
        codes = _numpy.asarray(codes)
        if codes.size and not (-1 <= codes.min() and codes.max() < len(cls)):
            raise ValueError(f"{cls.__name__} has no code {codes.min() if codes.min() < -1 else codes.max()}")
        return _numpy.array([*cls.__members__, ""])[codes]


class Relation(_Code, _IntEnum):
    """The distance against the radius."""

    separate = 0
    touching = 1
    overlapping = 2


class PlaneSide(_Code, _IntEnum):
    """The side of the plane on which a ball lies."""

    in_front = 0
    behind = 1
    intersects = 2


class PointLocation(_Code, _IntEnum):
    """Where a point of the plane lies with respect to the polygon, and a point of space with respect to a solid."""

    inside = 0
    boundary = 1
    outside = 2


class FeatureKind(_Code, _IntEnum):
    """What contains the closest point: the interior of the face or of an edge, or a vertex."""

    face = 0
    edge = 1
    vertex = 2


class FirstContactKind(_Code, _IntEnum):
    """When a moving ball first touches: at the start, on the way or not at all."""

    start = 0
    way = 1
    none = 2


class Hits(_NamedTuple):
    """Edges or triangles that n balls hit: number[indptr[i]:indptr[i + 1]] are those of ball i, ascending."""

    indptr: object  # int64 (n + 1,)
    number: object  # int64 (k,)


class Answers(_NamedTuple):
    """The fields of Answer for n balls."""

    plane: object  # int8 (n,), PlaneSide
    plane_tangent: object  # bool (n,)
    foot: object  # int8 (n,), PointLocation
    relation: object  # int8 (n,), Relation
    nearest: object  # int8 (n,), FeatureKind
    nearest_index: object  # int64 (n,): the number of the edge or vertex; 0 for the face
    point: object  # float64 (n, 3)
    distance: object  # float64 (n,)
    contact_normal: object  # float64 (n, 3)
    depth: object  # float64 (n,)
    off_plane: object  # float64 (n,)
    edges_hit: object  # Hits

    @property
    def contact(self):
        """Whether each ball touches: bool (n,)."""
        return self.relation != Relation.separate


class ClosestPoints(_NamedTuple):
    """The point of a polygon that is closest to each of n centres."""

    point: object  # float64 (n, 3)
    distance: object  # float64 (n,)


class FirstContacts(_NamedTuple):
    """The fields of FirstContact for n motions. Without a contact, time is infinite, and the fields after it -1 and NaN."""

    kind: object  # int8 (n,), FirstContactKind
    time: object  # float64 (n,)
    momentary: object  # bool (n,)
    feature: object  # int8 (n,), FeatureKind
    feature_index: object  # int64 (n,)
    point: object  # float64 (n, 3)
    contact_normal: object  # float64 (n, 3)
    depth: object  # float64 (n,)

    @property
    def contact(self):
        """Whether each ball touches at any time: bool (n,)."""
        return self.kind != FirstContactKind.none


class FirstFaces(_NamedTuple):
    """The face of a scene that each of n moving balls touches first, -1 if none, and the fields of FirstContacts."""

    object: object  # int64 (n,)
    face: object  # int64 (n,)
    kind: object
    time: object
    momentary: object
    feature: object
    feature_index: object
    point: object
    contact_normal: object
    depth: object

    contact = FirstContacts.contact


class FacesInOrder(_NamedTuple):
    """All faces that n moving balls touch: from indptr[i] up to indptr[i + 1] stand those of motion i, by first times."""

    indptr: object  # int64 (n + 1,)
    object: object  # int64 (k,)
    face: object  # int64 (k,)
    kind: object  # and so on as in FirstContacts
    time: object
    momentary: object
    feature: object
    feature_index: object
    point: object
    contact_normal: object
    depth: object


class TouchedFaces(_NamedTuple):
    """The faces that n balls touch: object and face[indptr[i]:indptr[i + 1]] are those of ball i, ascending."""

    indptr: object  # int64 (n + 1,)
    object: object  # int64 (k,)
    face: object  # int64 (k,)


class NearestFaces(_NamedTuple):
    """The fields of NearestFace for n balls; -1 and NaN in a scene without faces."""

    object: object  # int64 (n,)
    face: object  # int64 (n,)
    feature: object  # int8 (n,), FeatureKind
    feature_index: object  # int64 (n,)
    point: object  # float64 (n, 3)
    distance: object  # float64 (n,)
    contact_normal: object  # float64 (n, 3)
    depth: object  # float64 (n,)


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


from .judging import judge  # noqa: E402  needs the names above

__all__ = ["Answer", "Answers", "BrokenMesh", "ClosestPoints", "FacesInOrder", "FeatureKind", "FirstContact", "FirstContactKind",
           "FirstContacts", "FirstFace", "FirstFaces", "Hits", "MergedMesh", "Mesh", "NearestFace", "NearestFaces", "PlaneSide",
           "PointLocation", "Polygon", "Rejected", "Relation", "Scene", "Solid", "TouchedFaces", "TriangleSet", "__version__",
           "exact", "fast", "filtered", "judge", "merge_faces"]
