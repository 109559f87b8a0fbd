# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: filters_test.py RECORD GAPPA

The proof refuses wrong filters: constants that are too small, signs and bounds of something else, maxima that may
underflow or overflow. Exit status 1 otherwise.
"""

import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[3] / "robust/proofs"))

import prove  # noqa: E402
import uses  # noqa: E402

RECORD, GAPPA = sys.argv[1:3]
MODEL, CLAIMS = prove.read(RECORD)
_, *FILTERS = prove.recorded(RECORD)


class Filters(unittest.TestCase):
    def assert_refused(self, why, function, compared):
        [use] = function["uses"]
        with self.assertRaisesRegex(uses.Misuse, f"^{function['function']}, sign: {why}"):
            uses.claims(MODEL, [{**function, "uses": [{**use, "compared": compared}]}])

    def test_refuses_an_eighth_of_each_constant_and_names_the_filter(self):
        for claim in CLAIMS:
            faults, _ = prove.judge(GAPPA, MODEL, {**claim, "value": claim["value"] / 8})
            self.assertRegex(faults[0], f"^{claim['constant']} in doubles to nearest: .* is not proved")

    def test_refuses_comparisons_that_do_not_tell_the_sign(self):
        for function in FILTERS:
            *windows, above, below = function["uses"][0]["compared"]
            for wrong, why in (([[*above[:2], -1], [*below[:2], 1]], "its two comparisons are of different numbers"),
                               ([above], "it does not return each sign after one comparison"),
                               ([above, [below[0], above[1], -1]], "its two comparisons are of different numbers")):
                self.assert_refused(why, function, windows + wrong)

    def test_refuses_the_permanent_of_another_value(self):
        two = FILTERS[0]
        [above, below] = two["uses"][0]["compared"]
        left = next(node["of"][0] for node in two["recorded"] if node["node"] == above[0])
        self.assert_refused("its value and its permanent", two, [[left, above[1], 1], [below[0], left, -1]])

    def test_refuses_maxima_without_a_window(self):
        function = FILTERS[-1]
        compared = function["uses"][0]["compared"]
        for i, why in enumerate(3 * ["its maxima may be so small"] + 3 * ["its maxima may be so large"]):
            self.assert_refused(why, function, compared[:i] + compared[i + 1:])
            self.assert_refused(why, function, compared[:i] + compared[i + 1:] + [compared[i]])  # after the signs

    def test_claims_of_other_windows_are_other_claims(self):
        function = FILTERS[-1]
        [use] = function["uses"]
        [constant] = {of[0] for of in use["compared"][:3]}
        wider = [{**node, "constant": node["constant"] / 2} if node["node"] == constant else node for node in function["recorded"]]
        self.assertEqual(len(uses.claims(MODEL, [function, {**function, "recorded": wider}])), 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
