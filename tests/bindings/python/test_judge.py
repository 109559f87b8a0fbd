# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge of the module asks what a function takes, names its failures and makes them small, and refuses wrong input."""

import json
import math
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree

import judged_engines
import numpy as np
import touchstone_contact as touchstone
from touchstone_contact.judging import case_files
from touchstone_contact.judging.answers import exact_answer
from touchstone_contact.judging.question import read_cases

TRIANGLE = {"outer": [[0, 0, 0], [4, 0, 0], [0, 4, 0]]}
CASES = {
    "touches": {"ball": {"center": [1, 1, 1], "radius": 1}, "polygon": TRIANGLE, "expected": {"contact": True}},
    "misses": {"ball": {"center": [1, 1, 2], "radius": 1}, "polygon": TRIANGLE, "expected": {"contact": False, "relation": "separate"}},
    "moves": {"ball": {"center": [1, 1, 2], "radius": 1}, "motion": {"to": [1, 1, 0]}, "polygon": TRIANGLE, "expected": {"contact": True}},
    "hole": {"ball": {"center": [1, 1, 0], "radius": 0}, "polygon": {**TRIANGLE, "holes": [[[0.5, 0.5, 0], [2, 0.5, 0], [0.5, 2, 0]]]},
             "expected": {"contact": False}},
    "mesh": {"ball": {"center": [1, 1, 1], "radius": 1}, "mesh": {"vertices": TRIANGLE["outer"], "faces": [[0, 1, 2]]},
             "pose": {"translation": [0, 0, 1]}, "expected": {"contact": True}},
    "broken": {"ball": {"center": [1, 1, 1], "radius": 1}, "polygon": {"outer": [[0, 0, 0], [4, 0, 0]]}, "expected": {"error": True}},
}


def exactly(centre, radius, vertices, holes=()):
    return touchstone.filtered.contact([*centre, radius], touchstone.Polygon(vertices, holes))


def never(centre, radius, vertices):
    return False


