# SPDX-License-Identifier: GPL-3.0-or-later
"""What the strategies draw is valid, hard and varied, and shrinks."""

import collections
import unittest

import hypothesis
import numpy as np
import touchstone_contact as touchstone
from touchstone_contact import strategies
from touchstone_contact.judging import Question

SETTINGS = hypothesis.settings(derandomize=True, max_examples=300, deadline=None, database=None,
                               suppress_health_check=list(hypothesis.HealthCheck))


def drawn(strategy):
    """What Hypothesis draws of a strategy; an invalid polygon would raise."""
    found = []

    @SETTINGS
    @hypothesis.given(strategy)
    def take(value):
        found.append(value)

    take()
    return found


class Strategies(unittest.TestCase):
    def test_draw_balls_on_both_sides_of_the_threshold_and_at_it(self):
        for floats, number in ((False, np.float64), (True, np.float32)):
            sides, tangent = collections.Counter(), 0
            for question in drawn(strategies.questions(holes=True, floats=floats)):
                ball, polygon = question.row(), question.polygon
                distance = touchstone.exact.closest(ball, polygon)[1]
                inner, outer = number(distance), number(distance)
                for _ in range(3):
                    inner, outer = np.nextafter(inner, number(0)), np.nextafter(outer, number(np.inf))
                self.assertTrue(inner <= question.radius <= outer, question)
                self.assertEqual(question.contact, touchstone.exact.contact(ball, polygon))
                sides[question.contact] += 1
                tangent += touchstone.exact.relation(ball, polygon) == "touching"
            self.assertGreater(sides[True], 80)
            self.assertGreater(sides[False], 80)
            self.assertGreater(tangent, 15)

    def test_draw_every_relation_of_foot_and_polygon(self):
        feet, nearest, wrong = collections.Counter(), collections.Counter(), 0
        for question in drawn(strategies.questions()):
            ball, polygon = question.row(), question.polygon
            feet[touchstone.exact.foot(ball, polygon)] += 1
            nearest[touchstone.exact.answer(ball, polygon).nearest["kind"]] += 1
            wrong += touchstone.fast.relation(ball, polygon) != touchstone.exact.relation(ball, polygon)
        for count in (*(feet[word] for word in ("inside", "boundary", "outside")), *(nearest[kind] for kind in ("face", "edge", "vertex"))):
            self.assertGreater(count, 10)
        self.assertGreater(wrong, 10)

    def test_draw_polygons_of_all_kinds(self):
        polygons = drawn(strategies.polygons(max_vertices=7, holes=True))
        self.assertTrue({3, 4, 5, 6, 7} <= {len(polygon.outer) for polygon in polygons})
        self.assertGreater(sum(len(polygon.holes) for polygon in polygons), 30)
        turns = [np.cross(np.roll(p.outer, -1, 0) - p.outer, np.roll(p.outer, -2, 0) - p.outer) for p in polygons]
        convex = sum(bool(np.all(turn @ turn[0] > 0)) for turn in turns)
        self.assertTrue(30 < convex < len(polygons) - 30, convex)
        self.assertTrue(all(len(polygon.outer) <= 7 for polygon in polygons))

    def test_draw_floats_if_told_to(self):
        for question in drawn(strategies.questions(holes=True, floats=True)):
            for number in np.ravel([*question.points(), [question.radius] * 3]):
                self.assertEqual(float(np.float32(number)), number)

    def test_shrink_to_small_triangles_and_print_as_python(self):
        found = hypothesis.find(strategies.questions(), lambda question: question.radius > 0, settings=SETTINGS)
        self.assertEqual(len(found.vertices), 3)
        self.assertLessEqual(np.abs(found.points()).max(), 8)
        self.assertEqual(eval(repr(found), {"Question": Question}), found)


if __name__ == "__main__":
    unittest.main()
