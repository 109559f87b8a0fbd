# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids in Python say where points lie, which balls touch and how far the surface is, and name what they refuse."""

import copy
import pickle
import types
import unittest

import numpy as np
import touchstone_contact as touchstone

VERTICES = np.array([[x, y, z] for x in (0.0, 2) for y in (0, 2) for z in (0, 2)])
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6],
                  [0, 6, 4], [1, 5, 7], [1, 7, 3]])
POINTS = np.array([[1, 1, 1], [2, 1, 1], [0, 0, 0], [3, 1, 1], [1, 1, 0.25]])


class Solids(unittest.TestCase):
    def test_answer_alike_however_they_are_made(self):
        mesh = touchstone.Mesh(VERTICES, FACES)
        for solid in (touchstone.Solid(mesh), touchstone.Solid(VERTICES, FACES), touchstone.Solid(vertices=VERTICES.tolist(), faces=FACES.tolist()),
                      touchstone.Solid(types.SimpleNamespace(vertices=VERTICES, faces=FACES[:, ::-1]))):
            self.assertEqual(touchstone.PointLocation.words(solid.locate(POINTS)).tolist(), ["inside", "boundary", "boundary", "outside", "inside"])
            self.assertEqual(solid.signed_distance(POINTS).tolist(), [-1, 0, 0, 1, -0.25])
            self.assertEqual(repr(solid), "Solid(12 faces)")
            balls = np.column_stack([POINTS, [0, 0, 0, 0.5, 0]])
            self.assertEqual(solid.touches(balls).tolist(), [True, True, True, False, True])

    def test_answer_one_as_many(self):
        solid = touchstone.Solid(VERTICES, FACES)
        for point, code, distance in zip(POINTS, solid.locate(POINTS), solid.signed_distance(POINTS)):
            word = touchstone.PointLocation(code).name
            self.assertEqual((solid.locate(point), solid.signed_distance(point)), (word, distance))
            self.assertIs(type(solid.locate(point)), str)
            self.assertIs(type(solid.signed_distance(point)), float)
            self.assertIs(solid.touches([*point, 0]), bool(word != "outside"))
        for ask, shape in ((solid.locate, 3), (solid.signed_distance, 3), (solid.touches, 4)):
            self.assertEqual(ask(np.empty((0, shape))).shape, (0,))

    def test_differ_from_the_surface_of_the_mesh(self):
        scene = touchstone.Scene()
        scene.add("surface", touchstone.Mesh(VERTICES, FACES))
        self.assertIs(scene.touches([1, 1, 1, 0.5]), False)
        self.assertIs(touchstone.Solid(VERTICES, FACES).touches([1, 1, 1, 0.5]), True)

    def test_name_the_face_and_the_edge_that_is_open(self):
        with self.assertRaisesRegex(ValueError, r'object "solid", face 0, edge 1: .* 1 edge runs this way and 0 back'):
            touchstone.Solid(VERTICES, FACES[:-1])
        turned = FACES.copy()
        turned[4] = turned[4][::-1]
        with self.assertRaisesRegex(ValueError, "2 edges run this way and 0 back"):
            touchstone.Solid(VERTICES, turned)
        with self.assertRaisesRegex(ValueError, "face 0 has 4 vertices: the faces of a solid must be triangles"):
            touchstone.Solid(VERTICES, [[0, 1, 3, 2]])

    def test_name_what_is_no_point(self):
        solid = touchstone.Solid(VERTICES, FACES)
        for ask in (solid.locate, solid.signed_distance):
            for words, points in (("points must be", [0, 0]), ("points must be", 1.0), ("the point has", [0, 0, float("nan")]),
                                  ("point 1 has", [[0, 0, 0], [0, 0, float("inf")]])):
                with self.assertRaisesRegex(touchstone.Rejected, words):
                    ask(points)

    def test_are_neither_pickled_nor_copied(self):
        for refused in (pickle.dumps, copy.copy, copy.deepcopy):
            with self.assertRaisesRegex(TypeError, "cannot pickle or copy a Solid"):
                refused(touchstone.Solid(VERTICES, FACES))


if __name__ == "__main__":
    unittest.main()
