# SPDX-License-Identifier: Apache-2.0
"""What a claim says, in numbers: written once, printed for Gappa [melquiond2007] and for Coq.

A rounded operation is written with its error, computed = exact * (1 + error), which both understand.
"""

import copy
import dataclasses
import fractions


class Misuse(Exception):
    """A use from which no claim follows."""


def power_of_two(value):
    """A Fraction as (numerator, exponent), the numerator odd or 0."""
    if value.denominator & (value.denominator - 1):
        raise ValueError(f"{value} is not a dyadic number")
    numerator, exponent = value.numerator, 1 - value.denominator.bit_length()
    while numerator and numerator % 2 == 0:
        numerator, exponent = numerator // 2, exponent + 1
    return (numerator, exponent) if numerator else (0, 0)


def in_gappa(value):
    numerator, exponent = power_of_two(value)
    return f"{numerator}b{exponent}"


def in_coq(value):
    numerator, exponent = power_of_two(value)
    return f"dyadic {numerator} {exponent if exponent >= 0 else f'({exponent})'}"


@dataclasses.dataclass
class Hint:
    """An identity, `left` equals `right`, that Gappa is to use where `nonzero` is not zero. Coq proves it."""
    left: str
    right: str
    nonzero: str = ""

    def for_gappa(self):
        return f"{self.left} -> {self.right}{f' {{ {self.nonzero} <> 0 }}' if self.nonzero else ''};"


class Statement:
    """Numbers, what is known of them, and the goals: inequalities that follow."""

    def __init__(self):
        self.goals, self.hints = [], []
        self._definitions, self._hypotheses, self._premises, self._introductions = [], [], [], []

    def comment(self, text):
        self._definitions.append(f"# {text}")
        self._premises.append(f"(* {text} *)")

    def within(self, name, largest):
        """A number of magnitude at most `largest`."""
        self._hypotheses.append(f"|{name}| <= {in_gappa(largest)}")
        self._premises.append(f"forall {name}, within ({in_coq(largest)}) {name} ->")
        self._introductions.append(f"{name} within_{name}")

    def known(self, computed, exact, largest, error):
        """A number: the computed one is at most `largest` in magnitude, at most `error` from the exact one."""
        self._hypotheses += [f"|{computed}| <= {in_gappa(largest)}", f"|{computed} - {exact}| <= {in_gappa(error)}"]
        known = f"known ({in_coq(largest)}) ({in_coq(error)}) {computed} {exact}"
        self._premises.append(f"forall {computed} {exact}, {known} ->")
        self._introductions.append(f"{computed} {exact} [within_{computed} near_{computed}]")

    def rounded(self, name, expression, error, unit):
        """The number is the expression, in parentheses or one word, times 1 + error, |error| <= unit."""
        self._definitions.append(f"{name} = {expression} * (1 + {error});")
        self._hypotheses.append(f"|{error}| <= {in_gappa(unit)}")
        self._premises.append(f"forall {name}, rounded ({in_coq(unit)}) {expression} {name} ->")
        self._introductions.append(f"{name} [{error} [within_{error} ->]]")

    def underflowing(self, name, expression, error, unit, underflow):
        """As an operation, with an absolute error of at most `underflow` besides."""
        self._definitions.append(f"{name} = ({expression}) * (1 + {error}) + t{name};")
        self._hypotheses += [f"|{error}| <= {in_gappa(unit)}", f"|t{name}| <= {in_gappa(underflow)}"]
        self._premises.append(f"forall {name}, underflowing ({in_coq(unit)}) ({in_coq(underflow)}) ({expression}) {name} ->")
        self._introductions.append(f"{name} [{error} [t{name} [within_{error} [within_t{name} ->]]]]")
        self.hints.append(Hint(f"{name} - ({expression})", f"({expression}) * {error} + t{name}"))

    def number(self, name):
        self._premises.append(f"forall {name} : R,")
        self._introductions.append(name)

    def constant(self, name, value):
        self._definitions.append(f"{name} = {in_gappa(value)};")
        self._premises.append(f"forall {name}, {name} = {in_coq(value)} ->")
        self._introductions.append(f"{name} ->")

    def operation(self, name, expression, error, unit):
        """An operation that is rounded, an error of its own, and Gappa told so."""
        self.rounded(name, f"({expression})", error, unit)
        self.hints.append(Hint(f"{name} - ({expression})", f"({expression}) * {error}"))

    def defined(self, name, expression):
        self._definitions.append(f"{name} = {expression};")
        self._premises.append(f"forall {name}, {name} = {expression} ->")
        self._introductions.append(f"{name} ->")

    def at_most(self, expression, bound):
        """A goal: the expression's magnitude is at most the bound."""
        self.goals.append((f"|{expression}| <= {in_gappa(bound)}", f"Rabs ({expression}) <= {in_coq(bound)}"))

    def at_least(self, expression, bound):
        """A goal: the expression is at least the bound."""
        self.goals.append((f"{expression} >= {in_gappa(bound)}", f"{in_coq(bound)} <= {expression}"))

    def with_goal(self, goal):
        """The same statement with this goal alone."""
        alone = copy.copy(self)
        alone.goals = [goal]
        return alone

    def for_gappa(self):
        return ("\n".join(self._definitions) + "\n{ " + " /\\\n  ".join(self._hypotheses) + "\n  -> "
                + " /\\ ".join(gappa for gappa, _ in self.goals) + " }\n"
                + "".join(hint.for_gappa() + "\n" for hint in self.hints))

    def for_coq(self):
        """The proposition."""
        return "\n".join(self._premises) + "\n" + " /\\\n".join(coq for _, coq in self.goals)

    def introduced_in_coq(self):
        """A proof up to the goals: what is rounded or defined is replaced by its expression."""
        return "".join(f"intros {names}.\n" for names in self._introductions)
