# SPDX-License-Identifier: GPL-3.0-or-later
"""The checker on cases whose answers were derived by hand, one subtle point of the contract each."""
import io
import json
import math
import os
import tempfile
import unittest
from fractions import Fraction

import checker
import surd
import unseen_cases

TINY, HUGE = 5e-324, 1.7976931348623157e308
ULP = 2.0 ** -52
SQUARE = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]
FACE = {"kind": "face"}
FRAME = [[-20, -20, 0], [20, -20, 0], [20, 20, 0], [-20, 20, 0]]


def text(center=(1, 1, 1), radius=1, outer=SQUARE, holes=(), **more):
    ball, polygon = {"center": center, "radius": radius}, {"outer": outer, "holes": list(holes)}
    return json.dumps({"id": "a", "ball": ball, "polygon": polygon, **more})


def judge(*arguments, **more):
    return checker.judge_case(text(*arguments, **more))


def code(*arguments, **more):
    return judge(*arguments, **more).get("error")


def edge(index):
    return {"kind": "edge", "index": index}


def vertex(index):
    return {"kind": "vertex", "index": index}


class Answers(unittest.TestCase):
    def test_the_contracts_example(self):
        line = (
            '{"id":"tilted-L-17","ball":{"center":[0.5,0.25,1],"radius":1},"polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]],'
            '"holes":[]},"expected":{"relation":"touching"},"tags":["tangent","lattice"]}')
        verdict = (
            '{"id":"tilted-L-17","method":"exact","plane":"intersects","plane_tangent":true,"foot":"inside","edges_hit":[],'
            '"relation":"touching","contact":true,"nearest":{"kind":"face"},"point":[0.5,0.25,0],"distance":1,'
            '"contact_normal":[0,0,1],"depth":0,"off_plane":0}')
        self.assertEqual(checker.differences(checker.judge_case(line), verdict, "exact"), [])

    def test_plane(self):
        for z, radius, plane, tangent in (
                (2, 1, "in_front", False), (-2, 1, "behind", False), (2, 2, "intersects", True), (-2, 2, "intersects", True),
                (1, 2, "intersects", False), (0, 0, "intersects", True), (TINY, 0, "in_front", False),
                (1, 1 - ULP / 2, "in_front", False), (1, 1 + ULP, "intersects", False)):
            verdict = judge((9, 9, z), radius)
            self.assertEqual((verdict["plane"], verdict["plane_tangent"]), (plane, tangent), (z, radius))

    def test_reversing_the_outer_loop_turns_the_front(self):
        self.assertEqual(judge((1, 1, 2), 1, SQUARE[::-1])["plane"], "behind")

    def test_foot(self):
        for x, y, foot in ((1, 1, "inside"), (2, 0, "boundary"), (4, 4, "boundary"), (2, -TINY, "outside"),
                           (2, TINY, "inside"), (5, 0, "outside")):
            self.assertEqual(judge((x, y, 3))["foot"], foot, (x, y))

    def test_foot_level_with_vertices(self):
        bowl = [[0, 0, 0], [2, 1, 0], [4, 0, 0], [6, 3, 0], [4, 2, 0], [2, 2, 0], [1, 4, 0]]
        for x, y, foot in ((-1, 1, "outside"), (1, 1, "inside"), (3, 1, "inside"), (-1, 0, "outside"),
                           (3, 0, "outside"), (3, 2, "boundary"), (1, 2, "inside")):
            self.assertEqual(judge((x, y, 1), 1, bowl)["foot"], foot, (x, y))

    def test_holes_and_islands_by_even_odd(self):
        holes = [[[s * x, s * y, 0] for x, y in ((1, 1), (1, -1), (-1, -1), (-1, 1))] for s in (10, 5)]
        for x, foot in ((15, "inside"), (10, "boundary"), (7, "outside"), (5, "boundary"), (2, "inside")):
            self.assertEqual(judge((x, 0, 1), 1, FRAME, holes)["foot"], foot, x)

    def test_boundary_names_the_feature_that_holds_the_foot(self):
        self.assertEqual(judge((2, 0, 3))["nearest"], edge(0))
        self.assertEqual(judge((4, 4, 3))["nearest"], vertex(2))
        run = [[0, 0, 0], [2, 0, 0], [4, 0, 0], [4, 4, 0]]  # vertex 1 lies in a straight run
        self.assertEqual(judge((2, 0, 3), 1, run)["nearest"], vertex(1))
        self.assertEqual(judge((3, 0, 3), 1, run)["nearest"], edge(1))

    def test_edge_only_strictly_between_its_ends(self):
        self.assertEqual(judge((4, -3, 0))["nearest"], vertex(1))
        self.assertEqual(judge((4 - 4 * ULP, -3, 0))["nearest"], edge(0))
        self.assertEqual(judge((4, -3, 0))["point"], [4, 0, 0])

    def test_lowest_edge_among_equal_distances(self):
        hole = [[5, 5, 0], [5, -5, 0], [-5, -5, 0], [-5, 5, 0]]
        verdict = judge((0, 0, 12), 13, FRAME, [hole])
        self.assertEqual((verdict["nearest"], verdict["relation"], verdict["distance"]), (edge(4), "touching", 13))
        self.assertEqual((verdict["edges_hit"], verdict["point"]), ([4, 5, 6, 7], [5, 0, 0]))

    def test_edge_before_a_vertex_of_lower_index(self):
        hole = [[-5, 0, 0], [-10, -10, 0], [5, -10, 0], [5, 10, 0], [-10, 10, 0]]
        verdict = judge((0, 0, 0), 5, FRAME, [hole])
        self.assertEqual((verdict["nearest"], verdict["edges_hit"]), (edge(6), [4, 6, 8]))

    def test_lowest_vertex_among_equal_distances(self):
        hole = [[0, 5, 0], [9, 9, 0], [9, -9, 0], [0, -5, 0], [-9, -9, 0], [-9, 9, 0]]
        verdict = judge((0, 0, 0), 1, FRAME, [hole])
        self.assertEqual((verdict["nearest"], verdict["distance"]), (vertex(4), 5))

    def test_relation(self):
        for radius, relation in ((5 - 4 * ULP, "separate"), (5, "touching"), (5 + 4 * ULP, "overlapping")):
            verdict = judge((2, -3, 4), radius)
            self.assertEqual((verdict["relation"], verdict["contact"]), (relation, relation != "separate"))
            self.assertEqual(verdict["edges_hit"], [0] if relation != "separate" else [])

    def test_radius_zero(self):
        verdict = judge((0, 0, 0), -0.0)
        self.assertEqual((verdict["relation"], verdict["nearest"]), ("touching", vertex(0)))
        self.assertEqual(verdict["edges_hit"], [0, 3])
        self.assertEqual(judge((1, 1, TINY), 0)["relation"], "separate")

    def test_lift_along_the_lowest_axis_of_a_tie(self):
        # N = (-8, -8, 0), g = 0: all vertices move by 1 along x, the first to (1, -1, 1).
        saddle = [[2, -1, 1], [-2, 1, 1], [0, 1, -1], [0, -1, -1]]
        verdict = judge((1, -1, 3), 2, saddle)
        self.assertEqual((verdict["nearest"], verdict["point"]), (vertex(0), [1, -1, 1]))
        self.assertEqual((verdict["off_plane"], verdict["edges_hit"], verdict["relation"]), (1, [0, 3], "touching"))

    def test_lift_along_the_largest_component_not_along_the_normal(self):
        # A hole's vertex off the tilted plane z = x / 2: N = (-8, 0, 16); (2, 1, 3) moves down by 2 to (2, 1, 1).
        tilted, hole = [[0, 0, 0], [4, 0, 2], [4, 4, 2], [0, 4, 0]], [[2, 1, 3], [3, 2, 1.5], [1, 2, 0.5]]
        verdict = judge((2, 1, 1), 0, tilted, [hole])
        self.assertEqual((verdict["off_plane"], verdict["nearest"], verdict["relation"]), (2, vertex(4), "touching"))

    def test_planar_vertices_stay(self):
        verdict = judge((0.1, 0.7, 0.3), 0, [[0.1, 0.7, 0.3], [1e300, 3, 5e-324], [-7, 1e-200, 4]])
        self.assertEqual((verdict["off_plane"], verdict["point"], verdict["nearest"]), (0, [0.1, 0.7, 0.3], vertex(0)))

    def test_mean_of_the_outer_vertices_is_not_a_vertex(self):
        # g = (2, 2, 1), N = (0, 0, 32): every vertex moves by 1, the plane is z = 1.
        bent = [[0, 0, 0], [4, 0, 2], [4, 4, 0], [0, 4, 2]]
        verdict = judge((1, 1, 3), 2, bent)
        self.assertEqual((verdict["off_plane"], verdict["relation"], verdict["point"]), (1, "touching", [1, 1, 1]))


