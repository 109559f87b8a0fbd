# SPDX-License-Identifier: Apache-2.0
from typing import Literal, Sequence, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

PlaneSide = Literal["in_front", "behind", "intersects"]
PointLocation = Literal["inside", "boundary", "outside"]
Relation = Literal["separate", "touching", "overlapping"]

class Rejected(ValueError):
    code: str

class _FeatureKind(TypedDict):
    kind: Literal["face", "edge", "vertex"]

class Feature(_FeatureKind, total=False):
    index: int

class Answer:
    @property
    def plane(self) -> PlaneSide: ...
    @property
    def plane_tangent(self) -> bool: ...
    @property
    def foot(self) -> PointLocation: ...
    @property
    def edges_hit(self) -> list[int]: ...
    @property
    def relation(self) -> Relation: ...
    @property
    def contact(self) -> bool: ...
    @property
    def nearest(self) -> Feature: ...
    @property
    def point(self) -> NDArray[np.float64]: ...
    @property
    def distance(self) -> float: ...
    @property
    def off_plane(self) -> float: ...
    def verdict(self) -> dict[str, object]: ...

class Polygon:
    def __init__(self, outer: ArrayLike, holes: Sequence[ArrayLike] = ...) -> None: ...
    @property
    def outer(self) -> NDArray[np.float64]: ...
    @property
    def holes(self) -> list[NDArray[np.float64]]: ...

class _Path:
    """The questions of one path. A single ball (4,) has one answer; many balls (n, 4) have n."""

    @staticmethod
    def contact(balls: ArrayLike, polygon: Polygon) -> bool | NDArray[np.bool_]: ...
    @staticmethod
    def relation(balls: ArrayLike, polygon: Polygon) -> Relation | NDArray[np.str_]: ...
    @staticmethod
    def plane_side(balls: ArrayLike, polygon: Polygon) -> PlaneSide | NDArray[np.str_]: ...
    @staticmethod
    def foot(balls: ArrayLike, polygon: Polygon) -> PointLocation | NDArray[np.str_]: ...
    @staticmethod
    def edges_hit(balls: ArrayLike, polygon: Polygon) -> NDArray[np.uint64] | list[NDArray[np.uint64]]: ...
    @staticmethod
    def closest(balls: ArrayLike, polygon: Polygon) -> tuple[NDArray[np.float64], float | NDArray[np.float64]]: ...
    @staticmethod
    def answer(balls: ArrayLike, polygon: Polygon) -> Answer | list[Answer]: ...

filtered: _Path
exact: _Path
fast: _Path