class Judge(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.file = self.folder / "mine.jsonl"
        self.write(CASES)

    def write(self, cases):
        self.file.write_text("\n".join(json.dumps({"id": name, **case}) for name, case in cases.items()) + "\n\n")

    def test_is_content_with_exact_answers(self):
        judged = touchstone.judge(exactly)
        self.assertTrue(judged)
        judged.raise_on_failure()
        self.assertGreater(judged.all.cases, 3700)
        self.assertEqual(sorted(judged.families), sorted(file.stem for file in case_files() if "mov" not in file.stem and "mesh" not in file.stem))
        self.assertLess(judged.all.upper, 0.001)

    def test_asks_in_floats_what_the_function_takes(self):
        asked = []

        def engine(centre, radius, vertices):
            asked.append((centre.dtype, type(radius), vertices.dtype, centre.shape, vertices.ndim))
            return True

        touchstone.judge(engine)
        self.assertEqual(set(asked), {(np.dtype("float32"), np.float32, np.dtype("float32"), (3,), 2)})
        asked.clear()
        judged = touchstone.judge(engine, self.file)
        self.assertEqual(set(asked), {(np.dtype("float64"), np.float64, np.dtype("float64"), (3,), 2)})
        self.assertEqual((len(asked), judged.left_out), (2, 3))

    def test_passes_holes_motions_and_posed_meshes_by_name(self):
        asked = {}

        def engine(centre, radius, vertices, to, faces, pose, holes):
            asked[tuple(name for name, value in (("to", to), ("faces", faces), ("pose", pose), ("holes", holes or None))
                        if value is not None)] = to, faces, pose, holes
            return True

        judged = touchstone.judge(engine, self.file)
        self.assertEqual(judged.left_out, 0)
        self.assertEqual(set(asked), {(), ("to",), ("faces", "pose"), ("holes",)})
        self.assertEqual(asked["to",][0].tolist(), [1, 1, 0])
        self.assertEqual(asked["faces", "pose"][1], [[0, 1, 2]])
        self.assertEqual(asked["faces", "pose"][2].tolist(), [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1]])
        self.assertEqual([failure.case.id for failure in judged.failures], ["misses", "hole"])

    def test_leaves_out_what_is_not_a_triangle(self):
        self.assertEqual(touchstone.judge(exactly, self.file, triangles=True).left_out, 3)  # the hole, the motion and the mesh

    def test_names_the_case_that_raises_and_judges_the_others(self):
        def engine(centre, radius, vertices):
            if centre[2] == 1:
                raise ZeroDivisionError("by nothing")
            return True

        judged = touchstone.judge(engine, self.file)
        self.assertFalse(judged)
        self.assertEqual([str(failure) for failure in judged.failures],
                         ["case touches: ZeroDivisionError: by nothing", "case misses: contact: expected false, found true"])
        self.assertEqual((judged.all.cases, judged.all.wrong, judged.all.not_given), (2, 1, 1))
        self.assertIn("ZeroDivisionError", str(judged.failures[0].small))

    def test_takes_a_bool_keys_an_answer_or_nothing(self):
        for returned, failures in ((np.bool_(True), 1), ({"contact": np.array(True)}, 1), ({"relation": "overlapping"}, 2), (None, 2), (3, 2)):
            judged = touchstone.judge(lambda *_, returned=returned: returned, self.file)
            self.assertEqual(len(judged.failures), failures, returned)
        whole = touchstone.judge(lambda c, r, v: touchstone.exact.answer([*c, r], touchstone.Polygon(v)), self.file, keys="contact,relation")
        self.assertTrue(whole)
        self.assertIn("neither a bool nor a dict of keys", str(touchstone.judge(lambda *_: 3, self.file).failures[0]))

    def test_an_integer_that_no_double_holds_is_a_wrong_number(self):
        judged = touchstone.judge(lambda *_: {"contact": True, "distance": 10**400}, keys="distance", triangles=True)
        self.assertEqual((judged.all.wrong, judged.all.not_given), (judged.all.cases, 0))

    def test_excuses_what_a_margin_excuses(self):
        near = {"ball": {"center": [1, 1, 1], "radius": 1}, "polygon": TRIANGLE, "expected": {"contact": True}}
        self.write({"near": near})
        self.assertFalse(touchstone.judge(never, self.file))
        for beyond in (2**-20, "2^-20", "1e-9m"):
            judged = touchstone.judge(never, self.file, beyond=beyond)
            self.assertEqual((bool(judged), judged.all.within), (True, 1))
        self.write({"near": {**near, "ball": {"center": [1, 1, 1], "radius": 1.001}}})
        self.assertFalse(touchstone.judge(never, self.file, beyond="1e-4m"))

    def test_measures_a_normal_of_a_mesh_by_the_size_of_the_mesh(self):
        corners = TRIANGLE["outer"] + [[1000, 0, 0], [1000, 1, 0], [1000, 0, 1]]
        self.write({"far": {"ball": {"center": [1, 1, 1], "radius": 1}, "mesh": {"vertices": corners, "faces": [[0, 1, 2], [3, 4, 5]]},
                            "expected": {"contact_normal": [0, 0, 1]}}})
        for length, right in ((1 + 2**-22, True), (1 + 2**-16, False)):
            judged = touchstone.judge(lambda c, r, v, faces: {"contact_normal": [0, 0, length]}, self.file, keys="contact_normal", beyond="2^-20")
            self.assertEqual(bool(judged), right)

    def test_knows_failures_and_names_those_that_are_mended(self):
        known = self.folder / "known.jsonl"
        touchstone.judge(never, self.file).write_known(known)
        self.assertEqual(known.read_text(), '{"method":"never","case":"touches","key":"contact"}\n')
        again = touchstone.judge(never, self.file, known=known)
        self.assertEqual((bool(again), again.all.known, again.mended), (True, 1, []))
        mended = touchstone.judge(exactly, self.file, known=known, name="never")
        self.assertEqual([one.case for one in mended.mended], ["touches"])
        mended.write_known(known)
        self.assertEqual(known.read_text(), "")
        self.assertFalse(touchstone.judge(never, self.file, known=known))

    def test_refuses_wrong_choices_and_names_the_place(self):
        known = self.folder / "known.jsonl"
        for line in ('{"method":"never","case":"t"}', '{"method":"never","case":"t","key":"weight"}', "[]",
                     '{"method":"never","case":"t","key":"contact","given":true}'):
            known.write_text(line + "\n")
            with self.assertRaisesRegex(ValueError, "known.jsonl: line 1: is not a known failure"):
                touchstone.judge(never, self.file, known=known)
        for wrong in ({"keys": "weight"}, {"beyond": "2^x"}, {"beyond": 0}, {"beyond": "1e-6 m"}, {"beyond": math.inf}):
            with self.assertRaises(ValueError):
                touchstone.judge(never, self.file, **wrong)
        with self.assertRaises(FileNotFoundError):
            touchstone.judge(never, self.folder / "nothing.jsonl")
        for line, said in (('{"id":"a"', "is not a case"), ('{"id":"a","ball":{}}', "is not a case"),
                           (json.dumps({"id": "a", **CASES["broken"], "expected": {}}), "case a: too-few-vertices")):
            self.file.write_text("\n" + line + "\n")
            with self.assertRaisesRegex(ValueError, f"mine.jsonl: line 2: {said}"):
                touchstone.judge(never, self.file)
        self.file.write_text(2 * (json.dumps({"id": "a", **CASES["touches"]}) + "\n"))
        known.write_text("")
        with self.assertRaisesRegex(ValueError, "case a: its id is not unique"):
            touchstone.judge(never, self.file, known=known)