class Rounding(unittest.TestCase):
    def test_ties_of_the_distance_go_to_even(self):
        half = ULP / 2
        for z, distance in ((half, 1), (3 * half, 1 + 2 * ULP), (half + 2.0 ** -80, 1 + ULP)):
            self.assertEqual(judge((1, 1, -1), 1, [[x, y, z] for x, y, _ in SQUARE])["distance"], distance)

    def test_roots_around_midpoints(self):
        middle, little = 1 + Fraction(1, 2 ** 53), Fraction(1, 10 ** 400)
        self.assertEqual([checker.nearest_root(middle ** 2 + x) for x in (-little, 0, little)], [1, 1, 1 + ULP])
        middle = 1 + Fraction(3, 2 ** 53)
        self.assertEqual([checker.nearest_root(middle ** 2 + x) for x in (-little, 0, little)],
                         [1 + ULP, 1 + 2 * ULP, 1 + 2 * ULP])
        self.assertEqual([checker.nearest_root(Fraction(x, 9)) for x in (0, 1, 18, 36)], [0, 1 / 3, 2 ** 0.5, 2])

    def test_subnormal_roots(self):
        tiny = Fraction(TINY)
        self.assertEqual([checker.nearest_root((k * tiny / 2) ** 2) for k in range(1, 6)],
                         [0, TINY, 2 * TINY, 2 * TINY, 2 * TINY])
        self.assertEqual(checker.nearest_root((tiny / 2) ** 2 + tiny ** 9), TINY)
        self.assertEqual(checker.nearest_root(2 * tiny ** 2), TINY)
        self.assertEqual(checker.nearest_root(3 * tiny ** 2), 2 * TINY)

    def test_beyond_the_doubles(self):
        limit = Fraction(2 ** 1024 - 2 ** 970)  # between the largest double and 2^1024, which is even
        below = limit - Fraction(1, 3)
        self.assertEqual([checker.nearest_double(x) for x in (below, limit, -limit)], [HUGE, None, None])
        self.assertEqual([checker.nearest_root(x) for x in (limit ** 2 - 1, limit ** 2)], [HUGE, None])

    def test_subnormal_doubles_and_no_minus_zero(self):
        tiny = Fraction(TINY)
        self.assertEqual([checker.nearest_double(k * tiny / 2) for k in (1, 3, 5)], [0, 2 * TINY, 2 * TINY])
        self.assertEqual(str(checker.nearest_double(-tiny / 2)), "0.0")
        self.assertEqual(json.dumps(judge((-0.0, -0.0, -0.0), 0)["point"]), "[0.0, 0.0, 0.0]")

    def test_normals_and_depths(self):
        third, half = 0.5773502691896257, math.sqrt(0.5)
        for center, radius, normal, depth in (
                ((1, 1, 2), 2, [0, 0, 1], 0), ((1, 1, -2), 3, [0, 0, -1], 1), ((1, 1, 0), 1, [0, 0, 1], 1),
                ((4, 4, 0), 0, [0, 0, 1], 0), ((0, 1, 0), 0, [0, 0, 1], 0), ((-3, 1, 4), 1, [-0.6, 0, 0.8], -4),
                ((5, 5, 1), 2, [third, third, third], 0.2679491924311227), ((1, -1, -1), 0, [0, -half, -half], -math.sqrt(2)),
                ((1, 1, TINY), 0, [0, 0, 1], -TINY), ((-TINY, -TINY, 0), TINY, [-half, -half, 0], 0)):
            verdict = judge(center, radius)
            self.assertEqual((verdict["contact_normal"], verdict["depth"]), (normal, depth), center)
        self.assertEqual(judge((1, 1, 0), 0, SQUARE[::-1])["contact_normal"], [0, 0, -1])
        self.assertEqual(judge((HUGE, HUGE, 0), 0, SQUARE)["depth"], None)

    def test_point_rounds_to_nearest(self):
        # The foot of (1, 0, 0) on the line y = 3x is (0.1, 0.3).
        self.assertEqual(judge((1, 0, 0), 1, [[0, 0, 0], [1, 3, 0], [0, 3, 0]])["point"], [0.1, 0.3, 0])

    def test_a_distance_beyond_the_doubles_is_null(self):
        far = judge((HUGE, HUGE, HUGE), HUGE, [[-HUGE, 0, 0], [-HUGE, 1, 0], [-HUGE, 0, 1]])
        self.assertEqual((far["distance"], far["relation"], far["point"]), (None, "separate", [-HUGE, 0.5, 0.5]))

    def test_displacements_and_points_beyond_the_doubles_are_null(self):
        # In units of HUGE: N = (-2, -1, -1), g = (-1/4, 0, 0), the plane is 2x + y + z = -1/2, displacements are 5/4.
        dart = [[0, HUGE, HUGE], [-HUGE, 0, -HUGE], [HUGE, 0, 0], [-HUGE, -HUGE, 0]]
        # The foot of (-1, 1, 1) is (-7/6, 11/12, 11/12).
        verdict, y = judge((-HUGE, HUGE, HUGE), 1, dart), float(Fraction(HUGE) * 11 / 12)
        self.assertEqual((verdict["nearest"], verdict["off_plane"], verdict["point"]), (FACE, None, [None, y, y]))
        self.assertEqual(verdict["distance"], checker.nearest_root(Fraction(HUGE) ** 2 / 24))


