# SPDX-License-Identifier: GPL-3.0-or-later
"""The module of Python gives the answers of C++, takes arrays as they lie, and names what it refuses."""

import contextlib
import copy
import decimal
import fractions
import gc
import io
import json
import math
import pathlib
import pickle
import re
import sys
import threading
import types
import unittest

import numpy as np
import touchstone_contact as touchstone

CORPUS = pathlib.Path(__file__).parents[2] / "corpus"
SQUARE = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]
PATHS = (touchstone.filtered, touchstone.exact, touchstone.fast)


def corpus():
    for file in sorted(CORPUS.glob("*.jsonl")):
        for line in file.read_text().splitlines():
            yield json.loads(line)


def parts(case):
    ball, polygon = case["ball"], case["polygon"]
    return [*ball["center"], ball["radius"]], polygon["outer"], polygon.get("holes", [])


def rejection_of(make):
    try:
        make()
    except touchstone.Rejected as rejected:
        return rejected.code
    return None


def random_balls(count):
    random = np.random.default_rng(2026)
    return np.column_stack([random.uniform(-2, 6, (count, 2)), random.uniform(-2, 2, count), random.uniform(0, 2, count)])


class Answers(unittest.TestCase):
    def test_are_those_of_the_corpus(self):
        asked = 0
        for case in corpus():
            expected = case["expected"]
            if "error" in expected or "motion" in case:  # the module does not know moving balls
                continue
            ball, outer, holes = parts(case)
            polygon = touchstone.Polygon(outer, holes)
            for path in (touchstone.filtered, touchstone.exact):
                verdict = path.answer(ball, polygon).verdict()
                # A value beyond the finite doubles is null in a verdict.
                finite = json.loads(json.dumps(verdict), parse_constant=lambda _: None)
                self.assertEqual({key: finite[key] for key in expected}, expected, case["id"])
                asked += 1
        self.assertGreater(asked, 500)

    def test_of_single_questions_are_the_keys_of_the_whole_answer(self):
        square = touchstone.Polygon(SQUARE, [[[1, 1, 0], [3, 1, 0], [3, 3, 0], [1, 3, 0]]])
        for path in PATHS:
            for ball in random_balls(50):
                answer = path.answer(ball, square)
                self.assertEqual(path.contact(ball, square), answer.contact)
                self.assertEqual(path.relation(ball, square), answer.relation)
                self.assertEqual(path.plane_side(ball, square), answer.plane)
                self.assertEqual(path.foot(ball, square), answer.foot)
                self.assertEqual(path.edges_hit(ball, square).tolist(), answer.edges_hit)
                point, distance = path.closest(ball, square)
                self.assertEqual((point.tolist(), distance), (answer.point.tolist(), answer.distance))

    def test_have_the_normal_and_the_depth_of_the_contact(self):
        square, scene = touchstone.Polygon(SQUARE), touchstone.Scene()
        scene.add("square", square)
        for path in PATHS:
            for ball, normal, depth in (([2, 2, 1, 3], [0, 0, 1], 2), ([2, 2, -1, 0.5], [0, 0, -1], -0.5),
                                        ([-3, 2, 4, 5], [-0.6, 0, 0.8], 0), ([2, 2, 0, 1], [0, 0, 1], 1)):
                answer, start = path.answer(ball, square), path.first_contact([*ball, *ball[:3]], square)
                nearest = scene.nearest(ball)
                for thing in (answer, nearest, start) if answer.contact else (answer, nearest):
                    self.assertEqual((thing.contact_normal.tolist(), thing.depth), (normal, depth))
            way = path.first_contact([2, 2, -3, 1, 2, 2, 0], square)
            self.assertEqual((way.contact_normal.tolist(), way.depth), ([0, 0, -1], 0))

    def test_differ_where_doubles_err(self):
        triangle = touchstone.Polygon([[0, 0, 0], [3, 1, 0], [1, 3, 1]])
        balls = random_balls(2000)
        balls[:, 3] = touchstone.exact.closest(balls, triangle)[1]
        self.assertTrue((touchstone.filtered.relation(balls, triangle) == touchstone.exact.relation(balls, triangle)).all())
        self.assertFalse((touchstone.fast.relation(balls, triangle) == touchstone.exact.relation(balls, triangle)).all())


def random_motions(count):
    return np.column_stack([random_balls(count), np.random.default_rng(7).uniform(-2, 6, (count, 3))])


