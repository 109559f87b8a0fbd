# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets of triangles, meshes and scenes in Python give the answers about their faces one by one, and name what they refuse."""

import gc
import io
import pathlib
import pickle
import tempfile
import threading
import types
import unittest
import warnings

import numpy as np
import touchstone_contact as touchstone

CUBE_VERTICES = np.array([[x, y, z] for x in (0.0, 2) for y in (0, 2) for z in (0, 2)])
CUBE_FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6],
                       [0, 6, 4], [1, 5, 7], [1, 7, 3]])
CUBE_TRIANGLES = CUBE_VERTICES[CUBE_FACES]
MOST = 200  # batches that are asked while an object moves 10 times; each move waits for about four
TURN = np.array([[0.0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 1, -3]])  # a quarter about z, then a step


def random_balls(count, scale=3.0):
    random = np.random.default_rng(2026)
    return np.column_stack([random.uniform(-scale, scale, (count, 3)), random.uniform(0, 2, count)])


def touching_balls(triangles):
    """Balls whose distance from a triangle equals their radius, in doubles."""
    balls = random_balls(len(triangles))
    for ball, triangle in zip(balls, triangles):
        ball[3] = touchstone.exact.closest(ball, touchstone.Polygon(triangle))[1]
    return balls


def one_by_one(balls, triangles):
    polygons = [touchstone.Polygon(triangle) for triangle in triangles]
    return np.column_stack([touchstone.exact.contact(balls, polygon) for polygon in polygons])


def posed(triangles, pose):
    return triangles @ pose[:, :3].T + pose[:, 3]


def lists_of(found):
    """The lists of which `found` keeps the ends: of numbers, or of objects and faces."""
    rows = np.column_stack([found.object, found.face]) if hasattr(found, "face") else found.number
    return [part.tolist() for part in np.split(rows, found.indptr[1:-1])]


class TriangleSets(unittest.TestCase):
    def test_answer_as_their_triangles_do_one_by_one(self):
        triangles = np.random.default_rng(7).normal(size=(40, 3, 3))
        balls = np.concatenate([random_balls(60), touching_balls(triangles)])
        triangle_set, expected = touchstone.TriangleSet(triangles), one_by_one(balls, triangles)
        self.assertTrue(0 < expected.sum() < expected.size)
        self.assertEqual(triangle_set.contact(balls).tolist(), expected.tolist())
        self.assertEqual(triangle_set.any_contact(balls).tolist(), expected.any(axis=1).tolist())
        hit = [np.flatnonzero(row).tolist() for row in expected]
        self.assertEqual(lists_of(triangle_set.triangles_hit(balls)), hit)
        for i in (0, 60):
            self.assertEqual(triangle_set.contact(balls[i]).tolist(), expected[i].tolist())
            self.assertIs(triangle_set.any_contact(balls[i]), bool(expected[i].any()))
            self.assertEqual(triangle_set.triangles_hit(balls[i]).tolist(), hit[i])

    def test_keep_their_triangles(self):
        triangle_set = touchstone.TriangleSet(CUBE_TRIANGLES.tolist())
        self.assertEqual((len(triangle_set), triangle_set.triangles.tolist()), (12, CUBE_TRIANGLES.tolist()))
        self.assertEqual(touchstone.TriangleSet(np.empty((0, 3, 3))).contact(random_balls(2)).shape, (2, 0))

    def test_name_the_triangle_that_they_refuse(self):
        broken = CUBE_TRIANGLES.copy()
        broken[5, 2] = (broken[5, 0] + broken[5, 1]) / 2
        for words, code, triangles in (("triangle 5", "zero-normal", broken), ("n x 3 x 3", "malformed-case", CUBE_VERTICES),
                                       ("n x 3 x 3", "malformed-case", np.zeros((2, 4, 3)))):
            with self.assertRaisesRegex(touchstone.Rejected, words) as caught:
                touchstone.TriangleSet(triangles)
            self.assertEqual(caught.exception.code, code)


