# SPDX-License-Identifier: Apache-2.0
"""Strategies of Hypothesis for polygons, and for balls that touch them by a few doubles or miss them by as many.

    @hypothesis.given(strategies.questions())
    def test_engine(question):
        assert engine(question.centre, question.radius, question.vertices) == question.contact
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from hypothesis import strategies as st

from . import Polygon, Rejected, filtered
from .judging import Question
from .judging.shrinking import moved

Ball = tuple[float, float, float, float]


def _angle(point: tuple[int, int]) -> float:
    return math.atan2(point[1], point[0])


def _turn(a: tuple[int, int], b: tuple[int, int]) -> int:
    return a[0] * b[1] - a[1] * b[0]


@st.composite
def _stars(draw: st.DrawFn, most: int, around: bool) -> list[tuple[int, int]]:
    """A loop of integers that is seen whole from the origin, which is inside if `around` and else perhaps a vertex."""
    one = st.integers(-8, 8)
    points = draw(st.lists(st.tuples(one, one).filter(any), min_size=0 if around else 2, max_size=most - 3 if around else most,
                           unique_by=lambda p: (p[0] // math.gcd(*p), p[1] // math.gcd(*p))))
    if around:  # three directions with the origin between them
        directions = {(p[0] // math.gcd(*p), p[1] // math.gcd(*p)) for p in points}
        points += [p for p in ((1, 0), (-1, 1), (-1, -1)) if p not in directions]
    if len(points) == 2 and _turn(*points) == 0:
        points[1] = (-points[0][1], points[0][0])
    points.sort(key=_angle)
    gap = next((i for i, p in enumerate(points) if _turn(p, points[(i + 1) % len(points)]) <= 0), None)
    return points if gap is None else [*points[:gap + 1], (0, 0), *points[gap + 1:]]


@st.composite
def polygons(draw: st.DrawFn, max_vertices: int = 8, holes: bool = False, floats: bool = False) -> Polygon:
    """Draws a valid polygon: an integer outline, convex or not, in a plane of integer directions, times a power of two; or,
    half of the time, a triangle of any numbers of magnitude 2^-10 to 2^10. `holes`: a quarter have a hole. `floats`: all
    coordinates are floats.
    """
    if draw(st.booleans()):
        number = st.floats(-1024, 1024, width=32 if floats else 64, allow_subnormal=False).map(lambda x: x if abs(x) >= 2**-10 else 0.0)
        corners = [draw(st.tuples(number, number, number)) for _ in range(3)]
        try:
            return Polygon(corners)
        except Rejected:  # its corners lie on a line
            pass
    with_hole = holes and draw(st.booleans())
    star = draw(_stars(max_vertices - 1, with_hole))
    small = st.integers(-3, 3)
    across, along = draw(st.sampled_from([([1, 0, 0], [0, 1, 0]), ([0, 1, 0], [0, 0, 1]), ([1, 2, 0], [0, 1, -1]), ([1, 1, 1], [2, -1, 3])]))
    start = [draw(small) for _ in range(3)]
    unit = 2.0 ** draw(st.integers(-8, 8))

    def placed(loop: list[tuple[int, int]]) -> list[list[float]]:
        return [[unit * (s + x * a + y * b) for s, a, b in zip(start, across, along)] for x, y in loop]

    if not with_hole:
        return Polygon(placed(star))
    return Polygon(placed([(2 * x, 2 * y) for x, y in star]), [placed(star)])


@st.composite
def balls_near(draw: st.DrawFn, polygon: Polygon, steps: int = 3, floats: bool = False) -> Ball:
    """Draws a ball, as a row x, y, z, r, whose radius is the double nearest to its distance from the polygon or at most
    `steps` doubles beside it; with `floats`, all numbers are floats. Its foot is on or near three vertices' triangle, an edge
    or a vertex, half of the time; otherwise its centre is anywhere within two sizes.
    """
    numbers: Any = np.float32 if floats else np.float64
    vertices = np.concatenate([polygon.outer, *polygon.holes])
    size = 2.0 ** math.frexp(float(np.ptp(vertices, axis=0).max()))[1]
    share = st.integers(-32, 32).map(lambda i: i / 16)
    first, second, third = (vertices[draw(st.integers(0, len(vertices) - 1))] for _ in range(3))
    eighths = draw(st.integers(0, 8))
    start = first + (second - first) * eighths / 8 + (third - second) * draw(st.integers(0, eighths)) / 8
    if draw(st.booleans()):
        normal = np.cross(polygon.outer, np.roll(polygon.outer, -1, axis=0)).sum(axis=0)
        offset = draw(share) * normal / 2.0 ** math.frexp(float(np.abs(normal).max()))[1]
    else:
        offset = np.array([draw(share if draw(st.booleans()) else st.floats(-2, 2, width=32)) for _ in range(3)])
    centre = numbers(start + offset * size).astype(float)
    distance = float(filtered.closest([*centre, 0], polygon)[1])
    x, y, z = centre.tolist()
    return x, y, z, moved(distance, draw(st.integers(-steps, steps)), numbers)


@st.composite
def questions(draw: st.DrawFn, max_vertices: int = 8, holes: bool = False, steps: int = 3, floats: bool = False) -> Question:
    """Draws a question about a ball and a polygon, as `balls_near` and `polygons` draw them. It prints as Python that makes it."""
    polygon = draw(polygons(max_vertices, holes, floats))
    x, y, z, radius = draw(balls_near(polygon, steps, floats))
    loops: Any = (polygon.outer, *polygon.holes)
    outer, *others = (tuple((a, b, c) for a, b, c in loop.tolist()) for loop in loops)
    return Question((x, y, z), radius, outer, tuple(others))