class MovingBalls(unittest.TestCase):
    def test_have_the_first_contacts_of_the_corpus(self):
        asked = 0
        for case in corpus():
            if "motion" not in case or "error" in case["expected"]:
                continue
            ball, outer, holes = parts(case)
            polygon, expected = touchstone.Polygon(outer, holes), case["expected"]
            for path in (touchstone.filtered, touchstone.exact):
                motion = [*ball, *case["motion"]["to"]]
                first = path.first_contact(motion, polygon)
                self.assertIs(path.contact(motion, polygon), first.contact)
                found = {"contact": first.contact, "first": first.kind, "momentary": first.momentary, "time": first.time,
                         "feature": first.feature, "point": first.point.tolist()}
                if not first.contact:
                    found |= dict.fromkeys(("time", "feature", "point"))
                if first.kind != "way":
                    found["momentary"] = None
                known = {key: value for key, value in expected.items() if key in found}
                self.assertEqual({key: found[key] for key in known}, known, case["id"])
                asked += len(known)
        self.assertGreater(asked, 500)

    def test_name_the_motion_that_is_refused(self):
        square, motions = touchstone.Polygon(SQUARE), random_motions(5)
        motions[3, 6] = np.nan
        for ask in (touchstone.filtered.contact, touchstone.exact.first_contact):
            with self.assertRaisesRegex(touchstone.Rejected, "motion 3"):
                ask(motions, square)
        with self.assertRaisesRegex(touchstone.Rejected, "n x 7"):
            touchstone.filtered.first_contact([0, 0, 0, 1], square)


class Arrays(unittest.TestCase):
    def test_that_are_not_aligned_give_the_same(self):
        def beside(array):
            bytes_of = np.zeros(array.nbytes + 1, np.uint8)
            same = bytes_of[1:].view(array.dtype).reshape(array.shape)
            same[...] = array
            self.assertFalse(same.flags.aligned)
            return same

        square = touchstone.Polygon(SQUARE)
        triangles, mesh = np.array([SQUARE[:3]], float), touchstone.Mesh(SQUARE, [[0, 1, 2, 3]])
        self.assertEqual(touchstone.Polygon(beside(np.array(SQUARE, float))), square)
        self.assertEqual(touchstone.TriangleSet(beside(triangles)), touchstone.TriangleSet(triangles))
        self.assertEqual(touchstone.Mesh(beside(np.array(SQUARE, float)), beside(np.array([[0, 1, 2, 3]]))), mesh)

    def test_that_are_returned_outlive_what_they_came_from(self):
        def point():
            return touchstone.exact.answer([9, 9, 9, 1], touchstone.Polygon(SQUARE)).point

        kept = point()
        gc.collect()
        self.assertEqual(kept.tolist(), [4, 4, 0])
        with self.assertRaises(ValueError):
            kept[0] = 1

    def test_of_a_polygon_are_its_loops(self):
        hole = [[1, 1, 0], [1, 2, 0], [2, 1, 0]]
        polygon = touchstone.Polygon(np.array(SQUARE), (hole,))
        self.assertEqual(polygon.outer.tolist(), SQUARE)
        self.assertEqual([h.tolist() for h in polygon.holes], [hole])


