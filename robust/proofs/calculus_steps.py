# SPDX-License-Identifier: Apache-2.0
"""Steps of the error calculus, recorded by error_bound.h, as theories for Coq (coq/calculus.v)."""

# How many numbers a rule is given besides bounds, and how many bounds: the last one is the result.
RULES = {"sum": (0, 3), "difference": (0, 3), "product": (0, 3), "square": (0, 3), "maximum": (0, 3),
         "division": (0, 3), "root": (0, 2), "magnitude": (0, 2), "quotient": (1, 2), "rounded": (2, 2), "total": (4, 2), "off": (1, 2)}


def rational(text):
    """A rational in base 16 as Coq reads it: the denominator is an odd number with zeros behind it."""
    numerator, _, denominator = text.partition("/")
    odd = int(denominator or "1", 16)
    zeros = (odd & -odd).bit_length() - 1
    sign = "-" if numerator.startswith("-") else ""
    return f"ratio ({sign}0x{numerator.removeprefix('-')}) 0x{odd >> zeros:x} {zeros}"


class Theory:
    """Steps, each number of which is defined once."""

    def __init__(self):
        self.names, self.definitions, self.steps = {}, [], []

    def number(self, text):
        if text not in self.names:
            self.names[text] = f"q{len(self.names)}"
            self.definitions.append(f"Definition {self.names[text]} := {rational(text)}.")
        return self.names[text]

    def add(self, line):
        rule, *numbers = line.split()
        besides, bounds = RULES[rule]
        if len(numbers) != besides + 3 * bounds:
            raise ValueError(f"the step has {len(numbers)} numbers: {line[:80]}")
        numbers = [self.number(number) for number in numbers]
        given = " ".join([rule.capitalize(), *numbers[:besides]])
        first, *second, result = ["{| low := %s; high := %s; error := %s |}" % tuple(numbers[i:i + 3])
                                  for i in range(besides, len(numbers), 3)]
        second = second[0] if second else first
        self.steps.append(f"{{| by_rule := {given}; first := {first}; second := {second}; result := {result} |}}")

    def text(self):
        return ("Require Import QArith List Touchstone.calculus.\nImport ListNotations.\n\n"
                + "\n".join(self.definitions) + "\n\nDefinition steps := [\n  " + ";\n  ".join(self.steps) + "].\n\n"
                + "Theorem proved : forall step, In step steps -> meaning step.\n"
                + "Proof. apply all_sound; vm_compute; reflexivity. Qed.\n\nPrint Assumptions proved.\n")


def theories(lines, most=200000):
    """Theories of at most that many characters of numbers each, or of one step."""
    theory, length = Theory(), 0
    for line in lines:
        if theory.steps and length + len(line) > most:
            yield theory
            theory, length = Theory(), 0
        theory.add(line)
        length += len(line)
    if theory.steps:
        yield theory
