# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_pictures.py SOURCE

Pictures take the steps of a study from its data, show shares of one whole as such, and tell methods and libraries apart."""
import pathlib
import re
import sys
import types
import unittest

SOURCE = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(SOURCE / "experiments/report"))

import matplotlib

matplotlib.use("Agg")

import dark
from looks import LIBRARIES, LOOKS, asks_the_question
from thesis import cell as thesis_cell
from thesis import method as thesis_method

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
        import io

        import matplotlib.image
        import numpy as np
        file = io.BytesIO()
        matplotlib.image.imsave(file, np.array([[[255, 255, 255], [0, 0x72, 0xb2]]], np.uint8), format="png")
        pixels = matplotlib.image.imread(io.BytesIO(dark.png(file.getvalue())), format="png")
        self.assertEqual(np.round(255 * pixels[0, :, :3]).astype(int).tolist(), [list(dark.PAPER), [0, 0x72, 0xb2]])


class NotNumbers(unittest.TestCase):
    def test_each_bar_of_floats_is_a_part_of_the_one_above(self):
        figure = thesis_method.not_numbers([{"ours": value} for value in ("60", "20", "50", "10")])
        widths = [bar.get_width() for bar in figure.axes[0].patches]
        self.assertEqual(widths, [60, 30, 3, 20])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