class Meshes(unittest.TestCase):
    def test_are_the_same_from_arrays_lists_files_and_other_objects(self):
        cube = touchstone.Mesh(CUBE_VERTICES, CUBE_FACES)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "cube.obj"
            file.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in CUBE_VERTICES.tolist()) +
                            "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in CUBE_FACES.tolist()))
            read = [touchstone.Mesh.read(file), touchstone.Mesh.read(str(file))]
        other = types.SimpleNamespace(vertices=CUBE_VERTICES, faces=CUBE_FACES)
        for same in (touchstone.Mesh(CUBE_VERTICES.tolist(), CUBE_FACES.tolist()), *read, touchstone.Mesh.of(other),
                     touchstone.Mesh.of(cube), touchstone.Mesh(CUBE_VERTICES, CUBE_FACES.astype(np.uint8))):
            self.assertEqual(same, cube)
        self.assertNotEqual(touchstone.Mesh(CUBE_VERTICES, CUBE_FACES[:-1]), cube)
        self.assertNotEqual(touchstone.Mesh(CUBE_VERTICES + 1, CUBE_FACES), cube)
        self.assertEqual((len(cube), cube.vertices.tolist(), cube.faces.tolist()),
                         (12, CUBE_VERTICES.tolist(), CUBE_FACES.tolist()))

    def test_show_their_vertices_without_a_copy(self):
        def seen(thing, name):
            return getattr(thing, name)

        for thing, name, expected in ((touchstone.Mesh(CUBE_VERTICES, CUBE_FACES), "vertices", CUBE_VERTICES),
                                      (touchstone.TriangleSet(CUBE_TRIANGLES), "triangles", CUBE_TRIANGLES),
                                      (touchstone.Mesh([], []), "vertices", np.empty((0, 3))),
                                      (touchstone.TriangleSet(np.empty((0, 3, 3))), "triangles", np.empty((0, 3, 3)))):
            view = seen(thing, name)
            self.assertEqual(np.shares_memory(view, seen(thing, name)), view.size > 0)
            self.assertEqual(view.base is thing, view.size > 0)
            del thing
            gc.collect()
            self.assertEqual((view.shape, view.tolist()), (expected.shape, expected.tolist()))
            for write in (lambda: view.fill(7), lambda: view.setflags(write=True)):
                if view.size:
                    with self.assertRaises(ValueError):
                        write()
        mesh = touchstone.Mesh(CUBE_VERTICES, CUBE_FACES)
        self.assertIs(touchstone.Mesh.of(mesh), mesh)

    def test_hold_faces_of_any_number_of_vertices(self):
        faces = [[0, 1, 3, 2], [4, 6, 7]]
        self.assertEqual(touchstone.Mesh(CUBE_VERTICES, faces).faces, faces)

    def test_are_taken_from_what_other_libraries_have(self):
        quads = [[0, 1, 3, 2], [4, 5, 7, 6]]
        triangles, mixed = CUBE_FACES[:2].tolist(), touchstone.Mesh(CUBE_VERTICES, CUBE_FACES[:2].tolist() + quads)
        block = types.SimpleNamespace
        cells = [block(type="vertex", data=[[0]]), block(type="triangle", data=np.array(triangles)),
                 block(type="line", data=[[0, 1]]), block(type="quad", data=np.array(quads))]
        flat = np.array([number for face in triangles + quads for number in [len(face), *face]])
        points = CUBE_VERTICES.astype(np.float32)
        open3d = types.SimpleNamespace(vertices=points, triangles=CUBE_FACES.astype(np.int32))
        self.assertEqual(touchstone.Mesh.of(open3d), touchstone.Mesh(CUBE_VERTICES, CUBE_FACES))
        pyvista, meshio = block(points=points, faces=flat, strips=np.array([], int)), block(points=points, cells=cells)
        for other in (pyvista, meshio):
            self.assertEqual(touchstone.Mesh.of(other), mixed)
            scene = touchstone.Scene()
            scene.add("other", other)
            self.assertEqual(scene.face_count("other"), 4)
        polygons = block(points=points, cells=[block(type="polygon", data=quads), block(type="polygon4", data=quads)])
        self.assertEqual(touchstone.Mesh.of(polygons), touchstone.Mesh(CUBE_VERTICES, quads + quads))
        for words, kind, wrong in (("type 'tetra' are not polygons", TypeError, block(points=points, cells=[block(type="tetra", data=quads)])),
                                   ("blocks with `type`", TypeError, block(points=points, cells={"triangle": triangles})),
                                   ("face 4 is to have 9 vertices, but 1 numbers", touchstone.Rejected, block(points=points, faces=[*flat, 9, 1])),
                                   ("strips", TypeError, block(points=points, faces=flat, strips=[4, 0, 1, 2, 3])),
                                   ("expected a mesh", TypeError, block(points=points))):
            with self.assertRaisesRegex(kind, words):
                touchstone.Mesh.of(wrong)

    def test_may_have_any_vertices_that_no_face_uses(self):
        vertices = np.vstack([[np.nan, np.inf, 0], CUBE_VERTICES])
        mesh = touchstone.Mesh(vertices, CUBE_FACES + 1)
        self.assertTrue(np.array_equal(mesh.vertices, vertices, equal_nan=True))
        self.assertEqual(mesh, pickle.loads(pickle.dumps(mesh)))
        scene = touchstone.Scene()
        scene.add("cube", mesh)
        self.assertEqual(scene.face_count(0), 12)
        self.assertEqual(len(touchstone.merge_faces(mesh).polygons), 6)
        with self.assertRaisesRegex(touchstone.Rejected, "face 0 has vertex 0, which has") as caught:
            touchstone.Mesh(vertices, [[0, 1, 2]])
        self.assertEqual(caught.exception.code, "not-finite")

    def test_are_read_from_bytes_and_open_files(self):
        text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        mesh = touchstone.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.obj"
            file.write_text(text)
            other = pathlib.Path(folder) / "a.txt"
            other.write_text(text)
            with open(file, "rb") as stream, open(file, encoding="utf-8") as lines:
                read = [touchstone.Mesh.read(stream), touchstone.Mesh.read(lines), touchstone.Mesh.read(other, "obj")]
        for same in (*read, touchstone.Mesh.read(text.encode(), "obj"), touchstone.Mesh.read(io.BytesIO(text.encode()), format=".OBJ"),
                     touchstone.Mesh.read(io.StringIO(text), "obj")):
            self.assertEqual(same, mesh)
            self.assertEqual(same.places, ["line 4"])
        for words, kind, refused in (("the bytes: give the format", ValueError, lambda: touchstone.Mesh.read(b"")),
                                     ("the file: give the format", ValueError, lambda: touchstone.Mesh.read(io.BytesIO())),
                                     ("unknown format 'step'", touchstone.BrokenMesh, lambda: touchstone.Mesh.read(b"", "step")),
                                     ("the bytes: the file has no face", touchstone.BrokenMesh, lambda: touchstone.Mesh.read(b"", "obj")),
                                     ("the bytes: line 1: 'x' is not", touchstone.BrokenMesh, lambda: touchstone.Mesh.read(b"v x", "obj")),
                                     ("must return bytes or str", TypeError, lambda: touchstone.Mesh.read(
                                         types.SimpleNamespace(read=lambda: 3), "obj")),
                                     ("", TypeError, lambda: touchstone.Mesh.read(3))):
            with self.assertRaisesRegex(kind, words):
                refused()

    def test_leave_out_what_is_faulty_in_a_file_and_name_it(self):
        text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv x 0 0\nf 1 2 3\nf 1 2 4\nf 3 2 1\n"
        with self.assertRaisesRegex(touchstone.BrokenMesh, "line 4"):
            touchstone.Mesh.read(text, "obj")
        mesh = touchstone.Mesh.read(text, "obj", bad_faces="leave out")
        self.assertEqual((len(mesh), mesh.places), (2, ["line 5", "line 7"]))
        self.assertEqual(mesh.left_out, ["the bytes: line 4: 'x' is not a number",
                                         "the bytes: line 6: the face uses vertex 4, which was left out"])
        self.assertEqual((touchstone.Mesh(CUBE_VERTICES, CUBE_FACES).places, pickle.loads(pickle.dumps(mesh))), ([], mesh))
        with self.assertRaisesRegex(ValueError, "bad_faces must be 'refuse' or 'leave out', not 'skip'"):
            touchstone.Mesh.read(text, "obj", bad_faces="skip")

    def test_name_what_they_refuse(self):
        for words, code, faces in (("face 1 has vertex 8, but there are 8", "malformed-case", [[0, 1, 2], [0, 1, 8]]),
                                   ("face 0 has vertex -1", "malformed-case", np.array([[0, 1, -1]])),
                                   ("faces: a vertex number is", "malformed-case", np.array([[0, 1, 2**63]], np.uint64)),
                                   ("face 2 has 2 vertices", "malformed-case", [[0, 1, 2], [0, 1, 2], [0, 1]]),
                                   ("n x k", "malformed-case", np.array([0, 1, 2]))):
            with self.assertRaisesRegex(touchstone.Rejected, words) as caught:
                touchstone.Mesh(CUBE_VERTICES, faces)
            self.assertEqual(caught.exception.code, code)
        with self.assertRaisesRegex(touchstone.Rejected, "vertex 1"):
            touchstone.Mesh([[0, 0, 0], [0, np.nan, 0], [1, 0, 0]], [[0, 1, 2]])
        with self.assertRaisesRegex(TypeError, "whole numbers"):
            touchstone.Mesh(CUBE_VERTICES, CUBE_FACES + 0.5)
        masked = np.ma.masked_array([[0, 1, 2]], mask=[[0, 0, 1]])
        for faces in (masked, [[0, 1, 3], masked[0]]):
            with self.assertRaisesRegex(TypeError, "masked"):
                touchstone.Mesh(CUBE_VERTICES, faces)
        with self.assertRaisesRegex(TypeError, "vertices"):
            touchstone.Mesh.of(3)
        for given in ({}, {"format": "obj"}):
            with self.assertRaisesRegex(touchstone.BrokenMesh, "nowhere.obj"):
                touchstone.Mesh.read("nowhere.obj", **given)
        self.assertTrue(issubclass(touchstone.BrokenMesh, ValueError))

    def test_warns_of_what_is_odd_in_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "open.stl"
            file.write_text("solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n")
            with self.assertWarnsRegex(UserWarning, "line 8: the last 'endsolid' is missing"):
                self.assertEqual(len(touchstone.Mesh.read(file).faces), 1)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                with self.assertRaises(UserWarning):
                    touchstone.Mesh.read(file)