class Rejections(unittest.TestCase):
    def test_not_json_is_no_verdict(self):
        for line in ("", "{", "{} {}", "nope", text(radius=float("nan")), text(radius=float("-inf")), '{"a":01}', b'"\xff"',
                     '{"a":1,}'):
            self.assertIsNone(checker.judge_case(line), line)

    def test_malformed(self):
        for line in (
                "[]", "3", "null", "{}", '{"id":"a"}', '"a"', "1e400", text(center=[1, 2]), text(center=[1, 2, 3, 4]),
                text(center="0"), text(center=[1, 2, True]), text(radius="1"), text(radius=None), text(radius=False),
                text(outer={}), text(outer=[1, 2, 3]), text(outer=[*SQUARE, [1, 2]]), text(outer=[*SQUARE, [1, 2, None]]),
                text(holes=[3]), text(holes=[[[0]]]), text(holes=SQUARE), text().replace("[]", "null"), text(expected=[]),
                text(expected=None), text(expected={"contacts": True}), text(tags="a"), text(id=3),
                text().replace('"radius"', '"r"'), text().replace('"id"', '"name"'), text().replace('"outer"', '"inner"')):
            self.assertEqual(checker.judge_case(line)["error"], "malformed-case", line)

    def test_duplicate_keys_at_any_depth(self):
        for old, new in (
                ('"id"', '"id": "a", "id"'), ('"radius"', '"radius": 1, "radius"'),
                ('"radius"', '"radiu\\u0073": 1, "radius"'), ('"id"', '"note": [{"x": 1, "x": 1}], "id"'),
                ('"id"', '"expected": {"nearest": {"kind": 1, "kind": 1}}, "id"')):
            self.assertEqual(checker.judge_case(text().replace(old, new)), {"id": "a", "error": "malformed-case"}, new)

    def test_optional_keys(self):
        self.assertIsNone(checker.judge_case(text().replace(', "holes": []', "")).get("error"))
        self.assertIsNone(code(expected={"error": True}, tags=["x"]))
        self.assertIsNone(code(expected={"distance": 1, "point": [0, 0, 0]}))

    def test_loops_that_are_closed(self):
        def closed(outer, says=True):
            case = json.loads(text(outer=outer))
            case["polygon"]["closed"] = says
            return checker.judge_case(json.dumps(case))
        self.assertEqual(closed([*SQUARE, SQUARE[0]]), checker.judge_case(text(outer=SQUARE)))
        self.assertEqual(closed([*SQUARE, SQUARE[0]], False)["error"], "repeated-vertex")
        for outer, says in (SQUARE, True), ([], True), (SQUARE[:1], True), (SQUARE, 1), (SQUARE, None):
            self.assertEqual(closed(outer, says)["error"], "malformed-case")

    def test_id_of_a_malformed_case(self):
        self.assertEqual(checker.judge_case('{"id": "x"}')["id"], "x")
        self.assertIsNone(checker.judge_case('{"id": 5}')["id"])

    def test_not_finite(self):
        for number in ("1e400", "-1e400", "1.7976931348623159e308", "1" + "0" * 309):
            self.assertEqual(checker.judge_case(text(radius=77).replace("77", number))["error"], "not-finite")
        self.assertIsNone(checker.judge_case(text(radius=77).replace("77", "1.7976931348623158e308")).get("error"))
        self.assertIsNone(checker.judge_case(text(radius=77).replace("77", "-1e-400")).get("error"))

    def test_negative_radius(self):
        self.assertEqual(code(radius=-TINY), "negative-radius")

    def test_too_few_vertices(self):
        self.assertEqual(code(outer=SQUARE[:2]), "too-few-vertices")
        self.assertEqual(code(outer=[]), "too-few-vertices")
        self.assertEqual(code(holes=[[]]), "too-few-vertices")

    def test_repeated_vertex(self):
        self.assertEqual(code(outer=[*SQUARE, [0, 4, -0.0]]), "repeated-vertex")
        self.assertEqual(code(outer=[*SQUARE, [0, 0, 0]]), "repeated-vertex")
        self.assertEqual(code(holes=[[[1, 1, 0], [1, 1, 0], [2, 1, 0], [1, 2, 0]]]), "repeated-vertex")

    def test_zero_normal(self):
        self.assertEqual(code(outer=[[0, 0, 0], [1, 1, 1], [3, 3, 3]]), "zero-normal")
        self.assertEqual(code(outer=[[0, 0, 0], [8, 8, 0], [8, 0, 0], [0, 8, 0]]), "zero-normal")
        self.assertIsNone(code(outer=[[0, 0, 0], [TINY, 0, 0], [0, TINY, 0]]))
        self.assertEqual(code(outer=[[0, 0, 0], [0.1, 0.1, 0], [0.3, 0.3, 0]]), "zero-normal")

    def test_loop_meets_itself(self):
        for name, hole in (
                ("crossing", [[1, 1, 0], [3, 3, 0], [3, 1, 0], [1, 3, 0]]),
                ("spike", [[1, 1, 0], [3, 1, 0], [2, 1, 0], [2, 2, 0]]),
                ("collinear triangle", [[1, 1, 0], [2, 2, 0], [3, 3, 0]]),
                ("edge becomes a point", [[1, 1, 0], [3, 1, 0], [3, 1, 1], [2, 3, 0]]),
                ("crossing at a vertex", [[1, 1, 0], [3, 1, 0], [3, 2, 0], [2, 1, 0], [1, 0.5, 0]]),
                ("crossing at two vertices", [[1, 1, 0], [2, 2, 0], [3, 3, 0], [3, 1, 0], [2, 2, 5], [1, 3, 0]])):
            self.assertEqual(code(holes=[hole]), "loop-meets-itself", name)
            self.assertEqual(code(holes=[hole[::-1]]), "loop-meets-itself", name)

    def test_loops_may_touch(self):
        for name, hole in (
                ("vertex on an edge", [[1, 1, 0], [3, 1, 0], [3, 2, 0], [2, 1, 0], [1, 2, 0]]),
                ("vertex on a vertex", [[1, 1, 0], [2, 2, 0], [3, 1, 0], [3, 3, 0], [2, 2, 5], [1, 3, 0]]),
                ("at the outline", [[0, 1, 0], [1, 1, 0], [1, 2, 0]]), ("at a corner", [[0, 0, 0], [1, 2, 0], [2, 1, 0]]),
                ("at four edges", [[2, 0, 0], [4, 2, 0], [2, 4, 0], [0, 2, 0]])):
            self.assertIsNone(code(holes=[hole]), name)
            self.assertIsNone(code(holes=[hole[::-1]]), name)
        small = [[1, 1, 0], [2, 1, 0], [1, 2, 0]]
        self.assertIsNone(code(holes=[small, [[2, 1, 0], [3, 1, 0], [3, 2, 0]]]))
        self.assertIsNone(code(holes=[small, [[1, 1, 0], [1.5, 1.25, 0], [1.25, 1.5, 0]]]), "an island")
        self.assertEqual(code(holes=[[[4, 1, 0], [6, 1, 0], [6, 2, 0]]]), "hole-outside")

    def test_straight_runs_are_legal(self):
        self.assertIsNone(code(outer=[[0, 0, 0], [1, 0, 0], [2, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [0, 1, 0]]))

    def test_loops_meet(self):
        small = [[1, 1, 0], [2, 1, 0], [1, 2, 0]]
        for name, holes in (
                ("crossing at a vertex", [[[0, 1, 0], [1, 1, 0], [-1, 2, 0]]]), ("twice the same", [small, small]),
                ("crossing at a shared vertex", [small, [[2, 1, 0], [1.25, 1.25, 0], [3, 2, 0]]]),
                ("crossing", [[[1, 1, 0], [9, 1, 0], [1, 2, 0]]]),
                ("overlap", [[[0, 1, 0], [0, 2, 0], [1, 2, 0]]]),
                ("at different heights", [[[-1, 1, 7], [1, 1, 9], [1, 2, 3]]])):
            self.assertEqual(code(holes=holes), "loops-meet", name)

    def test_hole_outside(self):
        self.assertEqual(code(holes=[[[9, 9, 0], [10, 9, 0], [9, 10, 0]]]), "hole-outside")
        self.assertEqual(code(holes=[FRAME]), "hole-outside")
        notch = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 1, 0], [0, 4, 0]]
        self.assertEqual(code(outer=notch, holes=[[[1.9, 3, 0], [2.1, 3, 0], [2, 2.9, 0]]]), "hole-outside")

    def test_the_first_code_that_applies(self):
        two, twice = [[1, 1, 0], [2, 2, 0]], [[1, 1, 0], [1, 1, 0], [2, 1, 0]]
        line, bow = [[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[1, 1, 0], [3, 3, 0], [3, 1, 0], [1, 3, 0]]
        meets, away = [[0, 1, 0], [1, 1, 0], [0, 2, 0]], [[9, 9, 0], [10, 9, 0], [9, 10, 0]]
        huge = text(radius=-77, outer=line).replace("77", "1e400")
        self.assertEqual(checker.judge_case(huge.replace('"id"', '"di"'))["error"], "malformed-case")
        self.assertEqual(checker.judge_case(huge)["error"], "not-finite")
        self.assertEqual(code(radius=-1, outer=two), "negative-radius")
        self.assertEqual(code(outer=twice, holes=[two]), "too-few-vertices")
        self.assertEqual(code(outer=line, holes=[twice]), "repeated-vertex")
        self.assertEqual(code(outer=line, holes=[bow]), "zero-normal")
        self.assertEqual(code(holes=[meets, away, bow]), "loop-meets-itself")
        self.assertEqual(code(holes=[away, meets]), "loops-meet")
        self.assertEqual(code(holes=[away, away]), "loops-meet")


def first(start, radius, end, outer=SQUARE, holes=()):
    """The first contact of a moving ball: first, time, momentary, feature, point."""
    verdict = judge(start, radius, outer, holes, motion={"to": end})
    return tuple(verdict[key] for key in ("first", "time", "momentary", "feature", "point"))


NONE = "none", None, None, None, None


class Moving(unittest.TestCase):
    def test_falls_on_the_face(self):
        self.assertEqual(first((2, 2, 5), 1, (2, 2, -5)), ("way", 0.4, False, FACE, [2, 2, 0]))
        self.assertEqual(first((2, 2, 5), 1, (2, 2, 1)), ("way", 1, False, FACE, [2, 2, 0]))
        self.assertEqual(first((2, 2, 5), 1, (2, 2, 1 + ULP)), NONE)
        self.assertEqual(first((2, 2, 1), 1, (2, 2, 5)), ("start", 0, None, FACE, [2, 2, 0]))
        self.assertEqual(first((2, 2, 2), 1, (2, 2, 2)), NONE)

    def test_grazes(self):
        self.assertEqual(first((-1, 2, -4), 1, (-1, 2, 4)), ("way", 0.5, True, edge(3), [0, 2, 0]))
        self.assertEqual(first((-1, 2, -4), 1 - ULP / 2, (-1, 2, 4)), NONE)
        self.assertEqual(first((-1, 2, -4), 1 + ULP, (-1, 2, 4))[:3:2], ("way", False))
        self.assertEqual(first((-3, -4, -8), 5, (-3, -4, 8)), ("way", 0.5, True, vertex(0), [0, 0, 0]))
        self.assertEqual(first((-3, -4, -8), 5, (-3, -4, 0)), ("way", 1, True, vertex(0), [0, 0, 0]))

    def test_points_pass_through(self):
        self.assertEqual(first((2, 2, 4), 0, (2, 2, -4)), ("way", 0.5, True, FACE, [2, 2, 0]))
        self.assertEqual(first((4, 2, 4), 0, (4, 2, -4)), ("way", 0.5, True, edge(1), [4, 2, 0]))
        self.assertEqual(first((-4, 0, 0), 0, (4, 0, 0)), ("way", 0.5, False, vertex(0), [0, 0, 0]))

    def test_normals_and_depths(self):
        for start, radius, end, normal, depth in (
                ((2, 2, 5), 1, (2, 2, -5), [0, 0, 1], 0), ((2, 2, -5), 1, (2, 2, 5), [0, 0, -1], 0),
                ((2, 2, 4), 0, (2, 2, -4), [0, 0, 1], 0), ((4, 2, -4), 0, (4, 2, 4), [0, 0, -1], 0),
                ((-4, 0, 0), 0, (4, 0, 0), [0, 0, 1], 0), ((-1, 2, -4), 1, (-1, 2, 4), [-1, 0, 0], 0),
                ((-3, -4, -8), 5, (-3, -4, 8), [-0.6, -0.8, 0], 0), ((2, 2, -1), 3, (9, 9, 9), [0, 0, -1], 2),
                ((-3, -1, 0), 2, (1, -1, 0), [-0.8660254037844386, -0.5, 0], 0), ((2, 2, 5), 1, (2, 2, 4), None, None)):
            verdict = judge(start, radius, motion={"to": end})
            self.assertEqual((verdict["contact_normal"], verdict["depth"]), (normal, depth), start)

    def test_slides(self):
        self.assertEqual(first((-4, 2, 1), 1, (4, 2, 1)), ("way", 0.5, False, edge(3), [0, 2, 0]))
        self.assertEqual(first((-4, -4, 1), 1, (4, 4, 1)), ("way", 0.5, False, vertex(0), [0, 0, 0]))
        self.assertEqual(first((-4, 4, 1), 1, (4, -4, 1)), ("way", 0.5, True, vertex(0), [0, 0, 0]))
        self.assertEqual(first((-4, -1, 0), 1, (4, -1, 0)), ("way", 0.5, False, vertex(0), [0, 0, 0]))

    def test_a_hole_just_so(self):
        hole = [[1, 1, 0], [3, 1, 0], [3, 3, 0], [1, 3, 0]]
        self.assertEqual(first((2, 2, 4), 1, (2, 2, -4), holes=[hole]), ("way", 0.5, True, edge(4), [2, 1, 0]))
        self.assertEqual(first((2, 2, 4), 1 - ULP / 2, (2, 2, -4), holes=[hole]), NONE)

    def test_irrational_times_are_rounded(self):
        self.assertEqual(first((-3, -1, 0), 2, (1, -1, 0))[1], 0.3169872981077807)  # (3 - sqrt 3) / 4

    def test_times_that_round_to_the_ends(self):
        self.assertEqual(first((2, 2, 1 + ULP), 1, (2, 2, -HUGE))[:2], ("way", 0))
        self.assertEqual(first((2, 2, 2.0 ** 60), 1, (2, 2, 0))[:2], ("way", 1))

    def test_lifted(self):
        self.assertEqual(first((2, 2, 5), 0, (2, 2, -3), [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 4]]),
                         ("way", 0.5, True, FACE, [2, 2, 1]))

    def test_rejections(self):
        for motion in (None, 3, [], {}, {"to": None}, {"to": [1, 2]}, {"to": [1, 2, "3"]}):
            self.assertEqual(code(motion=motion), "malformed-case", motion)
        self.assertEqual(checker.judge_case(text(motion={"to": [77, 0, 0]}).replace("77", "1e400"))["error"], "not-finite")


