# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: coq_test.py RECORD GAPPA COQC CALCULUS FILTERS

Coq refuses what is not proved: constants that are too small, hints that are no identities, hints that are assumed, bounds
that the error calculus does not give.
Exit status 1 otherwise.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROOFS = pathlib.Path(__file__).resolve().parents[3] / "robust/proofs"
sys.path.append(str(PROOFS))

import calculus_steps  # noqa: E402
import claims  # noqa: E402
import coq  # noqa: E402
import error_free  # noqa: E402
import gappa  # noqa: E402
import prove  # noqa: E402
import prove_in_coq  # noqa: E402
import signs  # noqa: E402

RECORD, GAPPA, COQC, CALCULUS, FILTERS = sys.argv[1:6]
MODEL, RECORDS = prove.read(RECORD)
TRANSFORMATIONS = error_free.transformations(prove.recorded(RECORD))
CROSS = next(record for record in RECORDS if record["constant"] == "kRoundedCross")
CLAIMED = CROSS["value"] - MODEL["rounding_of_bound"]


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.check = prove_in_coq.Check(GAPPA, COQC, self.folder)

    def faults(self, theory):
        file = self.folder / "claim.v"
        file.write_text(theory)
        return self.check.of_file(file)[0]


class Claim(InFolder):
    def setUp(self):
        super().setUp()
        self.assertEqual(self.check.of_theory("model", 0), ([], set()))

    def claim(self, constant=CLAIMED):
        return signs.claim(CROSS, MODEL["unit"], constant)

    def proof(self, constant=CLAIMED):
        return gappa.proof_for_coq(GAPPA, self.claim(constant), MODEL["unit"])

    def changed(self, pattern, replacement):
        """The theory of the claim, changed in one place."""
        theory, count = re.subn(pattern, replacement, coq.theory(self.claim(), self.proof()), count=1)
        self.assertEqual(count, 1)
        return theory

    def test_checks_a_claim(self):
        self.assertEqual(self.faults(coq.theory(self.claim(), self.proof())), [])

    def test_refuses_a_constant_that_is_too_small(self):
        self.assertIsNone(self.proof(prove.below(CLAIMED)))
        [fault] = self.faults(coq.theory(self.claim(prove.below(CLAIMED)), self.proof()))
        self.assertIn("Coq refuses it", fault)

    def test_refuses_a_unit_that_is_larger_than_the_proof_s(self):
        [fault] = self.faults(coq.theory(signs.claim(CROSS, 2 * MODEL["unit"], CLAIMED / 2), self.proof()))
        self.assertIn("Coq refuses it", fault)

    def test_refuses_a_hint_that_is_no_identity(self):
        [fault] = self.faults(self.changed(r"Lemma a1 : (r\d+) = \w+\.", r"Lemma a1 : \1 = 0%R."))
        self.assertIn("Coq refuses it", fault)

    def test_finds_a_hint_that_is_assumed(self):
        self.assertEqual(self.faults(self.changed(r"(Lemma a1 : [^.]*\.) Proof\. identity\. Qed\.", r"\1 Admitted.")),
                         ["it assumes a1"])

    def test_finds_an_axiom(self):
        theory = self.changed(r"apply \(l1 ", "exfalso; exact cheat; apply (l1 ")
        self.assertEqual(self.faults("Axiom cheat : False.\n" + theory), ["it assumes cheat"])

    def test_finds_a_theorem_whose_assumptions_are_not_told(self):
        [fault] = self.faults(self.changed(r"Print Assumptions proved\.", ""))
        self.assertIn("of 0 theorems", fault)


class Sign(InFolder):
    def test_checks_the_sign_of_a_permanent_and_refuses_what_does_not_follow(self):
        for theory in ("model", "permanent"):
            self.assertEqual(self.check.of_theory(theory, 0), ([], set()))
        claim = claims.of_records(*prove.read(FILTERS))[0]
        proof = coq.theory(claim.says, gappa.proof_for_coq(GAPPA, claim.says, claim.unit))
        for sign in (claim.sign, claim.sign.replace("-> 0 < e", "-> 1 < e"), claim.sign.replace("< - c", "< c")):
            file = self.folder / "sign.v"
            file.write_text(proof + sign)
            faults, _ = self.check.of_file(file, 2)
            self.assertEqual(faults == [], sign == claim.sign)