class Refusals(unittest.TestCase):
    def refused(self, code, words, make):
        with self.assertRaises(touchstone.Rejected) as caught:
            make()
        self.assertIsInstance(caught.exception, ValueError)
        self.assertEqual(caught.exception.code, code)
        self.assertIn(words, str(caught.exception))

    def test_have_the_codes_of_the_corpus(self):
        refusals = 0
        for case in corpus():
            if "error" not in case["expected"] or case["expected"]["error"] in ("malformed-case", True):
                continue
            if "motion" in case:  # the module does not know moving balls
                continue
            try:
                ball, outer, holes = parts(case)
            except KeyError:
                continue
            # A ball and a polygon are refused apart; a case that holds two faults has the code of one of them.
            codes = [rejection_of(lambda: touchstone.filtered.contact(ball, touchstone.Polygon(SQUARE))),
                     rejection_of(lambda: touchstone.Polygon(outer, holes))]
            self.assertIn(case["expected"]["error"], codes, case["id"])
            refusals += 1
        self.assertGreater(refusals, 10)

    def test_name_the_loop_and_the_vertex(self):
        self.refused("repeated-vertex", "vertex 1", lambda: touchstone.Polygon([[0, 0, 0], [1, 0, 0], [1, 0, 0], [0, 1, 0]]))
        self.refused("not-finite", "hole 0", lambda: touchstone.Polygon(SQUARE, [[[1, 1, 0], [2, 1, np.nan], [1, 2, 0]]]))
        self.refused("loop-meets-itself", "edge", lambda: touchstone.Polygon([[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 2, 0], [-1, 1, 0]]))
        self.refused("malformed-case", "hole 1", lambda: touchstone.Polygon(SQUARE, [[[1, 1, 0], [2, 1, 0], [1, 2, 0]], [[1, 2]]]))

    def test_name_what_is_not_a_closed_ring(self):
        ring, hole = SQUARE + SQUARE[:1], [[1, 1, 0], [2, 1, 0], [1, 2, 0], [1, 1, -0.0]]
        self.assertEqual(touchstone.Polygon(ring, [hole], closed=True), touchstone.Polygon(SQUARE, [hole[:-1]]))
        self.refused("repeated-vertex", "vertex 4", lambda: touchstone.Polygon(ring))
        self.refused("malformed-case", "the outer loop is not closed: its last", lambda: touchstone.Polygon(SQUARE, closed=True))
        self.refused("malformed-case", "hole 0 is not closed", lambda: touchstone.Polygon(ring, [hole[:-1]], closed=True))
        self.refused("malformed-case", "the outer loop is not closed: it has no point", lambda: touchstone.Polygon([], closed=True))
        self.refused("not-finite", "vertex 0", lambda: touchstone.Polygon([[np.nan, 0, 0], *SQUARE[1:], [np.nan, 0, 0]], closed=True))
        self.refused("too-few-vertices", "outer loop", lambda: touchstone.Polygon([[0, 0, 0], [1, 0, 0], [0, 0, 0]], closed=True))

    def test_name_the_place_in_geojson_and_wkt(self):
        def geojson(*rings, kind="Polygon"):
            return {"type": kind, "coordinates": rings}

        ring, hole = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [1, 2], [2, 1], [1, 1]]
        expected = touchstone.Polygon(SQUARE, [[[1, 1, 0], [1, 2, 0], [2, 1, 0]]])
        shape = types.SimpleNamespace(__geo_interface__=geojson(tuple(map(tuple, ring)), hole))
        for same in (geojson(ring, hole), shape, expected, " polygon((0 0,4 0,4 4,0 4,0 0), ( 1 1 , 1 2 , 2 1 , 1 1 ) )\n",
                     "POLYGON Z ((0 0 0, 4 0 0, 4 4 0, 0 4 -0, 0 0 0), (1e0 1 0, 1 2 0, 2 1 0, 1 1 0))"):
            self.assertEqual(touchstone.Polygon.of(same), expected)
        lifted = touchstone.Polygon([[0, 0, 1], [1, 0, 1], [0, 0.1, 1]])
        for same in (geojson([[0, 0, 1], [1, 0, 1], [0, 0.1, 1], [0, 0, 1]]), "POLYGONZ((0 0 1,1 0 1,0 0.1 1,0 0 1))",
                     "POLYGON((0 0 1,1 0 1,0 .1 1,0 0 1))"):
            self.assertEqual(touchstone.Polygon.of(same), lifted)
        for words, wrong in (("expected the geometry of one Polygon, got 'MultiPolygon'", geojson(ring, kind="MultiPolygon")),
                             ("expected the geometry of one Polygon, got 'MULTIPOLYGON'", "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)))"),
                             ("no key \"type\"", {}), ("no key \"coordinates\"", {"type": "Polygon"}), ("is empty", geojson()),
                             ("hole 0 must be a list of points", geojson(ring, [1, 2])), ("hole 0 is not closed", geojson(ring, hole[:-1])),
                             ("outer loop must be a list of points, each of two", geojson([[0, 0, 0, 1]] * 4)),
                             ("hole 0 has points of 3 numbers, but the outer loop of 2", geojson(ring, [[1, 1, 5], [1, 2, 5], [2, 1, 5], [1, 1, 5]])),
                             ("hole 0: ", geojson(ring, [[1, 1], [1, 2, 0], [2, 1], [1, 1]])), ("outer loop: ", geojson([[10**400, 0]])),
                             ("\"coordinates\" of the GeoJSON must be a list", {"type": "Polygon", "coordinates": None}),
                             ("the outer loop is not closed: it has only one point", geojson([[0, 0]])),
                             ("the polygon is empty", "POLYGON EMPTY"), ("the polygon is empty", "POLYGON Z EMPTY"), ("character 8: expected '(' or 'Z', found '", "POLYGON M((0 0 1))"),
                             ("character 9: expected '(', found the end", "POLYGON Z"), ("character 10: expected a number, found 'x", "POLYGON ((x 0))"),
                             ("expected 2 numbers a point", "POLYGON ((0 0, 1 0 0, 0 1, 0 0))"),
                             ("character 14: expected 3 numbers a point", "POLYGON Z((0 0, 1 0, 0 1, 0 0))"),
                             ("character 16: expected ',' or ')', found '1", "POLYGON ((0 0 0 1, 1 0))"),
                             ("expected ',' or ')', found the end", "POLYGON ((0 0, 1 0, 0 1, 0 0)"),
                             ("expected the end, found ', ((0 0))'", "POLYGON ((0 0, 1 0, 0 1, 0 0)), ((0 0))"),
                             ("not closed", "POLYGON ((0 0, 1 0, 0 1))"), ("got 'SRID'", "SRID=4326;POLYGON ((0 0, 1 0, 0 1, 0 0))")):
            with self.assertRaisesRegex(touchstone.Rejected, re.escape(words)) as caught:
                touchstone.Polygon.of(wrong)
            self.assertEqual(caught.exception.code, "malformed-case")
        self.refused("not-finite", "vertex 1", lambda: touchstone.Polygon.of("POLYGON ((0 0, nan 0, 0 1, 0 0))"))
        self.refused("loop-meets-itself", "edge", lambda: touchstone.Polygon.of("POLYGON ((0 0, 4 3, 4 0, 0 4, 0 0))"))
        for wrong in (3, [ring], None, b"POLYGON"):
            with self.assertRaisesRegex(TypeError, "a GeoJSON dict or WKT"):
                touchstone.Polygon.of(wrong)

    def test_name_the_ball(self):
        square, balls = touchstone.Polygon(SQUARE), random_balls(9)
        balls[7, 3] = -1
        self.refused("negative-radius", "ball 7", lambda: touchstone.filtered.contact(balls, square))
        balls[5, 1] = np.inf
        self.refused("not-finite", "ball 5", lambda: touchstone.exact.answer(balls, square))
        self.refused("malformed-case", "n x 4", lambda: touchstone.fast.contact([1, 2, 3], square))
        self.refused("malformed-case", "n x 4", lambda: touchstone.fast.contact(1.0, square))
        self.refused("malformed-case", "radius of one centre must be a number", lambda: touchstone.fast.contact(([0, 0, 1], [1.0]), square))

    def test_are_type_errors_where_there_are_no_numbers(self):
        ball, loop, square = np.array([4, 0, 0, 1.0]), np.array(SQUARE), touchstone.Polygon(SQUARE)
        for words, wrong in (("complex128", lambda numbers: numbers + 1j),
                             ("<U", lambda numbers: numbers.astype(str)),
                             ("<U", lambda numbers: numbers.astype(str).tolist()),
                             ("<U", lambda numbers: "numbers"),
                             ("datetime64", lambda numbers: numbers.astype("datetime64[s]")),
                             ("masked", lambda numbers: np.ma.masked_equal(numbers, 4))):
            for ask in (lambda: touchstone.filtered.contact(wrong(ball), square), lambda: touchstone.Polygon(wrong(loop)),
                        lambda: touchstone.Polygon(SQUARE, [wrong(loop)])):
                with self.assertRaisesRegex(TypeError, words):
                    ask()
        for word, wrong in (("'4'", "4"), ("complex|1j", 4 + 1j), ("4j", np.complex128(4j)), ("None", None)):
            with self.assertRaisesRegex(TypeError, word):
                touchstone.filtered.contact([fractions.Fraction(1), wrong, 0, 1], square)
        masked = np.ma.masked_equal(ball, 4)
        for rows in ([masked, masked], (ball, masked), [4, 0, np.ma.masked, 1]):
            with self.assertRaisesRegex(TypeError, "masked"):
                touchstone.filtered.contact(rows, square)
        self.assertTrue(touchstone.filtered.contact([fractions.Fraction(4), decimal.Decimal(0), np.float32(0), True], square))
        self.assertTrue(touchstone.filtered.contact(np.ma.array(ball), square))
        with self.assertRaises(TypeError):
            touchstone.filtered.contact(ball, SQUARE)

    def test_name_the_function_its_arguments_and_what_it_was_given(self):
        ball, square, scene = [0, 0, 0, 1], touchstone.Polygon(SQUARE), touchstone.Scene()
        contact, polygon = "(balls: object, polygon: Polygon, out: object = None)", "(outer: object, holes: list[object] = [], closed: bool = False)"
        added = "(name: str, faces: object, pose: object = None, bad_faces: str = 'refuse')"
        solid = "(mesh: object) or (vertices: object, faces: object)"
        for said, ask in (
                (f"contact() has no argument 'polygn'. It takes {contact}, and was given (list, polygn: Polygon)",
                 lambda: touchstone.exact.contact(ball, polygn=square)),
                (f"contact() has no argument 'ball', 'shape'. It takes {contact}, and was given (ball: list, shape: Polygon)",
                 lambda: touchstone.fast.contact(ball=ball, shape=square)),
                (f"contact() takes {contact}, and was given (ndarray, list)", lambda: touchstone.filtered.contact(random_balls(9), SQUARE)),
                (f"contact() takes {contact}, and was given ()", touchstone.filtered.contact),
                (f"Polygon() has no argument 'close'. It takes {polygon}, and was given (list, close: bool)",
                 lambda: touchstone.Polygon(SQUARE, close=True)),
                (f"add() has no argument 'bad_face'. It takes {added}, and was given (str, Polygon, bad_face: str)",
                 lambda: scene.add("square", square, bad_face="leave out")),
                (f"add() takes {added}, and was given (int, Polygon)", lambda: scene.add(3, square)),
                (f"Solid() takes {solid}, and was given ()", touchstone.Solid),
                (f"Solid() has no argument 'points'. It takes {solid}, and was given (points: list)", lambda: touchstone.Solid(points=SQUARE)),
                ("read() has no argument 'fmt'. It takes (path: object, format: Optional[str] = None, bad_faces: str = 'refuse'), "
                 "and was given (str, fmt: str)", lambda: touchstone.Mesh.read("part.stl", fmt="stl"))):
            with self.assertRaises(TypeError) as caught:
                ask()
            self.assertEqual(str(caught.exception).replace("List[", "list["), said)  # pybind11 2.10 writes List

    def test_of_others_pass_through_unchanged(self):
        class Odd(TypeError):
            pass

        class Broken:
            def __array__(self, *_):
                raise Odd("it has none")

        for ask in (touchstone.filtered.contact, touchstone.exact.closest):
            with self.assertRaisesRegex(Odd, "^it has none$"):
                ask(Broken(), touchstone.Polygon(SQUARE))

    def test_are_value_errors_where_lists_are_nested_without_end(self):
        square, itself, deep, mutual = touchstone.Polygon(SQUARE), [], [], [[]]
        itself.append(itself)
        mutual[0].append((mutual, 1))
        for _ in range(100_000):
            deep = [deep]
        for nested in (itself, mutual, deep, [0, 0, 0, itself]):
            for ask in (lambda: touchstone.filtered.contact(nested, square), lambda: touchstone.exact.first_contact(nested, square),
                        lambda: touchstone.Polygon(nested), lambda: touchstone.Polygon(SQUARE, [nested]),
                        lambda: touchstone.TriangleSet(nested), lambda: touchstone.Mesh(nested, [[0, 1, 2]]),
                        lambda: touchstone.Scene().add("nested", nested),
                        lambda: touchstone.Scene().add("square", square, nested)):
                with self.assertRaisesRegex(ValueError, "nested more than 32 deep"):
                    ask()
            for faces in (nested, [nested]):
                with self.assertRaises((TypeError, ValueError)):
                    touchstone.Mesh(SQUARE, faces)