class Meshes(unittest.TestCase):
    VERTICES = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [0, 1, 1], [2, 1, 1], [1, 3, 0]]
    RIDGE = [[0, 1, 5, 4], [4, 5, 2, 3]]

    def judge(self, faces, center=(1, 1, 3), radius=2, **more):
        case = {"id": "a", "ball": {"center": center, "radius": radius}, "mesh": {"vertices": self.VERTICES, "faces": faces}}
        return checker.judge_case(json.dumps({**case, **more}))

    def test_the_keys_are_those_of_the_nearest_face_and_two_more(self):
        verdict = self.judge(self.RIDGE)
        self.assertEqual((verdict["face"], verdict["touched"], verdict["nearest"]), (0, [0, 1], edge(2)))
        self.assertFalse(set(verdict) & set(checker.POLYGON_KEYS))
        self.assertEqual(self.judge(self.RIDGE, (1, 9, 0), 1)["face"], 1)

    def test_triangles_come_first_among_equals(self):
        self.assertEqual(self.judge([*self.RIDGE, [5, 4, 6]])["face"], 2)

    def test_the_first_face_of_a_moving_ball(self):
        verdict = self.judge(self.RIDGE, (1, 1.9, 5), 1, motion={"to": [1, 1.9, -5]})
        self.assertEqual((verdict["first"], verdict["face"], verdict["touched"]), ("way", 1, [0, 1]))
        verdict = self.judge(self.RIDGE, (9, 9, 9), 1, motion={"to": [9, 9, 8]})
        self.assertEqual((verdict["first"], verdict["face"], verdict["touched"]), ("none", None, []))

    def test_posed_vertices_are_rounded_once(self):
        verdict = self.judge([[0, 1, 2]], (1, -1, 1), 0, pose={"rotation": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "translation": [0.1, 0, 0]})
        self.assertEqual(verdict["point"], [0.1, 0, 0])
        third = self.judge([[0, 1, 2]], (5, -1, 1), 0, pose={"rotation": [[1 / 3, 0, 0], [0, 1, 0], [0, 0, 1]], "translation": [0.1, 0, 0]})
        self.assertEqual(third["point"], [surd.nearest_double(2 * Fraction(1 / 3) + Fraction(0.1)), 0, 0])

    def test_rejections(self):
        self.assertEqual(self.judge([[0, 1, 7]])["error"], "malformed-case")
        self.assertEqual(self.judge([[0, 1, 0.5]])["error"], "malformed-case")
        self.assertEqual(self.judge([])["error"], "malformed-case")
        self.assertEqual(self.judge([[0, 1]])["error"], "too-few-vertices")
        self.assertEqual(self.judge([[0, 1, 2]], radius=-1)["error"], "negative-radius")
        flat = {"rotation": [[1, 0, 0], [1, 0, 0], [0, 0, 1]]}
        self.assertEqual(self.judge([[0, 1, 2]], pose=flat)["error"], "repeated-vertex")
        self.assertEqual(self.judge([[0, 1, 2]], pose={"translation": [1e308, 0, 0], "rotation": [[1e308, 0, 0], [0, 1, 0], [0, 0, 1]]})["error"],
                         "not-finite")


