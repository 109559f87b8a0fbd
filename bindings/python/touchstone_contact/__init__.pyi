# SPDX-License-Identifier: Apache-2.0
from enum import IntEnum
from os import PathLike
from typing import Any, Literal, NamedTuple, Protocol, Sequence, TypedDict, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .judging import judge as judge

__version__: str

_PlaneSide = Literal["in_front", "behind", "intersects"]
_PointLocation = Literal["inside", "boundary", "outside"]
_Relation = Literal["separate", "touching", "overlapping"]
_Bools = NDArray[np.bool_]
_Codes = NDArray[np.int8]
_Numbers = NDArray[np.int64]
_Doubles = NDArray[np.float64]

class _Code:
    @classmethod
    def words(cls, codes: ArrayLike) -> NDArray[np.str_]: ...

class Relation(_Code, IntEnum):
    separate = 0
    touching = 1
    overlapping = 2

class PlaneSide(_Code, IntEnum):
    in_front = 0
    behind = 1
    intersects = 2

class PointLocation(_Code, IntEnum):
    inside = 0
    boundary = 1
    outside = 2

class FeatureKind(_Code, IntEnum):
    face = 0
    edge = 1
    vertex = 2

class FirstContactKind(_Code, IntEnum):
    start = 0
    way = 1
    none = 2

class Rejected(ValueError):
    code: str

class _HasKind(TypedDict):
    kind: Literal["face", "edge", "vertex"]

class Feature(_HasKind, total=False):
    index: int

class Answer:
    @property
    def plane(self) -> _PlaneSide: ...
    @property
    def plane_tangent(self) -> bool: ...
    @property
    def foot(self) -> _PointLocation: ...
    @property
    def edges_hit(self) -> list[int]: ...
    @property
    def relation(self) -> _Relation: ...
    @property
    def contact(self) -> bool: ...
    @property
    def nearest(self) -> Feature: ...
    @property
    def point(self) -> NDArray[np.float64]: ...
    @property
    def distance(self) -> float: ...
    @property
    def contact_normal(self) -> NDArray[np.float64]: ...
    @property
    def depth(self) -> float: ...
    @property
    def off_plane(self) -> float: ...
    def verdict(self) -> dict[str, object]: ...

class FirstContact:
    @property
    def kind(self) -> Literal["start", "way", "none"]: ...
    @property
    def contact(self) -> bool: ...
    @property
    def time(self) -> float: ...
    @property
    def momentary(self) -> bool: ...
    @property
    def feature(self) -> Feature: ...
    @property
    def point(self) -> NDArray[np.float64]: ...
    @property
    def contact_normal(self) -> NDArray[np.float64]: ...
    @property
    def depth(self) -> float: ...

class Hits(NamedTuple):
    indptr: _Numbers
    number: _Numbers

class Answers(NamedTuple):
    plane: _Codes
    plane_tangent: _Bools
    foot: _Codes
    relation: _Codes
    nearest: _Codes
    nearest_index: _Numbers
    point: _Doubles
    distance: _Doubles
    contact_normal: _Doubles
    depth: _Doubles
    off_plane: _Doubles
    edges_hit: Hits
    @property
    def contact(self) -> _Bools: ...

class ClosestPoints(NamedTuple):
    point: _Doubles
    distance: _Doubles

class FirstContacts(NamedTuple):
    kind: _Codes
    time: _Doubles
    momentary: _Bools
    feature: _Codes
    feature_index: _Numbers
    point: _Doubles
    contact_normal: _Doubles
    depth: _Doubles
    @property
    def contact(self) -> _Bools: ...

class FirstFaces(NamedTuple):
    object: _Numbers
    face: _Numbers
    kind: _Codes
    time: _Doubles
    momentary: _Bools
    feature: _Codes
    feature_index: _Numbers
    point: _Doubles
    contact_normal: _Doubles
    depth: _Doubles
    @property
    def contact(self) -> _Bools: ...

class FacesInOrder(NamedTuple):
    indptr: _Numbers
    object: _Numbers
    face: _Numbers
    kind: _Codes
    time: _Doubles
    momentary: _Bools
    feature: _Codes
    feature_index: _Numbers
    point: _Doubles
    contact_normal: _Doubles
    depth: _Doubles