class MergedMeshes(unittest.TestCase):
    def test_hold_polygons_and_the_faces_of_each(self):
        merged = touchstone.merge_faces(touchstone.Mesh(CUBE_VERTICES, CUBE_FACES))
        self.assertEqual([faces.tolist() for faces in merged.faces], [[2 * i, 2 * i + 1] for i in range(6)])
        self.assertEqual((merged.off_plane.tolist(), merged.left_out), ([0] * 6, []))
        balls = random_balls(100)
        cube, scene = touchstone.Scene(), touchstone.Scene()
        cube.add("cube", CUBE_TRIANGLES)
        scene.add("cube", merged)
        self.assertEqual(scene.touches(balls).tolist(), cube.touches(balls).tolist())
        self.assertEqual(scene.nearest(balls).distance.tolist(), cube.nearest(balls).distance.tolist())
        for ball, polygons in zip(balls, lists_of(scene.touched(balls))):
            faces = {face for _, polygon in polygons for face in merged.faces[polygon].tolist()}
            self.assertTrue({face for _, face in cube.touched(ball).tolist()} <= faces)
        self.assertEqual(pickle.loads(pickle.dumps(merged)).polygons, merged.polygons)

    def test_have_no_seam_on_which_a_ball_could_catch(self):
        across, along = np.meshgrid(np.arange(9.0), np.arange(3.0))
        vertices = np.column_stack([across.ravel(), along.ravel(), np.zeros(27)])
        faces = [[i, i + 1, i + 10, i + 9] for row in range(2) for i in range(9 * row, 9 * row + 8)]
        tiles, floor = touchstone.Scene(), touchstone.Scene()
        tiles.add("tiles", touchstone.Mesh(vertices, faces))
        floor.add("floor", touchstone.merge_faces(touchstone.Mesh(vertices, faces)))
        ways = [[x, 1, 0.5, 0.5] for x in np.linspace(0.25, 7.75, 31)]
        self.assertEqual(set(tiles.nearest(ways).feature), {touchstone.FeatureKind.edge, touchstone.FeatureKind.vertex})
        self.assertEqual(set(floor.nearest(ways).feature), {touchstone.FeatureKind.face})

    def test_refuse_bad_faces_or_leave_them_out(self):
        mesh = touchstone.Mesh([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [2, 0, 0]], [[0, 1, 2], [0, 4, 1], [0, 2, 3]])
        with self.assertRaisesRegex(touchstone.Rejected, "^face 1 of the mesh: ") as caught:
            touchstone.merge_faces(mesh)
        self.assertEqual(caught.exception.code, "zero-normal")
        merged = touchstone.merge_faces(mesh, bad_faces="leave out")
        self.assertEqual(([faces.tolist() for faces in merged.faces], [bad["face"] for bad in merged.left_out]), ([[0, 2]], [1]))
        for tolerance in (-1, float("nan")):
            with self.assertRaises(ValueError):
                touchstone.merge_faces(mesh, tolerance)
        bent = touchstone.Mesh([[0, 0, 0], [4, 0, 0], [4, 4, 0.25], [0, 4, 0]], [[0, 1, 2], [0, 2, 3]])
        self.assertEqual([len(touchstone.merge_faces(bent, tolerance).polygons) for tolerance in (0, 1)], [2, 1])
        self.assertTrue(0 < touchstone.merge_faces(bent, 1).off_plane[0] <= 1)


