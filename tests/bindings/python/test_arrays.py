# SPDX-License-Identifier: GPL-3.0-or-later
"""Batches are answered by arrays that hold the single answers bit for bit, whatever arrays ask and take the answers."""

import copy
import ctypes
import pickle
import threading
import unittest

import numpy as np
import touchstone_contact as touchstone

CODES = (touchstone.Relation, touchstone.PlaneSide, touchstone.PointLocation, touchstone.FeatureKind, touchstone.FirstContactKind)
PATHS = (touchstone.filtered, touchstone.exact, touchstone.fast)
SQUARE = touchstone.Polygon([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], [[[1, 1, 0], [3, 1, 0], [3, 3, 0], [1, 3, 0]]])
VERTICES = np.array([[x, y, z] for x in (0.0, 2) for y in (0, 2) for z in (0, 2)])
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6],
                  [0, 6, 4], [1, 5, 7], [1, 7, 3]])
# Coordinates that floats hold, so that each ball is the same in every type; the last are on vertices, edges and faces.
RANDOM = np.random.default_rng(2026)
BALLS = np.vstack([np.column_stack([RANDOM.integers(-8, 24, (60, 3)), RANDOM.integers(0, 8, 60)]) / 4.0,
                   [[0, 0, 0, 0], [2, 0, 0, 0], [2, 0.5, 0, 0], [5, 4, 0, 1], [2, 2, 1, 0.5], [2, 2, -1, 2]]])
MOTIONS = np.column_stack([BALLS, RANDOM.integers(-8, 24, (len(BALLS), 3)) / 4.0])
MOTIONS[0] = [0, 0, 0, 1, 0, 0, 0]
MOTIONS[1] = [50, 0, 0, 1, 60, 0, 0]


def scene_of_two():
    scene = touchstone.Scene()
    scene.add("cube", touchstone.Mesh(VERTICES, FACES))
    scene.add("lifted", SQUARE, pose=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 3]])
    return scene


SCENE, SET = scene_of_two(), touchstone.TriangleSet(VERTICES[FACES])
SOLID = touchstone.Solid(VERTICES, FACES)


def questions():
    """For each question about many: its name, how to ask it, the rows, and whether it takes `out`."""
    for path in PATHS:
        for name in ("contact", "relation", "plane_side", "foot", "closest", "edges_hit", "answer"):
            ask = getattr(path, name)
            yield f"{path.__name__}.{name}", lambda rows, ask=ask, **out: ask(rows, SQUARE, **out), BALLS, name not in ("edges_hit", "answer")
        yield f"{path.__name__}.first_contact", lambda rows, path=path, **out: path.first_contact(rows, SQUARE, **out), MOTIONS, True
        yield f"{path.__name__}.contact on a way", lambda rows, path=path, **out: path.contact(rows, SQUARE, **out), MOTIONS, True
    for thing, names in ((SCENE, ("touches", "touched", "nearest")), (SET, ("contact", "any_contact", "triangles_hit")), (SOLID, ("touches",))):
        for name in names:
            yield f"{type(thing).__name__}.{name}", getattr(thing, name), BALLS, name not in ("touched", "triangles_hit")
    for name in ("touches", "touched", "first_contact", "touched_in_order"):
        yield f"Scene.{name} on a way", getattr(SCENE, name), MOTIONS, name in ("touches", "first_contact")
    for name in ("locate", "signed_distance"):
        yield f"Solid.{name}", getattr(SOLID, name), BALLS[:, :3].copy(), True
    for path in PATHS:
        yield f"{path.__name__}.closest of points", lambda rows, path=path, **out: path.closest(rows, SQUARE, **out), BALLS[:, :3].copy(), True
    yield "Scene.nearest of points", SCENE.nearest, BALLS[:, :3].copy(), True


def arrays_of(answers):
    """All arrays of a result, by their names."""
    if isinstance(answers, np.ndarray):
        return {"": answers}
    arrays = {}
    for name, field in answers._asdict().items():
        arrays |= {f"{name}.{inner}": array for inner, array in arrays_of(field).items()}
    return arrays


def bits(answers):
    return {name: (array.dtype, array.shape, array.tobytes()) for name, array in arrays_of(answers).items()}


def word(codes, kind, i):
    return kind(codes[i]).name


def feature(answers, name, i):
    """The feature as a single answer has it."""
    kind, number = getattr(answers, name)[i], getattr(answers, f"{name}_index")[i]
    found = {"kind": word([kind], touchstone.FeatureKind, 0)}
    return found if found["kind"] == "face" else found | {"index": number}


