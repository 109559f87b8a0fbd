# SPDX-License-Identifier: Apache-2.0
"""Makes a question small on which an engine fails: fewer loops, faces and vertices, shorter numbers."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from .. import exact
from .question import Point, Question


def _parts(x: float) -> tuple[int, int]:
    """Returns the odd significand and the exponent of a number; both are 0 for 0."""
    if x == 0:
        return 0, 0
    fraction, exponent = math.frexp(abs(x))
    whole = int(fraction * 2.0**53)
    zeros = (whole & -whole).bit_length() - 1
    return whole >> zeros, exponent - 53 + zeros


def _bits(x: float) -> int:
    significand, exponent = _parts(x)
    return significand.bit_length() + abs(exponent).bit_length() + (x < 0)


def _size(question: Question) -> tuple[int, int, int]:
    numbers = [question.radius, *(x for p in question.points() for x in p)]
    return len(question.faces or question.holes), len(question.points()), sum(map(_bits, numbers))


def steps_from(threshold: float, radius: float, numbers: Any) -> int:
    """Returns how many numbers of a type a radius lies above a threshold. Both are rounded to it, and not negative."""
    whole: Any = np.int32 if numbers is np.float32 else np.int64
    return int(numbers(radius).view(whole)) - int(numbers(threshold).view(whole))


def moved(threshold: float, steps: int, numbers: Any) -> float:
    """Returns the number that many above a threshold, but neither a negative nor an infinite one."""
    whole: Any = np.int32 if numbers is np.float32 else np.int64
    least, most = 0, int(np.finfo(numbers).max.view(whole))
    return float(whole(min(max(int(numbers(threshold).view(whole)) + steps, least), most)).view(numbers))


def _with_fewer_parts(question: Question) -> Iterator[Question]:
    for i in range(len(question.holes)):
        yield dataclasses.replace(question, holes=question.holes[:i] + question.holes[i + 1:])
    if question.faces is None:
        for i in range(len(question.vertices)):
            yield dataclasses.replace(question, vertices=question.vertices[:i] + question.vertices[i + 1:])
        for i, hole in enumerate(question.holes):
            for j in range(len(hole)):
                fewer = (hole[:j] + hole[j + 1:],)
                yield dataclasses.replace(question, holes=question.holes[:i] + fewer + question.holes[i + 1:])
        return
    for i in range(len(question.faces) if len(question.faces) > 1 else 0):
        faces = question.faces[:i] + question.faces[i + 1:]
        used = sorted({vertex for face in faces for vertex in face})
        yield dataclasses.replace(question, vertices=tuple(question.vertices[v] for v in used),
                                  faces=tuple(tuple(used.index(v) for v in face) for face in faces))


def _mapped(question: Question, f: Callable[[float, int], float]) -> Question:
    return question.with_points([(f(x, 0), f(y, 1), f(z, 2)) for x, y, z in question.points()])


def _simpler(x: float) -> Iterator[float]:
    """Yields simpler numbers, the simplest first."""
    significand, exponent = _parts(x)
    width = significand.bit_length()
    yield from (0.0, math.copysign(1.0, x))
    for keep in (1, 2, 4, 8, 12, 16, 20, 24, 32, 40, 48, width - 1):
        if 0 < keep < width:
            grid = exponent + width - keep
            yield math.ldexp(round(math.ldexp(x, -grid)), grid)
    yield math.copysign(math.ldexp(significand, 0), x)


def _with_simpler_numbers(question: Question) -> Iterator[Question]:
    points: list[Point] = question.points()
    for origin in points[1:]:
        yield _mapped(question, lambda x, axis, origin=origin: x - origin[axis])  # type: ignore[misc]
    exponents = {_parts(x)[1] for p in points for x in p if x} | {math.frexp(x)[1] - 1 for p in points for x in p if x}
    for exponent in sorted(exponents):
        scaled = _mapped(question, lambda x, _, exponent=exponent: math.ldexp(x, -exponent))  # type: ignore[misc]
        yield scaled.with_radius(math.ldexp(question.radius, -exponent))
    top = max((math.frexp(x)[1] for p in points for x in p), default=0)
    for bits in (1, 2, 3, 4, 6, 8, 12, 16, 24, 32):
        yield _mapped(question, lambda x, _, grid=top - bits: math.ldexp(round(math.ldexp(x, -grid)), grid))  # type: ignore[misc]
    yield from (question.with_radius(x) for x in _simpler(question.radius))
    for i, point in enumerate(points):
        for axis in range(3):
            for x in _simpler(point[axis]):
                changed = (*point[:axis], x, *point[axis + 1:])
                yield question.with_points([*points[:i], changed, *points[i + 1:]])  # type: ignore[list-item]


def shrunk(question: Question, fails: Callable[[Question], bool], numbers: Any, most: int = 2000) -> Question:
    """Returns a smaller question for which `fails` holds, and which the contract accepts; numbers are of the given type.

    Where a ball does not move, a question also counts with a radius that is as many numbers from its threshold as before.
    Asks `fails` at most `most` times.
    """
    calls = 0
    steps = None if question.to or question.faces else steps_from(_distance(question), question.radius, numbers)

    def holds(candidate: Question) -> bool:
        nonlocal calls
        calls += 1
        return fails(candidate)

    @np.errstate(over="ignore")  # a number that became infinite is refused below
    def accepted(candidate: Question, best: Question) -> Question | None:
        try:
            candidate = _mapped(candidate, lambda x, _: float(numbers(x)) + 0.0).with_radius(float(numbers(candidate.radius)))
            if _size(candidate) >= _size(best):
                return None
            candidate.require_valid()
            if holds(candidate):
                return candidate
            if steps is None or abs(steps) > 1000:
                return None
            candidate = candidate.with_radius(moved(_distance(candidate), steps, numbers))
            return candidate if _size(candidate) < _size(best) and holds(candidate) else None
        except (ValueError, OverflowError):
            return None

    best, looks = question, True
    while looks and calls < most:
        looks = False
        for ways in (_with_fewer_parts, _with_simpler_numbers):
            again = True
            while again and calls < most:
                found = next((one for one in (accepted(way, best) for way in ways(best)) if one or calls >= most), None)
                again = found is not None
                best, looks = found or best, looks or again
    return best


def _distance(question: Question) -> float:
    return float(exact.closest([*question.centre, question.radius], question.polygon)[1])