def one_of_each_class():
    square = touchstone.Polygon(SQUARE, [[[1, 1, 0], [1, 2, 0], [2, 1, 0]]])
    mesh = touchstone.Mesh(SQUARE, [[0, 1, 2, 3]])
    scene = touchstone.Scene()
    scene.add("square", mesh)
    first = touchstone.exact.first_contact([2.5, 3, 2, 1, 2.5, 3, 0], square)
    return [square, touchstone.exact.answer([2.5, 3, 1, 1], square), mesh, touchstone.TriangleSet([SQUARE[:3]]), scene,
            scene.nearest([5, 5, 1, 0]), first, scene.first_contact([2.5, 3, 2, 1, 2.5, 3, 0]),
            touchstone.Solid([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])]


class Uninitialised(unittest.TestCase):
    def test_objects_raise_whatever_is_done_with_them(self):
        wholes = one_of_each_class()
        public = [found for name, found in vars(touchstone).items() if not name.startswith("_")]
        classes = {kind for kind in public if isinstance(kind, type) and not issubclass(kind, (Exception, tuple, int))}
        self.assertEqual(classes, {type(whole) for whole in wholes})
        arguments = {"contact": [[0, 0, 1, 1]], "any_contact": [[0, 0, 1, 1]], "triangles_hit": [[0, 0, 1, 1]], "pose": [0],
                     "touches": [[0, 0, 1, 1]], "touched": [[0, 0, 1, 1]], "first_contact": [[0, 0, 1, 1, 0, 0, 0]], "touched_in_order": [[0, 0, 1, 1, 0, 0, 0]], "nearest": [[0, 0, 1, 1]],
                     "add": ["square", touchstone.Polygon(SQUARE)], "remove": [0], "set_pose": [0, None], "face_count": [0],
                     "face_numbers": [0], "left_out": [0], "segments": [0], "verdict": [], "locate": [[0, 0, 1]], "signed_distance": [[0, 0, 1]]}
        for whole in wholes:
            kind = type(whole)
            empty = kind.__new__(kind)
            uses = [lambda: repr(empty)]
            for name, found in vars(kind).items():
                if isinstance(found, property):
                    uses.append(lambda name=name: getattr(empty, name))
                elif name[0] != "_" and not isinstance(found, staticmethod):
                    uses.append(lambda name=name: getattr(empty, name)(*arguments[name]))
            if "__len__" in vars(kind):
                uses.append(lambda: len(empty))
            if kind is touchstone.Polygon:
                uses += [lambda ask=ask, row=row: ask(row, empty) for path in PATHS for name, ask in vars(path).items()
                         if name[0] != "_" for row in [[0, 0, 1, 1, 0, 0, 0] if name == "first_contact" else [0, 0, 1, 1]]]
            if kind not in (touchstone.Scene, touchstone.Solid):
                uses += [lambda: empty == whole, lambda: whole == empty, lambda: pickle.dumps(empty), lambda: copy.copy(empty)]
                uses.append(lambda: touchstone.Scene().add("empty", empty))
            self.assertGreater(len(uses), 2)
            for use in uses:
                with self.assertRaisesRegex(TypeError, "__init__ was not called|expected real numbers"):
                    use()


    def test_objects_of_the_base_class_cannot_be_made(self):
        base = touchstone.Polygon.__base__
        for make in (base, lambda: base.__new__(base), type("Derived", (base,), {}), lambda: copy.copy(type("D", (base,), {}))()):
            with self.assertRaisesRegex(TypeError, "cannot create"):
                make()


