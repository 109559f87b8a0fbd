# SPDX-License-Identifier: Apache-2.0
"""Answers that are wrong, but right about a ball of nearly this radius. `touchstone judge --beyond` decides the same; a
test compares both on the corpus.
"""

from __future__ import annotations

import math
import re
import sys
from fractions import Fraction
from typing import Any

from .. import exact
from .answers import FIRSTS, RELATIONS, exact_answer, read, same
from .question import Point, Question


def margin_of(beyond: str | float) -> tuple[float, bool]:
    """Returns the number and whether it is in sizes of the case: `2^-20`, `1e-6` or a number; with `m` it is a length."""
    found = re.fullmatch(r"(2\^)?([-+.0-9eE]+)(m?)", str(beyond))
    try:
        number = 2.0 ** int(found[2]) if found and found[1] else float(found[2] if found else "")
    except (ValueError, OverflowError):
        raise ValueError(f"{beyond!r} is not a margin: write 2^-20 or 1e-6, with m for a length") from None
    if not (0 < number < math.inf):
        raise ValueError(f"{beyond!r} is not above 0 and finite")
    return number, not (found and found[3])


def _dot(a: Any, b: Any) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _minus(a: Any, b: Any) -> list[Any]:
    return [x - y for x, y in zip(a, b)]


def _distance_to_segment(point: Any, ends: tuple[Any, Any]) -> float:
    """Returns a distance in doubles. Squares neither underflow nor overflow."""
    along, start = _minus(ends[1], ends[0]), _minus(point, ends[0])
    scale = max(abs(x) for x in (*along, *start))
    if not 0 < scale < math.inf:
        return float(scale)
    unit, there = [x / scale for x in along], [x / scale for x in start]
    squared = _dot(unit, unit)
    share = min(max(_dot(unit, there) / squared, 0.0), 1.0) if squared > 0 else 0.0
    away = [x - share * y for x, y in zip(there, unit)]
    return float(scale * math.sqrt(_dot(away, away)))


def _truncated(x: Fraction) -> float:
    try:
        nearest = float(x)
    except OverflowError:
        return math.copysign(math.inf, x)
    return math.nextafter(nearest, 0) if abs(Fraction(nearest)) > abs(x) else nearest


class _Plane:
    """The supporting plane of a polygon, in fractions."""

    def __init__(self, loop: tuple[Point, ...]) -> None:
        points = [[Fraction(x) for x in p] for p in loop]
        pairs = list(zip(points, points[1:] + points[:1]))
        self.normal: list[Any] = [sum(p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3] for p, q in pairs) for k in range(3)]
        self.mean: list[Any] = [sum(p[k] for p in points) / len(points) for k in range(3)]
        sizes: list[Fraction] = [abs(n) for n in self.normal]
        self.axis = sizes.index(max(sizes))

    def _height(self, point: Point) -> Fraction:
        return Fraction(_dot(self.normal, _minus(map(Fraction, point), self.mean)))

    def foot(self, point: Point) -> list[float]:
        share = self._height(point) / _dot(self.normal, self.normal)
        return [_truncated(Fraction(x) - share * n) for x, n in zip(point, self.normal)]

    def lifted(self, vertex: Point) -> list[float]:
        lift = self._height(vertex) / self.normal[self.axis]
        return [_truncated(Fraction(x) - lift) if k == self.axis else x for k, x in enumerate(vertex)]


def _is_sorted_between(least: list[int], found: list[int], most: list[int]) -> bool:
    return found == sorted(found) and set(least) <= set(found) <= set(most) and len(set(found)) == len(found)