class Answers(unittest.TestCase):
    def same(self, one, number):
        self.assertEqual(np.asarray(one).tobytes(), np.asarray(number).tobytes())

    def same_contact(self, first, all_of_them, i):
        self.assertEqual(first.kind, word(all_of_them.kind, touchstone.FirstContactKind, i))
        self.assertEqual(first.feature, feature(all_of_them, "feature", i))
        for name in ("time", "momentary", "point", "contact_normal", "depth"):
            self.same(getattr(first, name), getattr(all_of_them, name)[i])

    def test_are_those_of_single_questions_bit_for_bit(self):
        words = {"relation": touchstone.Relation, "plane": touchstone.PlaneSide, "foot": touchstone.PointLocation}
        for path in PATHS:
            answers, hits, closest = path.answer(BALLS, SQUARE), path.edges_hit(BALLS, SQUARE), path.closest(BALLS, SQUARE)
            found = {name: getattr(path, name)(BALLS, SQUARE) for name in ("contact", "relation", "plane_side", "foot")}
            for i, ball in enumerate(BALLS):
                one = path.answer(ball, SQUARE)
                for name, kind in words.items():
                    self.assertEqual(getattr(one, name), word(getattr(answers, name), kind, i))
                self.assertEqual(one.nearest, feature(answers, "nearest", i))
                for name in ("plane_tangent", "contact", "point", "distance", "contact_normal", "depth", "off_plane"):
                    self.same(getattr(one, name), getattr(answers, name)[i])
                for edges in (answers.edges_hit, hits):
                    self.assertEqual(edges.number[edges.indptr[i]:edges.indptr[i + 1]].tolist(), one.edges_hit)
                self.same(one.point, closest.point[i])
                self.same(one.distance, closest.distance[i])
                self.assertEqual([found["contact"][i], word(found["relation"], touchstone.Relation, i)], [one.contact, one.relation])
                self.assertEqual(word(found["plane_side"], touchstone.PlaneSide, i), one.plane)
                self.assertEqual(word(found["foot"], touchstone.PointLocation, i), one.foot)
            self.assertEqual((set(answers.relation), set(answers.foot), set(answers.nearest)), ({0, 1, 2},) * 3)
            self.assertEqual((hits.indptr[0], hits.indptr[-1]), (0, len(hits.number)))

    def test_about_ways_are_those_of_single_questions_bit_for_bit(self):
        for path in PATHS:
            firsts = path.first_contact(MOTIONS, SQUARE)
            for i, motion in enumerate(MOTIONS):
                one = path.first_contact(motion, SQUARE)
                self.assertEqual(one.contact, firsts.contact[i])
                if one.contact:
                    self.same_contact(one, firsts, i)
                    continue
                self.assertEqual((firsts.kind[i], firsts.time[i], firsts.momentary[i]), (touchstone.FirstContactKind.none, np.inf, False))
                self.assertEqual((firsts.feature[i], firsts.feature_index[i]), (-1, -1))
                self.assertTrue(np.isnan([*firsts.point[i], *firsts.contact_normal[i], firsts.depth[i]]).all())
            self.assertEqual(set(firsts.kind), {0, 1, 2})

    def test_about_scenes_are_those_of_single_questions_bit_for_bit(self):
        nearest, touched, on_way = SCENE.nearest(BALLS), SCENE.touched(BALLS), SCENE.touched(MOTIONS)
        firsts, in_order = SCENE.first_contact(MOTIONS), SCENE.touched_in_order(MOTIONS)
        for i, (ball, motion) in enumerate(zip(BALLS, MOTIONS)):
            one = SCENE.nearest(ball)
            self.assertEqual((one.object, one.face, one.feature), (nearest.object[i], nearest.face[i], feature(nearest, "feature", i)))
            for name in ("point", "distance", "contact_normal", "depth"):
                self.same(getattr(one, name), getattr(nearest, name)[i])
            for faces, row in ((touched, ball), (on_way, motion)):
                part = slice(faces.indptr[i], faces.indptr[i + 1])
                self.assertEqual(np.column_stack([faces.object[part], faces.face[part]]).tolist(), SCENE.touched(row).tolist())
            first, listed = SCENE.first_contact(motion), SCENE.touched_in_order(motion)
            self.assertEqual(firsts.contact[i], first is not None)
            places = range(in_order.indptr[i], in_order.indptr[i + 1])
            self.assertEqual(len(places), len(listed))
            for found, faces, place in [(first, firsts, i)] * (first is not None) + [(each, in_order, j) for each, j in zip(listed, places)]:
                self.assertEqual((found.object, found.face), (faces.object[place], faces.face[place]))
                self.same_contact(found.contact, faces, place)
            if first is None:
                self.assertEqual((firsts.object[i], firsts.face[i], firsts.kind[i], firsts.time[i]), (-1, -1, 2, np.inf))
        self.assertEqual({True, False}, set(firsts.contact))
        self.assertEqual({0, 1}, set(nearest.object))
        some = SCENE.nearest(BALLS, objects=["lifted"])
        self.assertEqual(set(some.object), {1})

    def test_about_sets_and_solids_are_those_of_single_questions_bit_for_bit(self):
        hits, contact, any_contact = SET.triangles_hit(BALLS), SET.contact(BALLS), SET.any_contact(BALLS)
        places, touches, distances = SOLID.locate(BALLS[:, :3]), SOLID.touches(BALLS), SOLID.signed_distance(BALLS[:, :3])
        for i, ball in enumerate(BALLS):
            self.assertEqual(hits.number[hits.indptr[i]:hits.indptr[i + 1]].tolist(), SET.triangles_hit(ball).tolist())
            self.assertEqual((contact[i].tolist(), any_contact[i]), (SET.contact(ball).tolist(), SET.any_contact(ball)))
            self.assertEqual((word(places, touchstone.PointLocation, i), touches[i]), (SOLID.locate(ball[:3]), SOLID.touches(ball)))
            self.same(SOLID.signed_distance(ball[:3]), distances[i])

    def test_with_numbers_are_of_int64_everywhere(self):
        mesh = touchstone.Mesh(VERTICES, FACES)
        singles = [SCENE.touched(BALLS[0]), SCENE.face_numbers(0), SET.triangles_hit(BALLS[0]), mesh.faces,
                   touchstone.filtered.edges_hit(BALLS[0], SQUARE), *touchstone.merge_faces(mesh).faces]
        self.assertEqual({array.dtype for array in singles}, {np.dtype(np.int64), SCENE.touched(BALLS).face.dtype})

    def test_of_no_balls_are_empty_arrays_of_the_same_types(self):
        for name, ask, rows, _ in questions():
            none, some = arrays_of(ask(rows[:0])), arrays_of(ask(rows))
            self.assertEqual({key: (array.dtype, array.shape[1:]) for key, array in none.items()},
                             {key: (array.dtype, array.shape[1:]) for key, array in some.items()}, name)
            for key, array in none.items():
                self.assertEqual(array.tolist(), [0] if key.endswith("indptr.") else [], (name, key))

    def test_without_faces_are_minus_one_and_nan(self):
        nearest = touchstone.Scene().nearest(BALLS)
        for name, array in arrays_of(nearest).items():
            self.assertTrue(np.isnan(array).all() if array.dtype == float else (array == -1).all(), name)
        self.assertEqual(set(touchstone.FeatureKind.words(nearest.feature)), {""})

    def test_about_centres_are_those_about_balls_of_radius_zero(self):
        points = BALLS[:, :3]
        self.assertEqual(bits(SCENE.nearest(points)), bits(SCENE.nearest((points, 0))))
        self.assertEqual(SCENE.nearest(points[0].tolist()), SCENE.nearest([*points[0], 0]))
        self.assertEqual(bits(touchstone.exact.closest(points, SQUARE)), bits(touchstone.exact.closest(BALLS, SQUARE)))
        for ask in (SCENE.touches, SCENE.touched, SET.contact, lambda rows: touchstone.filtered.contact(rows, SQUARE)):
            with self.assertRaisesRegex(touchstone.Rejected, "n x 4"):
                ask(points)

    def test_can_be_pickled_and_copied(self):
        for _, ask, rows, _ in questions():
            answers = ask(rows)
            for same in (pickle.loads(pickle.dumps(answers)), copy.copy(answers), copy.deepcopy(answers)):
                self.assertEqual((type(same), bits(same)), (type(answers), bits(answers)))


