# SPDX-License-Identifier: Apache-2.0
"""Questions about a ball, and the cases of a file that ask them."""

from __future__ import annotations

import dataclasses
import functools
import json
import pathlib
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

from .. import Mesh, Polygon, Rejected, Scene, filtered

Point = tuple[float, float, float]


@dataclasses.dataclass(frozen=True)
class Question:
    """Does a ball touch a polygon, or a mesh if there are `faces`? `to`: where the centre moves. `pose`: three rows of four."""

    centre: Point
    radius: float
    vertices: tuple[Point, ...]
    holes: tuple[tuple[Point, ...], ...] = ()
    to: Point | None = None
    faces: tuple[tuple[int, ...], ...] | None = None
    pose: tuple[tuple[float, ...], ...] | None = None

    def points(self) -> list[Point]:
        """Returns the centre, where it moves, and all vertices."""
        return [self.centre, *([self.to] if self.to else []), *self.vertices, *(p for hole in self.holes for p in hole)]

    def with_points(self, points: Sequence[Point]) -> Question:
        """Returns the question about other points, in the order of `points`."""
        rest = iter(points)
        return dataclasses.replace(self, centre=next(rest), to=next(rest) if self.to else None,
                                   vertices=tuple(next(rest) for _ in self.vertices),
                                   holes=tuple(tuple(next(rest) for _ in hole) for hole in self.holes))

    def with_radius(self, radius: float) -> Question:
        return dataclasses.replace(self, radius=radius)

    def row(self) -> list[float]:
        """Returns the row of numbers that stands for the ball in the functions of this module."""
        return [*self.centre, self.radius, *(self.to or ())]

    @functools.cached_property
    def polygon(self) -> Polygon:
        return Polygon(self.vertices, self.holes)

    @property
    def is_of_triangles(self) -> bool:
        return all(len(face) == 3 for face in self.faces) if self.faces else len(self.vertices) == 3 and not self.holes

    @property
    def contact(self) -> bool:
        """Whether the ball touches, exactly."""
        if self.faces is None:
            return bool(filtered.contact(self.row(), self.polygon))
        return bool(self.scene.touches(self.row()))

    @functools.cached_property
    def scene(self) -> Scene:
        """A scene of the mesh alone, which validates it."""
        scene = Scene()
        scene.add("mesh", Mesh(self.vertices, [list(face) for face in self.faces or ()]), pose=self.pose)
        return scene

    def posed(self) -> list[Point]:
        """Returns the vertices of the mesh under its pose, rounded once."""
        if self.pose is None:
            return list(self.vertices)
        rows = [[Fraction(x) for x in row] for row in self.pose]
        return [tuple(float(sum(m * Fraction(x) for m, x in zip(row, p)) + row[3]) for row in rows)  # type: ignore[misc]
                for p in self.vertices]

    def about_face(self, face: int) -> Question:
        """Returns the question about one face of the mesh, as a polygon."""
        posed = self.posed()
        return Question(self.centre, self.radius, tuple(posed[i] for i in (self.faces or ())[face]), to=self.to)

    def size(self) -> float:
        """Returns the largest magnitude of a coordinate and the radius."""
        points = self.points() if self.pose is None else [self.centre, *([self.to] if self.to else []), *self.posed()]
        return max(self.radius, *(abs(x) for p in points for x in p))

    def require_valid(self) -> None:
        """Raises Rejected or another ValueError, which says why, unless the contract accepts the question."""
        _ = self.contact

    def members(self) -> dict[str, Any]:
        """Returns what a case in JSON has of it."""
        case: dict[str, Any] = {"ball": {"center": self.centre, "radius": self.radius}}
        if self.to:
            case["motion"] = {"to": self.to}
        if self.faces is None:
            return case | {"polygon": {"outer": self.vertices, "holes": self.holes}}
        case["mesh"] = {"vertices": self.vertices, "faces": self.faces}
        if self.pose is not None:
            case["pose"] = {"rotation": [row[:3] for row in self.pose], "translation": [row[3] for row in self.pose]}
        return case


@dataclasses.dataclass(frozen=True)
class Case:
    """A question of a file of cases. `family`: the name of the file. `expected`: keys of the contract and their values."""

    id: str
    family: str
    tags: tuple[str, ...]
    question: Question
    expected: dict[str, Any]


def _points(loop: Any, closed: bool = False) -> tuple[Point, ...]:
    points = [tuple(float(x) for x in point) for point in loop]
    if closed:
        if points[0] != points[-1]:
            raise ValueError("a loop does not end with its first point")
        points.pop()
    return tuple(points)  # type: ignore[arg-type]


def _question_of(case: dict[str, Any], folder: pathlib.Path) -> Question:
    holes: tuple[tuple[Point, ...], ...] = ()
    faces = pose = None
    if "polygon" in case:
        polygon = case["polygon"]
        closed = polygon.get("closed", False)
        vertices = _points(polygon["outer"], closed)
        holes = tuple(_points(hole, closed) for hole in polygon.get("holes", ()))
    else:
        mesh = case["mesh"]
        if "file" in mesh:
            read = Mesh.read(folder / mesh["file"])
            mesh = {"vertices": read.vertices.tolist(), "faces": [list(face) for face in read.faces]}
        vertices = _points(mesh["vertices"])
        faces = tuple(tuple(int(i) for i in face) for face in mesh["faces"])
        if "pose" in case:
            rotation = case["pose"].get("rotation", [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
            translation = case["pose"].get("translation", [0, 0, 0])
            pose = tuple((*map(float, row), float(t)) for row, t in zip(rotation, translation))
    (to,) = _points([case["motion"]["to"]]) if "motion" in case else (None,)
    (centre,) = _points([case["ball"]["center"]])
    return Question(centre, float(case["ball"]["radius"]), vertices, holes, to, faces, pose)


def read_cases(file: pathlib.Path) -> Iterator[Case]:
    """Reads a file of cases. Leaves out those that expect an error: no engine can answer them.

    Raises ValueError, which names the file and the line, for a line that is not a valid case.
    """
    with open(file, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            if not line.strip():
                continue
            try:
                case = json.loads(line)
                expected = case.get("expected", {})
                if "error" in expected:
                    continue
                question = _question_of(case, file.parent)
                read = Case(str(case["id"]), file.stem, tuple(case.get("tags", ())), question, expected)
                question.require_valid()
            except Rejected as rejected:
                raise ValueError(f"{file}: line {number}: case {case.get('id')}: {rejected.code}: {rejected}") from rejected
            except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as fault:
                raise ValueError(f"{file}: line {number}: is not a case: {type(fault).__name__}: {fault}") from fault
            yield read