class Surds(unittest.TestCase):
    def test_order(self):
        golden, two = surd.Surd(Fraction(1, 2), Fraction(1, 2), 5), surd.Surd(0, 1, 2)
        self.assertTrue(two < golden < surd.Surd(0, 1, 3) and golden * golden == golden + 1 and golden > 1.5)
        self.assertEqual(surd.compare(surd.Surd(0, 1, 8), surd.Surd(0, 2, 2)), 0)
        self.assertEqual(surd.compare(surd.Surd(0, 1, 2), surd.Surd(Fraction(10 ** 30), 1, 3)), -1)
        self.assertEqual(surd.compare(surd.Surd(1, -1, 2), surd.Surd(-1, 1, 2)), -1)
        self.assertEqual(surd.compare(surd.Surd(0, 1, 4), 2), 0)
        for n in (10, 10 ** 9, 10 ** 40):  # (1 + sqrt(n n + 1))^2 is n n + 2 n + 2 and about 1 / n
            self.assertEqual(surd.compare(surd.Surd(1, 1, n * n + 1), surd.Surd(0, 1, n * n + 2 * n + 3)), -1)
            self.assertEqual(surd.compare(surd.Surd(1, 1, n * n + 1), surd.Surd(0, 1, n * n + 2 * n + 2)), 1)

    def test_rounding(self):
        self.assertEqual(surd.nearest_double(surd.Surd(0, 1, 2)), math.sqrt(2))
        self.assertEqual(surd.nearest_double(surd.Surd(10 ** 40, -1, 10 ** 80 - 1)), 5e-41)
        self.assertIsNone(surd.nearest_double(surd.Surd(0, 10 ** 308, 5)))

    def test_between(self):
        low, high = surd.Surd(0, 1, 2), surd.Surd(Fraction(1, 10 ** 50), 1, 2)
        self.assertTrue(low < surd.between(low, high) < high)