class Codes(unittest.TestCase):
    def test_have_words(self):
        for kind in CODES:
            names = [code.name for code in kind]
            self.assertEqual([int(code) for code in kind], [0, 1, 2])
            self.assertEqual(kind.words([[2, 0], [-1, 1]]).tolist(), [[names[2], names[0]], ["", names[1]]])
            self.assertEqual(kind.words(np.empty(0, np.int8)).shape, (0,))
            for wrong in (-2, 3):
                with self.assertRaisesRegex(ValueError, f"{kind.__name__} has no code {wrong}"):
                    kind.words([0, wrong])


class Asking(unittest.TestCase):
    def test_rows_of_every_layout_and_type_give_the_same_bits(self):
        for name, ask, rows, _ in questions():
            expected = bits(ask(rows))
            wide = np.zeros((2 * len(rows), 2 * rows.shape[1]))
            wide[::2, ::2] = rows
            beside = np.zeros(rows.nbytes + 1, np.uint8)[1:].view(float).reshape(rows.shape)
            beside[...] = rows
            self.assertFalse(beside.flags.aligned)
            read_only = rows.copy()
            read_only.setflags(write=False)
            turned = np.ascontiguousarray(rows[::-1, ::-1])[::-1, ::-1]
            self.assertLess(max(turned.strides), 0)
            for same in (np.asfortranarray(rows), wide[::2, ::2], turned, beside, read_only, rows.astype(np.float32),
                         rows.astype(">f8"), rows.astype(np.longdouble), rows.tolist()):
                before = copy.deepcopy(same)
                self.assertEqual(bits(ask(same)), expected, name)
                self.assertEqual(np.asarray(same).tobytes(), np.asarray(before).tobytes())
            repeated = np.broadcast_to(rows[5], rows.shape)
            self.assertEqual(repeated.strides[0], 0)
            self.assertEqual(bits(ask(repeated)), bits(ask(repeated.copy())), name)

    def test_buffers_and_objects_that_are_arrays_give_the_same_bits(self):
        class Array:
            def __init__(self, rows):
                self.rows = rows

            def __array__(self, dtype=None):
                return self.rows

        for name, ask, rows, _ in questions():
            expected = bits(ask(rows))
            shared = (ctypes.c_double * rows.size).from_buffer_copy(rows.tobytes())
            for same in (memoryview(rows), np.ctypeslib.as_array(shared).reshape(rows.shape), Array(rows)):
                self.assertEqual(bits(ask(same)), expected, name)
        mesh = touchstone.Mesh(VERTICES, FACES)
        for vertices, faces in ((memoryview(VERTICES), memoryview(FACES)), (Array(VERTICES), Array(FACES)),
                                (VERTICES.astype(np.float32), FACES.astype(np.int32)), (np.asfortranarray(VERTICES), np.asfortranarray(FACES)),
                                (VERTICES[::-1].copy()[::-1], FACES.astype(np.uint32)), (VERTICES.astype(">f8"), FACES.astype(">i4"))):
            self.assertEqual(touchstone.Mesh(vertices, faces), mesh)
            self.assertEqual(touchstone.TriangleSet(np.asarray(vertices)[np.asarray(faces)]), SET)

    def test_floats_are_taken_as_the_numbers_that_they_are(self):
        floats = RANDOM.uniform(-1, 5, (100, 4)).astype(np.float32)
        floats[:, 3] = np.abs(floats[:, 3])
        exact = np.array([[float(number) for number in row] for row in floats])
        self.assertEqual(bits(SCENE.nearest(floats)), bits(SCENE.nearest(exact)))
        self.assertEqual(bits(SCENE.nearest((floats[:, :3], floats[:, 3]))), bits(SCENE.nearest(exact)))

    def test_rows_of_another_shape_or_type_are_refused(self):
        for name, ask, rows, _ in questions():
            for wrong in (rows[None], rows[:, :2], np.empty((0,)), np.float64(1), np.empty((3, 8))):
                with self.assertRaisesRegex(touchstone.Rejected, "must be", msg=name):
                    ask(wrong)
            for wrong in (rows.astype(complex), rows.astype(str), np.ma.masked_equal(rows, 0)):
                with self.assertRaises(TypeError, msg=name):
                    ask(wrong)