class TouchedFaces(NamedTuple):
    indptr: _Numbers
    object: _Numbers
    face: _Numbers

class NearestFaces(NamedTuple):
    object: _Numbers
    face: _Numbers
    feature: _Codes
    feature_index: _Numbers
    point: _Doubles
    distance: _Doubles
    contact_normal: _Doubles
    depth: _Doubles

class FirstFace:
    @property
    def object(self) -> int: ...
    @property
    def face(self) -> int: ...
    @property
    def contact(self) -> FirstContact: ...

class _HasGeometry(Protocol):
    @property
    def __geo_interface__(self) -> dict[str, Any]: ...

class Polygon:
    def __init__(self, outer: ArrayLike, holes: Sequence[ArrayLike] = ..., closed: bool = ...) -> None: ...
    @staticmethod
    def of(object: Polygon | _HasGeometry | dict[str, Any] | str) -> Polygon: ...
    @property
    def outer(self) -> NDArray[np.float64]: ...
    @property
    def holes(self) -> list[NDArray[np.float64]]: ...

class _HasFaces(Protocol):
    @property
    def vertices(self) -> ArrayLike: ...
    @property
    def faces(self) -> ArrayLike: ...

class _HasTriangles(Protocol):  # Open3D
    @property
    def vertices(self) -> Any: ...
    @property
    def triangles(self) -> Any: ...

class _HasPoints(Protocol):  # PyVista
    @property
    def points(self) -> Any: ...
    @property
    def faces(self) -> Any: ...

class _HasCells(Protocol):  # meshio
    @property
    def points(self) -> Any: ...
    @property
    def cells(self) -> Any: ...

_MeshLike = _HasFaces | _HasTriangles | _HasPoints | _HasCells

class _Readable(Protocol):
    def read(self) -> bytes | str: ...

class LeftOut(TypedDict):
    face: int
    code: str
    message: str

class SegmentFace(TypedDict):
    face: int
    corners: list[int]

_BadFaces = Literal["refuse", "leave out"]
# Balls (4,) or (n, 4), or centres (3,) or (n, 3) and one or n radii.
_Balls = ArrayLike | tuple[ArrayLike, ArrayLike]

class BrokenMesh(ValueError): ...

class Mesh:
    def __init__(self, vertices: ArrayLike, faces: ArrayLike | Sequence[Sequence[int]]) -> None: ...
    @staticmethod
    def read(
        path: str | PathLike[str] | bytes | _Readable, format: str | None = ..., bad_faces: _BadFaces = ...
    ) -> Mesh: ...
    @staticmethod
    def of(object: Mesh | _MeshLike) -> Mesh: ...
    @property
    def places(self) -> list[str]: ...
    @property
    def left_out(self) -> list[str]: ...
    @property
    def vertices(self) -> NDArray[np.float64]: ...
    @property
    def faces(self) -> NDArray[np.int64] | list[list[int]]: ...
    def __len__(self) -> int: ...

class MergedMesh(NamedTuple):
    polygons: list[Polygon]
    faces: list[NDArray[np.int64]]
    off_plane: NDArray[np.float64]
    left_out: list[LeftOut]

def merge_faces(mesh: Mesh | _MeshLike, tolerance: float = ..., bad_faces: _BadFaces = ...) -> MergedMesh: ...

class TriangleSet:
    """A single ball (4,) has one answer; many balls (n, 4) have n."""

    def __init__(self, triangles: ArrayLike, bad_faces: Literal["refuse", "as segments"] = ...) -> None: ...
    @property
    def triangles(self) -> NDArray[np.float64]: ...
    def contact(self, balls: _Balls, out: _Bools | None = ...) -> _Bools: ...
    def any_contact(self, balls: _Balls, out: _Bools | None = ...) -> bool | _Bools: ...
    def triangles_hit(self, balls: _Balls) -> NDArray[np.int64] | Hits: ...
    def __len__(self) -> int: ...

class NearestFace:
    @property
    def object(self) -> int: ...
    @property
    def face(self) -> int: ...
    @property
    def feature(self) -> Feature: ...
    @property
    def point(self) -> NDArray[np.float64]: ...
    @property
    def distance(self) -> float: ...
    @property
    def contact_normal(self) -> NDArray[np.float64]: ...
    @property
    def depth(self) -> float: ...

