# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_every_state.py LIBRARY [unittest's options]

Every function of the module that is exact gives the same bits in every state of the floating-point unit, and leaves that
state as found. LIBRARY sets the state (set_state.cpp). A function that is in no table here is a failure.
"""

import ctypes
import decimal
import fractions
import itertools
import sys
import unittest

import numpy as np
import touchstone_contact as touchstone

LEAST = 5e-324
LARGEST = sys.float_info.max
SQUARE = np.array([[0.0, -0.0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]])
BALLS = np.array([[2, 2, 1, 1], [-1, -1, 0, -0.0], [-0.0, 0, 0, 0], [5, 2, -1, 1], [2, 2, 0.5, 0.5]])
MOTIONS = np.column_stack([BALLS, BALLS[::-1, :3] - [0.5, 0, 0.25]])
UNITS = (1.0, 1 / 3, LEAST, 4 * LEAST, 2.0**-1040, LARGEST / 8)

# Numbers that NumPy converts, each by other means: where the nearest double depends on the rounding mode, or is subnormal.
NUMBERS = (
    [2**53 + 1, -(2**53 + 1), 0],
    np.array([2**53 + 1, 2**62 + 1, -(2**53 + 1)], dtype=np.int64),
    np.array([2**64 - 1, 2**63 + 1025, 1], dtype=np.uint64),
    np.array([1e-45, -4e-45, 1], dtype=np.float32),
    np.array([6e-8, 1, -6e-8], dtype=np.float16),
    np.array([1, 3, -1], dtype=np.longdouble) / np.longdouble(10),
    [decimal.Decimal("0.1"), decimal.Decimal("1.1"), decimal.Decimal("-5e-324")],
    [fractions.Fraction(1, 3), fractions.Fraction(-1, 10), fractions.Fraction(1, 2**1074)],
    [LEAST, -0.0, LARGEST],
    [True, False, True],
)


def as_bytes(result):
    """Equal where the bits are."""
    if isinstance(result, touchstone.Answer):
        return as_bytes(result.verdict())
    if isinstance(result, touchstone.FirstContact):
        return as_bytes([result.kind, result.time, result.momentary, result.feature, result.point,
                         result.contact_normal, result.depth])
    if isinstance(result, dict):
        return [(key, as_bytes(value)) for key, value in result.items()]
    if isinstance(result, (list, tuple)):
        return [as_bytes(each) for each in result]
    if isinstance(result, (float, np.ndarray)):
        return np.asarray(result).tobytes()
    return result


def outcome(call):
    try:
        return as_bytes(call())
    except (ValueError, TypeError) as error:
        return str(error)


def polygons():
    return [touchstone.Polygon(SQUARE * unit) for unit in UNITS]


class EveryState(unittest.TestCase):
    library = None

    def in_state(self, call, rounding, flush):
        self.library.set_state(rounding, flush)
        before = self.library.state()
        try:
            return outcome(call)
        finally:
            after = self.library.state()
            self.library.set_state(0, 0)
            self.assertEqual(after, before, "the state is not left as found")

    def assert_same_in_every_state(self, call, what):
        expected = outcome(call)
        for rounding, flush in itertools.product(range(4), range(4)):
            self.assertEqual(self.in_state(call, rounding, flush), expected, (*what, rounding, flush))

    def test_changes_no_answer(self):
        functions = {name for path in (touchstone.filtered, touchstone.exact) for name in dir(path) if name[0] != "_"}
        self.assertEqual(functions, {"contact", "first_contact", "relation", "plane_side", "foot", "edges_hit", "closest",
                                     "answer"})
        for path, name in itertools.product((touchstone.filtered, touchstone.exact), sorted(functions)):
            ask = getattr(path, name)
            for unit, polygon in zip(UNITS, polygons()):
                balls = (MOTIONS if name == "first_contact" else BALLS) * unit
                self.assert_same_in_every_state(lambda: ask(balls, polygon), (path.__name__, name, unit))
                self.assert_same_in_every_state(lambda: ask(balls[1], polygon), (path.__name__, name, unit, "single"))

    def test_changes_no_polygon(self):
        attributes = {name for name in dir(touchstone.Polygon) if name[0] != "_"}
        self.assertEqual(attributes, {"outer", "holes", "of"})
        for unit in UNITS:
            rows = SQUARE * unit
            self.assert_same_in_every_state(lambda: touchstone.Polygon(rows).outer, (unit,))
            self.assert_same_in_every_state(lambda: touchstone.Polygon(rows[:2]).outer, (unit, "too few"))
            text = ", ".join(" ".join(map(repr, row)) for row in [*rows.tolist(), rows[0].tolist()])
            self.assert_same_in_every_state(lambda: touchstone.Polygon.of(f"POLYGON(({text}))").outer, (unit, "WKT"))

    def test_changes_no_answer_about_many_faces(self):
        attributes = {kind: {name for name in dir(kind) if name[0] != "_"} for kind in (touchstone.TriangleSet, touchstone.Scene, touchstone.Solid)}
        self.assertEqual(attributes, {touchstone.TriangleSet: {"contact", "any_contact", "triangles_hit", "triangles"},
                                      touchstone.Scene: {"add", "remove", "set_pose", "pose", "names", "numbers", "face_count", "face_numbers", "left_out",
                                                         "segments", "touches", "touched", "touched_in_order", "first_contact", "nearest"},
                                      touchstone.Solid: {"locate", "touches", "signed_distance"}})
        turn = np.array([[0.6, -0.8, 0, 1], [0.8, 0.6, 0, 0], [0, 0, 1, 0]])
        for unit in UNITS:
            triangles, balls = SQUARE[[[0, 1, 2], [0, 2, 3]]] * unit, BALLS * unit
            square, pose = touchstone.Polygon(SQUARE * unit), turn * [[1, 1, 1, unit]]

            def scene(triangles=triangles, square=square, pose=pose):
                made = touchstone.Scene()
                made.add("triangles", triangles)
                made.add("polygon", square, pose)
                made.set_pose("triangles", turn)
                return made

            for name in ("contact", "any_contact", "triangles_hit"):
                self.assert_same_in_every_state(lambda: getattr(touchstone.TriangleSet(triangles), name)(balls), (name, unit))
            for name in ("touches", "touched", "nearest"):
                self.assert_same_in_every_state(lambda: getattr(scene(), name)(balls), (name, unit))

            def segment():
                made = touchstone.Scene()
                made.add("segment", SQUARE[[[0, 1, 1]]] * unit, bad_faces="as segments")
                return made

            self.assert_same_in_every_state(lambda: (segment().segments(0), segment().touches(balls)), ("segment", unit))
            motions = MOTIONS * unit
            for name in ("first_contact", "touched_in_order"):
                self.assert_same_in_every_state(lambda: getattr(scene(), name)(motions), (name, unit))
            self.assert_same_in_every_state(lambda: scene().pose("polygon"), ("pose", unit))
            corners, faces = np.vstack([SQUARE[:3], [0, 0, 1]]) * unit, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
            for name, rows in (("locate", balls[:, :3]), ("touches", balls), ("signed_distance", balls[:, :3])):
                self.assert_same_in_every_state(lambda: getattr(touchstone.Solid(corners, faces), name)(rows), (name, unit))

    def test_changes_no_mesh(self):
        for unit in UNITS:
            rows = SQUARE * unit
            self.assert_same_in_every_state(lambda: touchstone.Mesh(rows, [[0, 1, 2, 3]]).vertices, (unit,))
            self.assert_same_in_every_state(lambda: touchstone.merge_faces(touchstone.Mesh(rows, [[0, 1, 2], [0, 2, 3]])).off_plane,
                                            (unit, "merged"))

    def test_changes_no_number_that_is_converted(self):
        for numbers in NUMBERS:
            triangle = [[0, 0, 0], numbers, [0, 7, 0]]
            self.assert_same_in_every_state(lambda: touchstone.Polygon(triangle).outer, (repr(numbers), "in a list"))
            self.assert_same_in_every_state(
                lambda: touchstone.Polygon(np.array([[n, k, 0] for k, n in enumerate(numbers)], dtype=object)).outer,
                (repr(numbers), "as objects"))
            if isinstance(numbers, np.ndarray):
                rows = np.array([[0, 0, 0], numbers, [0, 1, 0]], dtype=numbers.dtype)
                self.assert_same_in_every_state(lambda: touchstone.Polygon(rows).outer, (repr(numbers), "as an array"))

    def test_changes_no_refusal_of_a_ball(self):
        polygon = touchstone.Polygon(SQUARE)
        for ball in ([0, 0, 0, -LEAST], [0, 0, float("nan"), 1], [0, 0, 0, -0.0], [0, 0, 0, float("inf")]):
            for path in (touchstone.filtered, touchstone.exact, touchstone.fast):
                self.assert_same_in_every_state(lambda: path.contact(ball, polygon), (path.__name__, ball))


if __name__ == "__main__":
    EveryState.library = ctypes.CDLL(sys.argv.pop(1))
    unittest.main()
