# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_shares.py SOURCE

A share is shown as 0 % or 100 % only where it is, in pages and in the paper."""
import pathlib
import sys
import unittest

SOURCE = pathlib.Path(sys.argv[1])
sys.path += [str(SOURCE / "experiments/report"), str(SOURCE / "papers")]

from page import percent  # noqa: E402
from shares import unless_whole  # noqa: E402
from studies.regress import overall  # noqa: E402
from values import latex  # noqa: E402


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
    unittest.main(argv=sys.argv[:1])