def emptied(answers):
    """The same arrays with other content, to be written to."""
    others = [np.full_like(array, 1) for array in arrays_of(answers).values()]
    return others[0] if isinstance(answers, np.ndarray) else type(answers)(*others)


class Out(unittest.TestCase):
    def test_takes_the_answers_and_is_returned(self):
        for name, ask, rows, takes_out in questions():
            if not takes_out:
                with self.assertRaises(TypeError):
                    ask(rows, out=None)
                continue
            expected = ask(rows)
            out = emptied(expected)
            found = ask(rows, out=out)
            for given, returned in zip(arrays_of(out).values(), arrays_of(found).values()):
                self.assertIs(given, returned)
            self.assertEqual(bits(found), bits(expected), name)

    def test_may_be_a_part_of_a_larger_array(self):
        wide = np.ones((3, len(BALLS)), dtype=bool)
        SCENE.touches(BALLS, out=wide[1])
        self.assertEqual(wide[1].tolist(), SCENE.touches(BALLS).tolist())
        self.assertTrue(wide[[0, 2]].all())

    def test_is_refused_and_left_alone_where_an_array_does_not_fit(self):
        for name, ask, rows, takes_out in questions():
            if not takes_out:
                continue
            expected = ask(rows)
            for place, right in enumerate(arrays_of(expected).values()):
                unaligned = np.zeros(right.nbytes + 1, np.uint8)[1:].view(right.dtype).reshape(right.shape)
                unaligned = [] if right.itemsize == 1 else [(ValueError, "in C order, aligned and writable", unaligned)]
                read_only = right.copy()
                read_only.setflags(write=False)
                shorter, longer = right[:-1].copy(), np.concatenate([right, right[:1]])
                for error, words, wrong in (
                        (TypeError, "expected an array, got", right.tolist()), (TypeError, "expected an array, got", np.ma.array(right)),
                        (TypeError, "expected an array of", right.astype(np.float32)), (TypeError, "expected an array of", right.astype(complex)),
                        *([] if right.itemsize == 1 else [(TypeError, "expected an array of", right.astype(right.dtype.newbyteorder()))]),
                        (ValueError, "expected the shape", shorter), (ValueError, "expected the shape", longer),
                        (ValueError, "expected the shape", right[None].copy()),
                        (ValueError, "in C order, aligned and writable", np.repeat(right, 2, axis=0)[::2]),
                        (ValueError, "in C order, aligned and writable", right[::-1].copy()[::-1]),
                        (ValueError, "in C order, aligned and writable", np.broadcast_to(right[:1], right.shape)),
                        (ValueError, "in C order, aligned and writable", read_only), *unaligned):
                    out = emptied(expected)
                    before = bits(out)
                    given = wrong if isinstance(out, np.ndarray) else type(out)(*(wrong if i == place else a for i, a in enumerate(out)))
                    with self.assertRaisesRegex(error, r"\Aout(\.\w+)?: .*" + words, msg=name):
                        ask(rows, out=given)
                    self.assertEqual(bits(out), before, name)

    def test_is_refused_where_arrays_share_memory(self):
        out = SCENE.nearest(BALLS)
        with self.assertRaisesRegex(ValueError, "out.depth: the array shares memory"):
            SCENE.nearest(BALLS, out=out._replace(depth=out.distance))
        with self.assertRaisesRegex(ValueError, "out.face: the array shares memory"):
            SCENE.nearest(BALLS, out=out._replace(face=out.object))
        rows = BALLS.copy()
        for part in (rows.ravel()[:len(rows)], rows.ravel()[-len(rows):]):
            with self.assertRaisesRegex(ValueError, "out.distance: the array shares memory"):
                SCENE.nearest(rows, out=out._replace(distance=part))
        self.assertEqual(rows.tolist(), BALLS.tolist())

    def test_is_refused_where_it_is_no_answer_to_this_question(self):
        for name, ask, rows, takes_out in questions():
            if takes_out:
                for wrong in (touchstone.Hits(None, None), [], 3):
                    with self.assertRaisesRegex(TypeError, "out: expected", msg=name):
                        ask(rows, out=wrong)
                if name != "TriangleSet.contact":
                    with self.assertRaisesRegex(ValueError, "out: it takes the answers of a batch"):
                        ask(rows[0], out=ask(rows[:1]))
        row = np.ones(len(SET), dtype=bool)
        self.assertIs(SET.contact(BALLS[0], out=row), row)
        self.assertEqual(row.tolist(), SET.contact(BALLS[0]).tolist())


class Threads(unittest.TestCase):
    def test_may_ask_at_once_each_into_arrays_of_its_own(self):
        asking = [(ask, np.tile(rows, (20, 1)), takes_out) for _, ask, rows, takes_out in questions()]
        expected = [bits(ask(rows)) for ask, rows, _ in asking]
        found = [None] * 3

        def work(place):
            found[place] = [bits(ask(rows, out=emptied(ask(rows))) if takes_out else ask(rows)) for ask, rows, takes_out in asking]

        threads = [threading.Thread(target=work, args=(place,)) for place in range(len(found))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [expected] * len(found))


if __name__ == "__main__":
    unittest.main()