_Object = int | str
_Faces = Mesh | _MeshLike | MergedMesh | TriangleSet | Polygon | Sequence[Polygon] | ArrayLike

class Scene:
    """A single ball (4,) has one answer; many balls (n, 4) have n."""

    def __init__(self) -> None: ...
    @property
    def names(self) -> list[str]: ...
    def add(
        self,
        name: str,
        faces: _Faces,
        pose: ArrayLike | None = ...,
        bad_faces: _BadFaces | Literal["as segments", "as segments or leave out"] = ...,
    ) -> int: ...
    def face_numbers(self, object: _Object) -> NDArray[np.int64]: ...
    def left_out(self, object: _Object) -> list[LeftOut]: ...
    def segments(self, object: _Object) -> list[SegmentFace]: ...
    def set_pose(self, object: _Object, pose: ArrayLike | None) -> None: ...
    def pose(self, object: _Object) -> NDArray[np.float64]: ...
    def remove(self, object: _Object) -> None: ...
    @property
    def numbers(self) -> list[int]: ...
    def face_count(self, object: _Object) -> int: ...
    def touches(
        self, balls: _Balls, objects: Sequence[_Object] | None = ..., out: _Bools | None = ...
    ) -> bool | _Bools: ...
    def touched(
        self, balls: _Balls, objects: Sequence[_Object] | None = ...
    ) -> NDArray[np.int64] | TouchedFaces: ...
    def touched_in_order(
        self, motions: ArrayLike, objects: Sequence[_Object] | None = ...
    ) -> list[FirstFace] | FacesInOrder: ...
    def first_contact(
        self, motions: ArrayLike, objects: Sequence[_Object] | None = ..., out: FirstFaces | None = ...
    ) -> FirstFace | None | FirstFaces: ...
    def nearest(
        self, balls: _Balls, objects: Sequence[_Object] | None = ..., out: NearestFaces | None = ...
    ) -> NearestFace | None | NearestFaces: ...
    def __len__(self) -> int: ...

class Solid:
    """A single point (3,) or ball (4,) has one answer; many (n, 3) or (n, 4) have n."""

    @overload
    def __init__(self, mesh: Mesh | _MeshLike) -> None: ...
    @overload
    def __init__(self, vertices: ArrayLike, faces: ArrayLike | Sequence[Sequence[int]]) -> None: ...
    def locate(self, points: ArrayLike, out: _Codes | None = ...) -> _PointLocation | _Codes: ...
    def touches(self, balls: _Balls, out: _Bools | None = ...) -> bool | _Bools: ...
    def signed_distance(self, points: ArrayLike, out: _Doubles | None = ...) -> float | _Doubles: ...

class _Path:
    """The questions of one path. A single ball (4,) has one answer; many balls (n, 4) have n."""

    @staticmethod
    def contact(balls: _Balls, polygon: Polygon, out: _Bools | None = ...) -> bool | _Bools: ...
    @staticmethod
    def first_contact(
        motions: ArrayLike, polygon: Polygon, out: FirstContacts | None = ...
    ) -> FirstContact | FirstContacts: ...
    @staticmethod
    def relation(balls: _Balls, polygon: Polygon, out: _Codes | None = ...) -> _Relation | _Codes: ...
    @staticmethod
    def plane_side(balls: _Balls, polygon: Polygon, out: _Codes | None = ...) -> _PlaneSide | _Codes: ...
    @staticmethod
    def foot(balls: _Balls, polygon: Polygon, out: _Codes | None = ...) -> _PointLocation | _Codes: ...
    @staticmethod
    def edges_hit(balls: _Balls, polygon: Polygon) -> NDArray[np.int64] | Hits: ...
    @staticmethod
    def closest(
        balls: _Balls, polygon: Polygon, out: ClosestPoints | None = ...
    ) -> tuple[_Doubles, float] | ClosestPoints: ...
    @staticmethod
    def answer(balls: _Balls, polygon: Polygon) -> Answer | Answers: ...

filtered: _Path
exact: _Path
fast: _Path