class Comparing(unittest.TestCase):
    def compare(self, cases, verdicts):
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, name) for name in ("cases", "verdicts")]
            for path, lines in zip(paths, (cases, verdicts)):
                with open(path, "w", encoding="utf-8") as file:
                    file.write("\n".join(lines))
            out = io.StringIO()
            return checker.compare(*paths, "exact", out), out.getvalue()

    def verdict(self, **changes):
        return json.dumps({**judge(), "method": "exact", **changes})

    def test_agreement_skips_blank_lines_and_lines_that_are_not_json(self):
        error = '{"id":null,"method":"exact","error":"malformed-case","message":"case: no id"}'
        agree, output = self.compare([text(), " \t", "NaN", "{}"], [self.verdict(), error])
        self.assertTrue(agree, output)
        self.assertTrue(output.endswith("2 cases compared, 1 of them rejects: no differences\n"), output)

    def test_every_key_is_compared(self):
        for change in (
                {"id": "b"}, {"method": "fast"}, {"plane": "behind"}, {"plane_tangent": 1}, {"foot": "outside"},
                {"edges_hit": [0, 3, 1]}, {"relation": "separate"}, {"contact": False}, {"point": [1, 1, 5e-324]},
                {"nearest": {"kind": "face", "index": 0}}, {"distance": 1 + ULP}, {"contact_normal": [0, 0, -1]},
                {"depth": TINY}, {"off_plane": None}, {"off_plane": -0.0},
                {"new": 1}):
            self.assertFalse(self.compare([text()], [self.verdict(**change)])[0], change)
        self.assertTrue(self.compare([text()], [self.verdict(point=[1.0, 1, 0], stage="integers", margin=3)])[0])

    def test_missing_or_extra_verdicts(self):
        self.assertFalse(self.compare([text(), text()], [self.verdict()])[0])
        self.assertFalse(self.compare([text()], [self.verdict()] * 2)[0])
        self.assertFalse(self.compare([], [])[0])
        self.assertFalse(self.compare([text()], ["nonsense"])[0])

    def test_errors_need_the_code_and_a_message(self):
        for error, agree in (
                ({"error": "negative-radius", "message": "case a: ..."}, True), ({"error": "negative-radius"}, False),
                ({"error": "negative-radius", "message": ""}, False), ({"error": "zero-normal", "message": "x"}, False)):
            verdict = json.dumps({"id": "a", "method": "exact", **error})
            self.assertEqual(self.compare([text(radius=-1)], [verdict])[0], agree, error)

    def test_at_most_twenty_differences_are_shown(self):
        output = self.compare([text()] * 30, [self.verdict(foot="outside")] * 30)[1].splitlines()
        self.assertEqual((len(output), output[20]), (22, "... 10 differences more"))


class UnseenCases(unittest.TestCase):
    def test_families_get_what_they_promise(self):
        for i in range(400):
            line = unseen_cases.case_line(7, i)
            verdict, case = checker.judge_case(line), json.loads(line)
            if verdict.get("error") == "malformed-case":
                continue
            for key, value in case.get("expected", {}).items():
                self.assertEqual(verdict.get(key), value, line)

    def test_a_case_depends_on_seed_and_number_alone(self):
        self.assertEqual(unseen_cases.case_line(3, 5), unseen_cases.case_line(3, 5))
        self.assertNotEqual(unseen_cases.case_line(3, 5), unseen_cases.case_line(4, 5))


if __name__ == "__main__":
    unittest.main()