class AnswersWithin:
    """The exact answers to a question with its radius, and with one that is off by a margin to either side."""

    def __init__(self, question: Question, margin: float, size: float | None = None) -> None:
        self.question, self.margin, self.size = question, margin, question.size() if size is None else size
        self.larger_radius = min(question.radius + margin, sys.float_info.max)
        radii = max(question.radius - margin, 0.0), question.radius, self.larger_radius
        self.smallest, self.truth, self.largest = (exact_answer(question.with_radius(r)) for r in radii)

    def is_exact(self, key: str, expected: Any) -> bool:
        """Returns whether an expected value is the exact one. Another one has no margin."""
        return key in self.truth and same(key, self.truth[key], expected)

    def has(self, answer: dict[str, Any], key: str) -> bool:
        """Returns whether the value that an answer has of a key is within the margin, as docs/engines.md defines it."""
        given = answer[key]
        if any(key in one and same(key, one[key], given) for one in (self.smallest, self.truth, self.largest)):
            return True
        if key == "depth" and answer.get("first") == "none":  # has no depth
            return False
        try:
            found = read(key, given)
        except ValueError:
            return False
        if self.question.faces is None:
            return self._is_between(key, found)
        if key == "face":
            return self._has_face(found)
        if key == "touched":
            return _is_sorted_between(self.smallest[key], found, self.largest[key])
        if key in ("relation", "first", "time", "distance") or (key == "depth" and self.question.to is None):
            return self._is_between(key, found)
        if key == "contact":
            return False
        try:
            named = read("face", answer.get("face"))
        except ValueError:
            named = None
        face = named if named is not None and self._has_face(named) else self.truth["face"]
        return face is not None and AnswersWithin(self.question.about_face(face), self.margin, self.size).has(answer, key)

    def _has_face(self, face: int) -> bool:
        if face >= len(self.question.faces or ()):
            return False
        about_face = exact_answer(self.question.about_face(face).with_radius(self.larger_radius))
        if self.question.to is None:
            return bool(about_face["distance"] - self.truth["distance"] <= self.margin)
        return about_face["contact"] and _time(about_face) <= _time(self.smallest)

    def _is_between(self, key: str, found: Any) -> bool:
        small: Any = self.smallest.get(key)
        large: Any = self.largest.get(key)
        if key == "relation":
            return RELATIONS.index(small) <= RELATIONS.index(found) <= RELATIONS.index(large)
        if key == "first":
            return FIRSTS.index(large) <= FIRSTS.index(found) <= FIRSTS.index(small)
        if key == "time":
            return bool(_time(self.largest) <= found <= min(_time(self.smallest), 1.0))
        if key == "momentary":
            return not small == self.truth[key] == large
        if key == "plane_tangent":
            return self.smallest.get("plane") != self.largest.get("plane")
        if key == "edges_hit":
            return _is_sorted_between(small, found, large)
        if key in ("distance", "depth", "off_plane"):
            near = large if self.truth.get(key) is None else self.truth[key]
            return near is not None and abs(found - near) <= self.margin
        if key == "point":
            return self._has_point(found)
        if key == "contact_normal":
            return self._has_normal(found)
        if key == "nearest":
            return self._has_feature(found)
        return key == "foot" and self._foot_is_near_boundary()

    def _reaches(self, begin: Any, end: Any) -> bool:
        """Returns whether the polygon comes within the margin of a segment."""
        row = [*begin, self.margin, *end]
        return all(map(math.isfinite, row)) and bool(exact.contact(row, self.question.polygon))

    def _may_touch(self) -> bool:
        return self.question.to is None or self.largest["contact"]

    def _distance(self) -> float:
        """Returns the distance of the centre at rest, or at the first contact."""
        if self.question.to is None:
            return float(self.truth["distance"])
        return float(self.question.radius - (self.truth["depth"] if self.truth["contact"] else 0))

    def _centres(self) -> tuple[list[float], list[float]]:
        """Returns where the centre may be: its place, or the ends of its way between the first contacts."""
        start, to = self.question.centre, self.question.to or self.question.centre
        times = [min(_time(one), 1.0) if self.question.to else 0.0 for one in (self.largest, self.smallest)]
        begin, end = ([x + time * (y - x) for x, y in zip(start, to)] for time in times)
        return begin, end

    def _has_point(self, point: list[float]) -> bool:
        return (self._may_touch() and math.isfinite(self._distance()) and self._reaches(point, point) and
                _distance_to_segment(point, self._centres()) <= self._distance() + self.margin)

    def _has_normal(self, normal: list[float]) -> bool:
        if not (self._may_touch() and abs(math.sqrt(_dot(normal, normal)) - 1) * self.size <= self.margin):
            return False
        ends = [[x + -self._distance() * n for x, n in zip(centre, normal)] for centre in self._centres()]
        return self._reaches(*ends)

    def _has_feature(self, feature: dict[str, Any]) -> bool:
        centre, polygon = self.question.centre, self.question.polygon
        reach = self.truth["distance"] + self.margin
        if not math.isfinite(reach):
            return False
        plane = _Plane(self.question.vertices)
        if feature["kind"] == "face":
            foot = plane.foot(centre)
            return self._reaches(foot, foot) and _distance_to_segment(foot, (centre, centre)) <= reach
        if feature["kind"] == "edge":
            return feature["index"] in exact.edges_hit([*centre, reach], polygon)
        vertices = [*self.question.vertices, *(p for hole in self.question.holes for p in hole)]
        index = int(feature["index"])
        return index < len(vertices) and bool(_distance_to_segment(plane.lifted(vertices[index]), (centre, centre)) <= reach)

    def _foot_is_near_boundary(self) -> bool:
        foot = _Plane(self.question.vertices).foot(self.question.centre)
        return all(map(math.isfinite, (*foot, self.margin))) and len(exact.edges_hit([*foot, self.margin], self.question.polygon)) > 0


def _time(answer: dict[str, Any]) -> float:
    """Returns the time of first contact, or infinity."""
    return math.inf if answer["time"] is None else float(answer["time"])


def within_margin(question: Question, margin: tuple[float, bool]) -> AnswersWithin:
    """Returns the answers with the margin, as `margin_of` reads it, of a question."""
    number, of_size = margin
    return AnswersWithin(question, number * question.size() if of_size else number)