class Failures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with np.errstate(all="ignore"):
            cls.judged = touchstone.judge(judged_engines.corners, triangles=True, beyond="2^-20")
        cls.careless = touchstone.judge(judged_engines.careless, keys="all")

    def test_become_small_and_stay_failures(self):
        for failure in [next(one for one in self.judged.failures if one.case.family == family) for family in ("far", "sliver", "tangent-lattice")]:
            small = failure.small.case
            self.assertLess(len(failure.small.line), len(failure.line))
            self.assertLessEqual(max(map(abs, np.ravel(small.question.points()))), 1024)
            truth = exact_answer(small.question)["contact"]
            self.assertEqual(small.expected, {"contact": truth})
            with np.errstate(all="ignore"):
                self.assertNotEqual(eval(failure.small.call, {"np": np, "corners": judged_engines.corners}), truth)
            self.assertEqual(failure.differences[0].expected, truth)

    def test_become_smaller_cases_of_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "small.jsonl"
            for family in ("holes", "moving", "meshes-at-rest", "meshes-moving"):
                failure = next(one for one in self.careless.failures if one.case.family == family)
                file.write_text(failure.small.line + "\n")
                (case,) = read_cases(file)
                self.assertEqual((case.question, case.expected), (failure.small.case.question, failure.small.case.expected))
                self.assertFalse(touchstone.judge(judged_engines.careless, file, floats=True, keys="all"))

    def test_have_pictures_that_are_xml(self):
        families = set()
        for failure in self.careless.failures[::5]:
            picture = xml.etree.ElementTree.fromstring(failure._repr_svg_())
            texts = list(picture.iter("{http://www.w3.org/2000/svg}text"))
            self.assertEqual(len(texts), 3)
            titles = [title.text for title, in texts]
            self.assertEqual(titles[0], failure.case.id)
            self.assertIn(titles[1], str(failure))
            for (title,), whole in zip(texts, titles):
                self.assertLess(len(title.tail), 57)  # what fits
                self.assertTrue(whole.startswith(title.tail.removesuffix("...")))
            self.assertNotIn("nan", failure._repr_svg_())
            families.add(failure.case.family)
        self.assertEqual(len(families), len(case_files()))

    def test_are_on_a_page(self):
        page = self.judged._repr_html_()
        xml.etree.ElementTree.fromstring(f"<page>{page}</page>")
        self.assertEqual(page.count("<svg"), 3)
        self.assertIn("<td>sliver</td>", page)

    def test_are_told_by_an_assertion(self):
        with self.assertRaises(AssertionError) as told:
            self.judged.raise_on_failure()
        text = str(told.exception)
        self.assertIn(f"corners fails in {len(self.judged.failures)} of {self.judged.all.cases} cases:\n  case ", text)
        self.assertIn("contact: expected true, found false", text)
        self.assertIn("\n  corners(np.float32([", text)


if __name__ == "__main__":
    unittest.main()
