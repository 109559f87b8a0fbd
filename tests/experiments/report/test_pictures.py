# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_pictures.py SOURCE

Pictures take the steps of a study from its data, show shares of one whole as such, and tell methods and libraries apart.
There, on pages and in the paper, a share is shown as 0 % or 100 % only where it is."""
import io
import pathlib
import re
import sys
import types
import unittest

import matplotlib.image
import numpy as np

SOURCE = pathlib.Path(sys.argv[1])
sys.path[:0] = [str(SOURCE / "experiments/report"), str(SOURCE / "papers")]

import dark
from looks import LIBRARIES, LOOKS, asks_the_question
from page import percent
from shares import unless_whole
from studies.regress import overall
from thesis import cell as thesis_cell
from thesis import method as thesis_method
from values import latex

STATION = {"azimuth": 0, "radius": 500, "height": 409, "deck": 412}


def bars(step):
    """(from, to) of each bar of the heights, of which the lowest two fail, five are from above and five from the side."""
    outcomes = ["no contact"] * 2 + ["from above"] * 5 + ["from the side"] * 5
    places = [{"scan": f"heights {case}", "height_mm": 1.0 + i * step, "outcome": outcome}
              for case in (1, 2) for i, outcome in enumerate(outcomes)]
    cell = types.SimpleNamespace(
        drawing={"material": {"side": 40}, "sphere_radius": 6, "stations": {"storage 1": STATION, "storage 2": STATION}},
        sides={f"case {case}, move {case + 1}": [{"out": 0, "up": 0, "height": 412}] for case in (1, 2)})
    figure = thesis_cell.heights(cell, places, "highest")
    return [(bar.get_y(), bar.get_y() + bar.get_height()) for bar in figure.axes[1].patches]


class Heights(unittest.TestCase):
    def test_the_bars_end_at_heights_that_complete_and_leave_no_gap_between_them(self):
        for step in (2, 5, 10):
            with self.subTest(step=step):
                above, beside = bars(step)[:2]
                self.assertEqual(above, (1 + 2 * step, 1 + 6.5 * step))
                self.assertEqual(beside, (1 + 6.5 * step, 1 + 11 * step))


class Looks(unittest.TestCase):
    def test_no_two_are_alike(self):
        for looks in (LOOKS, LIBRARIES):
            seen = {}
            for name, look in looks.items():
                self.assertNotIn((look.colour, look.line, look.marker), seen, f"{name} looks like another")
                seen[look.colour, look.line, look.marker] = name

    def test_every_library_of_scenes_has_one(self):
        folders = ("experiments/studies/bench_scenes", "experiments/methods/engines")
        text = "".join(path.read_text() for folder in folders for path in sorted((SOURCE / folder).rglob("*.[ch]*")))
        names = re.findall(r'(?:return \{(?:\.name = )?|broad_phase<[^;]*>\(|kEmbree = )"([^"]+)"', text)
        self.assertGreaterEqual(len(names), 10)
        self.assertEqual(set(names) - set(LIBRARIES), set())


class Front(unittest.TestCase):
    def test_methods_that_answer_about_another_shape_are_not_compared(self):
        asked = {placement: [method for method in LOOKS if asks_the_question(method, placement)] for placement in ("lattice-frame", "rotated")}
        self.assertEqual(set(LOOKS) - set(asked["lattice-frame"]), {"hull"})
        self.assertEqual(set(asked["lattice-frame"]) - set(asked["rotated"]), {"convex-parts", "cgal-epeck-distance", "cgal-epeck-intersect"})


class Dark(unittest.TestCase):
    def test_methods_keep_their_colours_and_neighbours_stay_apart(self):
        def parts(text):
            return tuple(bytes.fromhex(text.removeprefix("#")))

        self.assertEqual(dark.colour(255, 255, 255), dark.PAPER)
        self.assertEqual(dark.colour(0, 0, 0), dark.INK)
        for method in ("fast", "filtered", "thesis", "thesis-signed"):
            self.assertEqual(dark.colour(*parts(LOOKS[method].colour)), parts(LOOKS[method].colour), method)
        # Of the two blues, that of fast-float stays the lighter one.
        self.assertGreater(sum(dark.colour(*parts(LOOKS["fast-float"].colour))), sum(dark.colour(*parts(LOOKS["fast"].colour))) + 100)

    def test_both_kinds_of_pictures_are_changed(self):
        text = dark.svg('<svg width="1pt"><path style="fill: #ffffff"/><g>text</g><path style="stroke: #0072b2"/></svg>')
        self.assertEqual(text, '<svg fill="#e8e8e4" width="1pt"><path style="fill: #16181a"/><g>text</g><path style="stroke: #0072b2"/></svg>')
        file = io.BytesIO()
        matplotlib.image.imsave(file, np.array([[[255, 255, 255], [0, 0x72, 0xb2]]], np.uint8), format="png")
        pixels = matplotlib.image.imread(io.BytesIO(dark.png(file.getvalue())), format="png")
        self.assertEqual(np.round(255 * pixels[0, :, :3]).astype(int).tolist(), [list(dark.PAPER), [0, 0x72, 0xb2]])


class NotNumbers(unittest.TestCase):
    def test_each_bar_of_floats_is_a_part_of_the_one_above(self):
        figure = thesis_method.not_numbers([{"ours": value} for value in ("60", "20", "50", "10")])
        widths = [bar.get_width() for bar in figure.axes[0].patches]
        self.assertEqual(widths, [60, 30, 3, 20])


class Shares(unittest.TestCase):
    def test_what_misleads_nobody_stays(self):
        for share, shown in ((0.5, "50"), (0.0, "0"), (1.0, "100"), (1.63, "163"), (0.994, "99"), (3e-9, "3e-07")):
            self.assertEqual(unless_whole(share, shown), shown)

    def test_nothing_else_looks_like_all_or_nothing(self):
        for share, shown, places, wanted in ((0.996, "100", 1, "99.6"), (1228 / 1229, "1e+02", 1, "99.9"), (0.9999, "100", 1, "> 99.9"),
                                             (0.9999, "100.0", 2, "99.99"), (0.004, "0", 1, "0.4"), (0.0004, "0", 1, "< 0.1"),
                                             (1e-9, "0.00", 2, "< 0.01")):
            self.assertEqual(unless_whole(share, shown, places), wanted)

    def test_in_pages(self):
        self.assertEqual([percent(share) for share in (0, 0.123, 1228 / 1229, 0.99999, 1)],
                         ["0\u00a0%", "12\u00a0%", "99.9\u00a0%", "&gt; 99.9\u00a0%", "100\u00a0%"])

    def test_in_the_paper(self):
        self.assertEqual([latex.percent(share) for share in (0, 0.123, 1228 / 1229, 0.99999, 1)],
                         [r"0\,\%", r"12\,\%", r"99.9\,\%", r"$>$\,99.9\,\%", r"100\,\%"])

    def test_in_tables_of_engines(self):
        rows = [{"method": "fast", "numbers": numbers, "family": "u", "wrong": wrong, "cases": 100_000, "first_offset_exponent": None}
                for numbers, wrong in (("doubles", 99_999), ("floats", 1))]
        cells = overall(rows, 10)[0]
        self.assertEqual(cells[2], "> 99.9 %")
        self.assertEqual(cells[5], "0.001 %")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