class ErrorFree(InFolder):
    """An error-free transformation with one operation in place of another."""

    def setUp(self):
        super().setUp()
        self.assertEqual(self.check.of_theory("error_free", 5)[0], [])

    def test_is_exact_only_as_it_is(self):
        self.assertEqual(len(TRANSFORMATIONS), 5)
        for each in TRANSFORMATIONS:
            self.assertEqual(self.faults(each.theory()), [], each.name)
            lets = [line for line in each.theory().splitlines() if line.startswith("  let ")]
            for line in lets[1:]:  # what follows from the first operation
                other = line.replace(" + ", " ~ ").replace(" - ", " + ").replace(" ~ ", " - ")
                other = other if other != line else line.replace(" * ", " + ")
                self.assertNotEqual(self.faults(each.theory().replace(line, other)), [], f"{each.name}: {other}")


class Program(InFolder):
    """One claim alone, as `prove_in_coq.py` checks it."""

    def checked(self, gappa_program):
        command = [sys.executable, "-B", str(PROOFS / "prove_in_coq.py"), RECORD, gappa_program, COQC,
                   str(self.folder / "one"), "kDot in double-doubles"]
        return subprocess.run(command, capture_output=True, text=True)

    def test_checks_a_claim(self):
        done = self.checked(GAPPA)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("1 of 1 claims checked by Coq", done.stdout)

    def test_refuses_a_hint_that_is_no_identity(self):
        program = self.folder / "gappa"
        program.write_text(f"#!/bin/sh\n{GAPPA} \"$@\" | sed -E 's/^(Hypothesis a1 : r[0-9]+ =).*/\\1 0%R./'\n")
        program.chmod(0o755)
        done = self.checked(str(program))
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("Coq refuses it", done.stdout)


class Stage(InFolder):
    def test_stops_when_it_is_interrupted(self):
        command = [sys.executable, "-B", str(PROOFS / "prove_in_coq.py"), RECORD, GAPPA, COQC, str(self.folder / "stopped"),
                   "--calculus", CALCULUS]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
            self.assertIn("checked in", process.stdout.readline())
            process.terminate()
            self.assertEqual(process.wait(), 130)


# A step by each rule, in base 16: the numbers of bounds are low, high, error; the last three are the result's.
STEPS = ("sum 0 1 1/4 0 1 1/4 0 2 1/2", "difference 0 1 1/4 0 1 1/4 -1 1 1/2", "product -1 2 0 0 3 1/4 -3 6 1/2",
         "square -1 2 1/4 -1 2 1/4 0 4 11/10", "maximum 0 1 1/4 -1 2 1/8 0 2 1/4", "magnitude -3 1 1/4 0 3 1/4",
         "division -2 4 1/2 2 4 1 -1 2 5/2", "root 1/10 9 1/10 1/4 3 1/4",
         "quotient 3 0 6 3 0 2 1", "rounded 1/4 1/8 0 4 1 -1/8 29/8 11/8", "total 3 1/4 1/8 4 -1 2 1/2 -33/2 33/2 75/8",
         "off 1/2 0 1 1/2 -1/2 3/2 1")


class Calculus(InFolder):
    def setUp(self):
        super().setUp()
        self.assertEqual(self.check.of_theory("calculus", 1)[0], [])

    def theory(self, steps):
        [theory] = calculus_steps.theories(steps)
        return theory.text()

    def refused(self, steps):
        """None of the steps is justified."""
        theory, count = re.subn(r"Theorem proved : .*\nProof\. .* Qed\.", "Theorem proved : existsb justified steps = false.\n"
                                "Proof. vm_compute; reflexivity. Qed.", self.theory(steps))
        self.assertEqual(count, 1)
        return self.faults(theory) == []

    def test_checks_steps_by_every_rule(self):
        self.assertEqual({step.split()[0] for step in STEPS}, set(calculus_steps.RULES))
        self.assertEqual(self.faults(self.theory(STEPS)), [])

    def test_refuses_a_theory_with_a_wrong_step(self):
        [fault] = self.faults(self.theory([*STEPS, "sum 0 1 0 0 1 0 0 1 0"]))
        self.assertIn("Coq refuses it", fault)

    def test_refuses_errors_that_are_too_small(self):
        halved = []
        for step in STEPS:
            *kept, error = step.split()
            numerator, _, denominator = error.partition("/")
            halved.append(" ".join([*kept, f"{numerator}/{2 * int(denominator or '1', 16):x}"]))
        self.assertTrue(self.refused(halved))

    def test_refuses_bounds_that_are_too_narrow(self):
        for place, value in ((-3, "1"), (-2, "1/10")):
            narrowed = [step.split() for step in STEPS]
            for numbers in narrowed:
                numbers[place] = value
            self.assertTrue(self.refused([" ".join(numbers) for numbers in narrowed]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