class Scenes(unittest.TestCase):
    def setUp(self):
        self.scene = touchstone.Scene()
        self.scene.add("cube", touchstone.Mesh(CUBE_VERTICES, CUBE_FACES))
        self.scene.add("turned", CUBE_TRIANGLES, TURN)
        self.triangles = [CUBE_TRIANGLES, posed(CUBE_TRIANGLES, TURN)]
        self.balls = np.concatenate([random_balls(200, 6), touching_balls(self.triangles[0]), touching_balls(self.triangles[1])])

    def faces_touched(self):
        expected = [one_by_one(self.balls, triangles) for triangles in self.triangles]
        return [[[k, face] for k in range(2) for face in np.flatnonzero(expected[k][i])] for i in range(len(self.balls))]

    def test_answer_as_their_faces_do_one_by_one(self):
        expected = self.faces_touched()
        self.assertTrue(any(expected) and not all(expected))
        self.assertEqual(lists_of(self.scene.touched(self.balls)), expected)
        self.assertEqual(self.scene.touches(self.balls).tolist(), [bool(faces) for faces in expected])
        nearest = self.scene.nearest(self.balls)
        for i, ball in enumerate(self.balls):
            faces = [touchstone.exact.closest(ball, touchstone.Polygon(t)) for triangles in self.triangles for t in triangles]
            least = min(distance for _, distance in faces)
            first = [distance for _, distance in faces].index(least)
            self.assertEqual((nearest.object[i], nearest.face[i], nearest.distance[i]), (first // 12, first % 12, least))

    def test_answer_about_moving_balls_as_their_faces_do(self):
        motions = np.column_stack([self.balls, np.random.default_rng(3).uniform(-6, 6, (len(self.balls), 3))])
        motions[:, 3] /= 4
        polygons = [[touchstone.Polygon(triangle) for triangle in triangles] for triangles in self.triangles]
        touched, firsts = lists_of(self.scene.touched(motions)), [self.scene.first_contact(motion) for motion in motions]
        self.assertEqual(self.scene.touches(motions).tolist(), [first is not None for first in firsts])
        self.assertTrue(any(firsts) and not all(firsts))
        for motion, faces, found in zip(motions, touched, firsts):
            alone = {(k, face): touchstone.exact.first_contact(motion, polygon)
                     for k in range(2) for face, polygon in enumerate(polygons[k])}
            hit = {face: first for face, first in alone.items() if first.contact}
            self.assertEqual([tuple(row) for row in faces], sorted(hit))
            if found is None:
                self.assertEqual(hit, {})
                continue
            self.assertEqual(found.contact, hit[found.object, found.face])
            self.assertEqual(found.contact.time, min(first.time for first in hit.values()))

    def test_list_the_faces_on_a_way_in_the_order_of_time(self):
        motions = np.column_stack([self.balls, np.random.default_rng(4).uniform(-6, 6, (len(self.balls), 3))])
        touched = lists_of(self.scene.touched(motions))
        listed, firsts = ([ask(motion) for motion in motions] for ask in (self.scene.touched_in_order, self.scene.first_contact))
        self.assertTrue(any(len(faces) > 2 for faces in listed))
        for faces, all_touched, first in zip(listed, touched, firsts):
            self.assertEqual(sorted([face.object, face.face] for face in faces), all_touched)
            self.assertEqual(faces[0] if faces else None, first)
            times = [(face.contact.time, face.object, face.face) for face in faces]
            self.assertEqual([time[0] for time in times], sorted(time[0] for time in times))

    def test_take_centres_and_radii_apart(self):
        centres, radii = self.balls[:, :3], self.balls[:, 3]
        square = touchstone.Polygon([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]])
        triangle_set = touchstone.TriangleSet(CUBE_TRIANGLES)
        for ask in (self.scene.touches, triangle_set.contact, lambda balls: touchstone.filtered.contact(balls, square),
                    lambda balls: touchstone.filtered.relation(balls, square)):
            self.assertEqual(ask((centres, radii)).tolist(), ask(self.balls).tolist())
            self.assertEqual(ask((centres.tolist(), 0.75)).tolist(), ask(np.column_stack([centres, np.full(len(radii), 0.75)])).tolist())
        self.assertIs(self.scene.touches(([0, 0, 0], 1)), True)
        self.assertEqual(self.scene.nearest((centres[0], radii[0])), self.scene.nearest(self.balls[0]))
        self.assertEqual(self.scene.touches(([9, 9, 9, 1], [0, 0, 0, 1])).tolist(), [False, True])  # two balls, as before
        for words, wrong in (("for 2 centres there must be one radius or as many", (centres[:2], [1, 2, 3])),
                             ("of one centre must be a number", ([0, 0, 0], [1])), ("ball 1", (centres[:2], [1, -1])), ("negative", ([0, 0, 0], -1))):
            with self.assertRaisesRegex(touchstone.Rejected, words):
                self.scene.touches(wrong)

    def test_leave_out_bad_faces_and_name_them(self):
        vertices = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [2, 0, 0], [4, 3, 0]]
        faces = [[0, 1, 2, 3], [0, 4, 1], [0, 1, 2], [0, 5, 1, 3], [0, 1, 1], [0, 2, 3]]
        mesh = touchstone.Mesh(vertices, faces)
        with self.assertRaisesRegex(touchstone.Rejected, "^face 1 of the mesh: the outer loop: its Newell normal is zero") as caught:
            self.scene.add("mesh", mesh)
        self.assertEqual(caught.exception.code, "zero-normal")
        self.scene.add("mesh", mesh, bad_faces="leave out")
        self.assertEqual(self.scene.face_numbers("mesh").tolist(), [2, 5, 0])
        left_out = self.scene.left_out("mesh")
        self.assertEqual([(bad["face"], bad["code"]) for bad in left_out], [(1, "zero-normal"), (3, "loop-meets-itself"), (4, "repeated-vertex")])
        self.assertIn("edge 0", left_out[1]["message"])
        self.assertEqual((self.scene.face_numbers(0).tolist(), self.scene.left_out(0)), (list(range(12)), []))
        triangles = CUBE_TRIANGLES.copy()
        triangles[3] = 1
        self.scene.add("triangles", triangles, bad_faces="leave out")
        self.assertEqual(self.scene.face_numbers("triangles").tolist(), [i for i in range(12) if i != 3])
        self.assertEqual([bad["face"] for bad in self.scene.left_out("triangles")], [3])
        other = types.SimpleNamespace(vertices=[*vertices, [np.nan, 0, 0]], faces=[[0, 1, 6], [0, 1, 2], [0, 1, 9], [0, 1]])
        self.scene.add("of another library", other, bad_faces="leave out")
        bad = [(0, "not-finite"), (2, "malformed-case"), (3, "too-few-vertices")]
        self.assertEqual([(face["face"], face["code"]) for face in self.scene.left_out("of another library")], bad)
        with self.assertRaisesRegex(touchstone.Rejected, "face 0 has vertex 6"):
            touchstone.merge_faces(other, bad_faces="leave out")
        other.faces = [[0, 1, -1]]
        with self.assertRaisesRegex(touchstone.Rejected, "face 0 has vertex -1"):
            self.scene.add("with a wrong number", other, bad_faces="leave out")
        for use in (self.scene.face_numbers, self.scene.left_out):
            with self.assertRaises(IndexError):
                use(9)
            with self.assertRaises(ValueError):
                use("nobody")
        with self.assertRaisesRegex(ValueError, "bad_faces must be"):
            self.scene.add("other", mesh, bad_faces="as they are")

    def test_take_degenerate_faces_of_an_stl_file_as_segments(self):
        corners = [[[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 0, 1], [4, 0, 1], [4, 0, 1]], [[9, 9, 9]] * 3, [[0, 0, 2], [4, 0, 2], [1, 0, 2]]]
        facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*corner) for corner in facet)
                         + "endloop\nendfacet\n" for facet in corners)
        mesh = touchstone.Mesh.read(f"solid part\n{facets}endsolid part\n".encode(), "stl")
        with self.assertRaises(touchstone.Rejected):
            self.scene.add("part", mesh)
        self.scene.add("part", mesh, bad_faces="as segments")
        self.assertEqual([bad["face"] for bad in self.scene.segments("part")], [1, 2, 3])
        self.assertEqual((self.scene.left_out("part"), self.scene.segments("cube")), ([], []))
        self.assertEqual(self.scene.touched([3, 0, 1.5, 0.5], ["part"]).tolist(), [[2, 1], [2, 3]])
        nearest = self.scene.nearest([9, 9, 9, 1], ["part"])
        self.assertEqual((nearest.face, nearest.feature, nearest.depth), (2, {"kind": "vertex", "index": 0}, 1))
        self.assertEqual(nearest.contact_normal.tolist(), [0, 0, 0])
        first = self.scene.first_contact([2, 0, 5, 0.5, 2, 0, 0], ["part"])
        self.assertEqual((first.face, first.contact.feature), (3, {"kind": "edge", "index": 0}))
        self.scene.set_pose("part", TURN)
        self.assertTrue(self.scene.touches(posed(np.array([[[3, 0, 1]] * 3]), TURN)[0, 0].tolist() + [1e-9], ["part"]))
        self.scene.remove("cube")
        self.assertNotIn("cube", self.scene.names)
        self.assertNotIn(0, self.scene.numbers)
        self.assertEqual(len(self.scene), len(self.scene.numbers))
        self.assertEqual(self.scene.nearest([9, 9, 9, 1], ["part"]).object, 2)
        with self.assertRaisesRegex(ValueError, "cube"):
            self.scene.remove("cube")
        with self.assertRaises(IndexError):
            self.scene.pose(0)
        triangles = np.array([facet for facet in corners if len(facet) == 3], dtype=float)
        with self.assertRaises(touchstone.Rejected):
            touchstone.TriangleSet(triangles)
        triangle_set = touchstone.TriangleSet(triangles, bad_faces="as segments")
        self.assertEqual(triangle_set.triangles_hit([3, 0, 1.5, 0.5]).tolist(), [1, 3])
        self.assertEqual(pickle.loads(pickle.dumps(triangle_set)), triangle_set)
        self.scene.add("set", triangle_set, bad_faces="as segments")
        quad = touchstone.Mesh([[0, 0, 0], [1, 0, 0], [3, 0, 0], [2, 0, 0], [0, 2, 0]], [[1, 2, 0, 3], [0, 1, 4]])
        self.scene.add("quad", quad, bad_faces="as segments")
        self.assertEqual(self.scene.segments("quad"), [{"face": 0, "corners": [1, 2, 2]}])
        with self.assertRaisesRegex(touchstone.Rejected, "^face 0 of the mesh"):
            self.scene.add("bow", touchstone.Mesh([[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2, 3]]), bad_faces="as segments")
        for refuse in (touchstone.Mesh.read, touchstone.merge_faces):
            with self.assertRaisesRegex(ValueError, "bad_faces must be 'refuse' or 'leave out', not 'as segments'"):
                refuse(mesh, bad_faces="as segments")
        with self.assertRaisesRegex(ValueError, "bad_faces must be 'refuse', 'leave out', 'as segments' or 'as segments or leave out', not 'skip'"):
            self.scene.add("other", mesh, bad_faces="skip")

    def test_ask_some_objects_by_number_or_name(self):
        only = touchstone.Scene()
        only.add("turned", CUBE_TRIANGLES, TURN)
        for objects in ([1], ["turned"], ("turned", 1)):
            self.assertEqual(self.scene.touches(self.balls, objects).tolist(), only.touches(self.balls).tolist())
            distances = self.scene.nearest(self.balls, objects=objects).distance
            self.assertEqual(distances.tolist(), only.nearest(self.balls).distance.tolist())
        self.assertFalse(self.scene.touches(self.balls, []).any())

    def test_move_their_objects(self):
        before = self.scene.touches(self.balls)
        self.scene.set_pose("turned", None)
        self.assertEqual(self.scene.pose(1).tolist(), np.eye(4).tolist())
        self.assertFalse((np.diff(self.scene.touched(self.balls).indptr) % 2).any())  # two equal cubes
        self.scene.set_pose(1, np.vstack([TURN, [0, 0, 0, 1]]))
        self.assertEqual(self.scene.pose("turned")[:3].tolist(), TURN.tolist())
        self.assertEqual(self.scene.touches(self.balls).tolist(), before.tolist())

    def test_take_polygons_sets_and_meshes_of_all_kinds(self):
        scene = touchstone.Scene()
        square = touchstone.Polygon([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]])
        kinds = {"one": square, "list": [square, touchstone.Polygon(CUBE_TRIANGLES[0])], "set": touchstone.TriangleSet(CUBE_TRIANGLES),
                 "quads": touchstone.Mesh(CUBE_VERTICES, [[0, 1, 3, 2], [0, 1, 3], [4, 5, 7, 6]]),
                 "other": types.SimpleNamespace(vertices=CUBE_VERTICES, faces=CUBE_FACES)}
        for name, faces in kinds.items():
            scene.add(name, faces)
        self.assertEqual((len(scene), scene.names), (5, list(kinds)))
        self.assertEqual([scene.face_count(name) for name in kinds], [1, 2, 12, 3, 12])
        # Triangles come before the other faces of a mesh.
        self.assertEqual(scene.nearest([3, 1, 1, 0], ["quads"]).face, 2)
        self.assertEqual(scene.nearest([-1, 0.5, 1.75, 0], ["quads"]).face, 0)
        self.assertEqual(repr(scene), "Scene(5 objects, 30 faces)")

    def test_take_faces_that_are_not_planar_as_polygons_do(self):
        warped = np.array([[0.0, 0, 0], [2, 0, 2], [2, 2, 0], [0, 2, 2]])
        scene = touchstone.Scene()
        scene.add("warped", touchstone.Mesh(warped, [[0, 1, 2, 3]]))
        balls = random_balls(100)
        self.assertEqual(scene.touches(balls).tolist(), touchstone.exact.contact(balls, touchstone.Polygon(warped)).tolist())

    def test_refuse_faces_of_a_mesh_that_are_no_polygons(self):
        loops = {"loop-meets-itself": [[[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 3, 0]],  # a bow-tie
                                       [[0, 0, 0], [4, 0, 0], [2, 0, 0], [2, 2, 0]],  # back along an edge
                                       [[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 0, 0], [0, -5, 0]],  # a crossing at a vertex
                                       [[0, 0, 1], [2, 2, 0], [2, 0, 1], [0, 3, 0]]],  # a bow-tie once it is lifted
                 "repeated-vertex": [[[0, 0, 0], [1, 0, 0], [1, 0, 0], [0, 1, 0]]],
                 "zero-normal": [[[0, 0, 0], [1, 1, 1], [2, 2, 2], [3, 3, 3]], [[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 2, 0]]]}
        for code, points in ((code, points) for code, all_of_it in loops.items() for points in all_of_it):
            mesh = touchstone.Mesh(CUBE_VERTICES.tolist() + points, [[0, 1, 3, 2], list(range(8, 8 + len(points)))])
            with self.assertRaisesRegex(touchstone.Rejected, "face 1 of the mesh: the outer loop") as caught:
                self.scene.add("quads", mesh)
            self.assertEqual(caught.exception.code, code, points)
            with self.assertRaises(touchstone.Rejected) as alone:
                touchstone.Polygon(points)
            self.assertEqual(alone.exception.code, code, points)
        self.assertEqual(len(self.scene), 2)

    def test_have_names_that_are_strings(self):
        cube = touchstone.Mesh(CUBE_VERTICES, CUBE_FACES)
        for name in (b"\xff", b"cube", "\ud800", 7, None):
            with self.assertRaises(TypeError):
                self.scene.add(name, cube)
        for name in (b"\xff", b"cube", "\ud800"):
            for use in (self.scene.pose, self.scene.face_count, lambda key: self.scene.set_pose(key, None),
                        lambda key: self.scene.touches(self.balls, [key])):
                with self.assertRaises(TypeError):
                    use(name)
        self.scene.add("w\u00fcrfel \U0001f3b2", cube)
        self.assertEqual(self.scene.names, ["cube", "turned", "w\u00fcrfel \U0001f3b2"])

    def test_without_faces_have_no_nearest_face(self):
        scene = touchstone.Scene()
        self.assertEqual((scene.nearest([0, 0, 0, 1]), scene.touches([0, 0, 0, 1])), (None, False))

    def test_name_what_they_refuse(self):
        flat = np.array([[[0.0, 0, 0], [1, 1, 1], [2, 2, 2]]])
        for words, kind, refused in (("cube", ValueError, lambda: self.scene.add("cube", CUBE_TRIANGLES)),
                                     ("flat.*face 0", touchstone.Rejected, lambda: self.scene.add("flat", flat)),
                                     ("face 1 of the mesh: ", touchstone.Rejected, lambda: self.scene.add(
                                         "m", touchstone.Mesh(CUBE_VERTICES, [[0, 1, 3, 2], [0, 1, 1, 2]]))),
                                     ("3 x 4", touchstone.Rejected, lambda: self.scene.set_pose(0, np.eye(3))),
                                     ("fourth row", touchstone.Rejected, lambda: self.scene.set_pose(0, np.ones((4, 4)))),
                                     ("cube", touchstone.Rejected, lambda: self.scene.set_pose(0, np.zeros((3, 4)))),
                                     ("ball 1", touchstone.Rejected, lambda: self.scene.touches([[0, 0, 0, 1], [0, 0, 0, -1]])),
                                     ("nobody", ValueError, lambda: self.scene.touches([0, 0, 0, 1], ["nobody"])),
                                     ("9", IndexError, lambda: self.scene.pose(9)),
                                     ("n x 3 x 3", touchstone.Rejected, lambda: self.scene.add("numbers", [1, 2]))):
            with self.assertRaisesRegex(kind, words):
                refused()
        self.assertEqual((self.scene.names, self.scene.pose(0).tolist()), (["cube", "turned"], np.eye(4).tolist()))

    def test_may_be_asked_and_moved_at_once(self):
        poses = [TURN, np.eye(4)]
        allowed = []
        for pose in poses:
            self.scene.set_pose(1, pose)
            allowed.append(self.scene.touches(self.balls).tolist())
        self.assertNotEqual(*allowed)
        found, moved = [], threading.Event()
        many = np.tile(self.balls, (1000, 1))  # so long that there is no moment at which nobody asks

        def move():
            for pose in poses * 5:
                self.scene.set_pose(1, pose)
            moved.set()

        def ask():
            while not moved.is_set() and len(found) < MOST:
                found.append(self.scene.touches(many)[-len(self.balls):].tolist())

        threads = [threading.Thread(target=work) for work in (ask, ask, ask, ask, move)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        # A move waits for the batches before it. Were later ones let in first, it would wait until all are asked.
        self.assertLess(len(found), MOST)
        self.assertEqual({tuple(answers) for answers in found}, {tuple(answers) for answers in allowed})


if __name__ == "__main__":
    unittest.main()