class LoopNamed(touchstone.Polygon):
    def __init__(self, name, outer):
        super().__init__(outer)
        self.name = name


class Pickling(unittest.TestCase):
    def test_keeps_the_class_and_the_attributes_of_a_subclass(self):
        named = LoopNamed("square", SQUARE)
        named.tags = ["flat"]
        copies = [pickle.loads(pickle.dumps(named, protocol)) for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
        for same in (*copies, copy.copy(named), copy.deepcopy(named)):
            self.assertEqual((type(same), same, same.__dict__), (LoopNamed, named, {"name": "square", "tags": ["flat"]}))
        self.assertIs(copy.copy(named).tags, named.tags)
        self.assertIsNot(copy.deepcopy(named).tags, named.tags)

    def test_keeps_the_subclass_of_every_class(self):
        for thing in one_of_each_class():
            if isinstance(thing, (touchstone.Scene, touchstone.Solid)):
                continue
            derived = type("Derived", (type(thing),), {"__slots__": ("mark",)})
            globals()["Derived"] = derived  # where `pickle` looks for it
            derived.__module__, derived.__qualname__ = __name__, "Derived"
            _, made_of, _ = thing.__reduce__()
            whole = derived(*made_of[2])
            whole.mark = 7
            for same in (pickle.loads(pickle.dumps(whole)), copy.copy(whole), copy.deepcopy(whole)):
                self.assertEqual((type(same), same, same.mark), (derived, thing, 7))
        with self.assertRaisesRegex(TypeError, "cannot pickle"):
            pickle.dumps(type("Derived", (touchstone.Scene,), {})())

    def test_refuses_numbers_that_stand_for_no_word(self):
        checked = 0
        enumerators = {touchstone.Answer: (0, 2, 4, 5), touchstone.FirstContact: (0, 3), touchstone.NearestFace: (2,)}
        for thing in one_of_each_class():
            if type(thing) not in enumerators:
                continue
            _, (_, kind, members), _ = thing.__reduce__()
            for place in enumerators[kind]:
                for number in (-1, 3, 99, 256, 2**31 - 1):
                    with self.assertRaisesRegex(ValueError, f"no value has the number {number}"):
                        kind(*members[:place], number, *members[place + 1:])
                    checked += 1
        self.assertEqual(checked, 35)

    def test_refuses_members_that_do_not_go_together(self):
        def remade(thing, **changes):
            _, (_, kind, members), _ = thing.__reduce__()
            names = NAMES[kind]
            self.assertEqual(len(names), len(members))
            return kind(*(changes.get(name, member) for name, member in zip(names, members)))

        NAMES = {touchstone.Answer: ("plane", "plane_tangent", "foot", "edges_hit", "relation", "nearest", "index", "point",
                                     "distance", "contact_normal", "depth", "off_plane"),
                 touchstone.FirstContact: ("kind", "time", "momentary", "feature", "index", "point", "contact_normal",
                                           "depth"),
                 touchstone.NearestFace: ("object", "face", "feature", "index", "point", "distance", "contact_normal",
                                          "depth"),
                 touchstone.FirstFace: ("object", "face", "contact")}
        square = touchstone.Polygon(SQUARE)
        first = lambda *motion: touchstone.exact.first_contact(motion, square)
        start, way = first(2, 2, 0.5, 1, 2, 2, 0), first(2, 2, 3, 1, 2, 2, 0)
        graze, none = first(-1, -1, 1, 1, 9, 9, 1), first(2, 2, 3, 1, 2, 2, 4)
        self.assertEqual([first.kind for first in (start, way, none)], ["start", "way", "none"])
        above = touchstone.exact.answer([2, 2, 3, 1], square)
        beside = touchstone.exact.answer([-1, 2, 0, 1], square)
        scene = touchstone.Scene()
        scene.add("square", square)
        nearest, touched = scene.nearest([2, 2, 3, 1]), scene.first_contact([2, 2, 3, 1, 2, 2, 0])
        nan, infinite = math.nan, math.inf
        for thing in (start, way, graze, none, above, beside, nearest, touched):
            self.assertEqual(remade(thing), thing)
        for thing, name, changes in (
                *((start, "time", {"time": time}) for time in (0.5, -1.0, infinite, nan)),
                *((way, "time", {"time": time}) for time in (-0.5, 1.5, infinite, nan)),
                *((none, "time", {"time": time}) for time in (0.0, 1.0, -infinite, nan)),
                (start, "momentary", {"momentary": True}), (none, "momentary", {"momentary": True}),
                (way, "feature", {"feature": 0, "index": 1}), (none, "feature", {"index": 1}), (none, "feature", {"feature": 1}),
                (none, "point", {"point": (0, 0, 1)}), (none, "contact_normal", {"contact_normal": (0, 0, 1)}),
                (none, "depth", {"depth": 1.0}), (way, "depth", {"depth": 1.0}),
                (above, "plane_tangent", {"plane_tangent": True}), (above, "relation", {"relation": 1}),
                (above, "nearest", {"index": 1}), (above, "nearest", {"nearest": 1}), (above, "nearest", {"foot": 1}),
                (beside, "nearest", {"nearest": 0, "index": 0}), (beside, "edges_hit", {"edges_hit": [1, 0]}),
                (beside, "edges_hit", {"edges_hit": [1, 1]}), (above, "distance", {"distance": -1.0}),
                (above, "off_plane", {"off_plane": -1.0}), (nearest, "feature", {"feature": 0, "index": 1}),
                (nearest, "distance", {"distance": -1.0}), (nearest, "distance", {"distance": nan}),
                (touched, "contact", {"contact": none})):
            with self.subTest(thing=thing, **changes), self.assertRaisesRegex(ValueError, rf"\A{name}: "):
                remade(thing, **changes)

    def test_makes_equal_objects_in_every_protocol(self):
        for thing in one_of_each_class():
            if isinstance(thing, (touchstone.Scene, touchstone.Solid)):
                continue
            copies = [pickle.loads(pickle.dumps(thing, protocol)) for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
            for same in (*copies, copy.copy(thing), copy.deepcopy(thing)):
                self.assertEqual(same, thing)
                self.assertEqual((type(same), repr(same)), (type(thing), repr(thing)))
                self.assertIsNot(same, thing)

    def test_is_refused_for_scenes(self):
        scene = touchstone.Scene()
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            with self.assertRaisesRegex(TypeError, "cannot pickle"):
                pickle.dumps(scene, protocol)
        for refused in (copy.copy, copy.deepcopy, lambda s: s.__reduce__(), lambda s: s.__reduce_ex__(0)):
            with self.assertRaisesRegex(TypeError, "cannot pickle"):
                refused(scene)


class FormerName(unittest.TestCase):
    """The module `touchstone`, which version 0.4 drops."""

    def test_gives_the_same_objects_with_a_warning(self):
        sys.modules.pop("touchstone", None)
        with self.assertWarnsRegex(DeprecationWarning, "import touchstone_contact instead of touchstone") as warned:
            import touchstone as former
        self.assertEqual(warned.filename, __file__)
        for name in touchstone.__all__:
            self.assertIs(getattr(former, name), getattr(touchstone, name))

    def test_loads_pickles_that_name_it(self):
        for thing in one_of_each_class():
            if isinstance(thing, (touchstone.Scene, touchstone.Solid)):
                continue
            older = pickle.dumps(thing, protocol=0).replace(b"ctouchstone_contact\n", b"ctouchstone\n")
            self.assertIn(b"ctouchstone\n", older)
            self.assertEqual(pickle.loads(older), thing)


class Equality(unittest.TestCase):
    def test_of_polygons_is_that_of_their_loops(self):
        hole = [[1, 1, 0], [1, 2, 0], [2, 1, 0]]
        square = touchstone.Polygon(SQUARE)
        self.assertEqual(square, touchstone.Polygon(np.array(SQUARE, dtype=float) * -1.0 * -1.0))
        for other in (touchstone.Polygon(SQUARE, [hole]), touchstone.Polygon(SQUARE[1:] + SQUARE[:1]), SQUARE, None):
            self.assertNotEqual(square, other)
        with self.assertRaises(TypeError):
            hash(square)


class Threads(unittest.TestCase):
    def test_may_ask_about_one_polygon_at_once(self):
        square, balls = touchstone.Polygon(SQUARE), random_balls(2000)
        expected = touchstone.exact.contact(balls, touchstone.Polygon(SQUARE)).tolist()
        found = [None] * 4

        def ask(i):
            found[i] = PATHS[i % 2].contact(balls, square).tolist()

        threads = [threading.Thread(target=ask, args=(i,)) for i in range(len(found))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [expected] * len(found))


class Page(unittest.TestCase):
    def test_prints_what_it_says(self):
        page = (pathlib.Path(__file__).parents[3] / "bindings/python/README.md").read_text()
        *samples, refused = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
        said = [line.split("# ")[1] for sample in samples for line in sample.splitlines() if line.startswith("print")]
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            for sample in samples:
                exec(sample, names)
        self.assertEqual([line.split() for line in printed.getvalue().splitlines()], [line.split() for line in said])
        self.assertGreater(len(said), 4)
        with self.assertRaises(touchstone.Rejected) as caught:
            exec("import touchstone_contact as touchstone\n" + refused, {})
        kind = f"{type(caught.exception).__module__}.{type(caught.exception).__name__}"
        self.assertIn(f"# {kind}: {caught.exception}\n", refused)


class Stubs(unittest.TestCase):
    def test_name_all_that_there_is(self):
        text = (pathlib.Path(touchstone.__file__).parent / "__init__.pyi").read_text()
        names = [name for path in PATHS for name in vars(path) if not name.startswith("_")]
        names += [n for kind in map(type, one_of_each_class()) for n in vars(kind) if not n.startswith("_")]
        for name in [*names, *touchstone.__all__]:
            self.assertRegex(text, rf"\b{name}\b")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
