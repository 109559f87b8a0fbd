# SPDX-License-Identifier: Apache-2.0
"""What is claimed of a sign whose bound is a constant times a permanent: the value's sum with each term's magnitude.

Value and bound are sums of the same monomials, each times factors 1 + d, its roundings. The last rounding of the value
does not change its sign, so it divides the bound. Gappa proves for each monomial that the value's factor less the bound's
is at most 1, and their sum at least 1. Coq proves from that the sign itself (coq/permanent.v). Nothing may underflow or
overflow.
"""

import collections
import fractions
import math

import statement


def is_permanent(function, node):
    """Whether a bound is made of constants and magnitudes alone."""
    return (function.operation(node) == "magnitude" or function.constant(node) is not None
            or function.operation(node) in ("+", "*") and all(is_permanent(function, of) for of in function.operands(node)))


def is_atom(function, node):
    """Whether a number is exact or rounded once: an input, or a difference of two."""
    return function.is_input(node) or function.is_difference(node)


def terms(function, node):
    """A number as a sum of (coefficient, atoms, roundings)."""
    operation = function.operation(node)
    if is_atom(function, node):
        return [(fractions.Fraction(1), (node,), () if function.is_input(node) else (node,))]
    if function.constant(node) is not None:
        return [(function.constant(node), (), ())]
    left, *right = (terms(function, of) for of in function.operands(node))
    if operation == "magnitude" and len(left) == 1:
        return [(abs(coefficient), *rest) for coefficient, *rest in left]
    if operation not in ("+", "-", "*"):
        raise statement.Misuse(f"node {node} is no sum, no product and no magnitude of one term")
    if operation == "*":
        found = [(a * b, x + y, d + e) for a, x, d in left for b, y, e in right[0]]
    else:
        found = left + [(a if operation == "+" else -a, x, d) for a, x, d in right[0]]
    return [(coefficient, tuple(sorted(atoms)), (*roundings, node)) for coefficient, atoms, roundings in found]


def claim_of(function, value, bound):
    """The record of a claim: of each monomial, how its coefficients compare, and the roundings of value and bound."""
    of_value, of_bound = (sorted(terms(function, node), key=lambda term: term[1]) for node in (value, bound))
    if [atoms for _, atoms, _ in of_value] != [atoms for _, atoms, _ in of_bound]:
        raise statement.Misuse("its value and its permanent are of different monomials")
    if any(a == 0 or b <= 0 for (a, *_), (b, *_) in zip(of_value, of_bound)):
        raise statement.Misuse("a coefficient of its value is 0, or one of its bound is not positive")
    shares = [b / abs(a) for (a, *_), (b, *_) in zip(of_value, of_bound)]
    monomials = []
    for share, (_, atoms, left), (_, _, right) in zip(shares, of_value, of_bound):
        left, right = collections.Counter(left) - collections.Counter([value]), collections.Counter(right)
        roundings = [sorted(some.elements()) for some in (left & right, left - right, right - left)]
        monomials.append((share / max(shares), " * ".join(f"e{atom}" for atom in atoms), roundings))
    return {"value": max(shares) / function.unit, "nodes": [], "factor": 1, "squares_are_products": False,
            "monomials": monomials, "function": function, "compared": (value, bound)}


def roundings_of(record):
    return sorted({record["compared"][0], *(node for *_, roundings in record["monomials"] for node in sum(roundings, []))})


def claim(record, unit, constant):
    """Of each monomial, for every relative error of at most unit in every operation."""
    says, shares = statement.Statement(), sorted({share for share, *_ in record["monomials"]})
    for node in roundings_of(record):
        says.within(f"d{node}", unit)
    for number, share in enumerate(shares):
        says.constant(f"k{number}", share * constant * unit)
    for share, _, roundings in record["monomials"]:
        shared, value, bound = (" * ".join(f"(1 + d{node})" for node in nodes) or "1" for nodes in roundings)
        bound = f"k{shares.index(share)} * ({bound}) / (1 + d{record['compared'][0]})"
        says.at_most(f"{shared} * ({value} - {bound})", 1)
        says.at_least(f"{shared} * ({value} + {bound})", 1)
    return says


def least(record, unit):
    """The least double for which the claim holds."""
    needed = []
    for share, _, roundings in record["monomials"]:
        shared, value, bound = map(len, roundings)
        needed += [abs((1 + error)**-shared - (1 + error)**value) * (1 + unit) / (share * unit * (1 - unit)**bound)
                   for error in (unit, -unit)]
    nearest = float(max(needed))
    return nearest if fractions.Fraction(nearest) >= max(needed) else math.nextafter(nearest, math.inf)


def theorem(record, unit):
    """The sign, for Coq, from the claim. Differences of inputs may be any numbers."""
    says, function, (value, bound) = statement.Statement(), record["function"], record["compared"]
    for node in sorted(function.nodes):
        operation, operands = function.operation(node), function.operands(node)
        if is_atom(function, node):
            says.number(f"e{node}")
        if function.is_input(node):
            says.defined(f"c{node}", f"e{node}")
        elif function.is_difference(node):
            says.rounded(f"c{node}", f"e{node}", f"d{node}", unit)
        elif function.constant(node) is not None:
            says.constant(f"c{node}", function.constant(node))
            says.defined(f"e{node}", f"c{node}")
        elif operation == "magnitude":
            says.defined(f"c{node}", f"Rabs c{operands[0]}")
            says.defined(f"e{node}", f"Rabs e{operands[0]}")
        elif operation != "negated":
            says.rounded(f"c{node}", f"(c{operands[0]} {operation} c{operands[1]})", f"d{node}", unit)
            says.defined(f"e{node}", f"(e{operands[0]} {operation} e{operands[1]})")
    says.goals = [("", f"(c{bound} < c{value} -> 0 < e{value})"), ("", f"(c{value} < - c{bound} -> e{value} < 0)")]
    names = [f"d{node} within_d{node}" for node in roundings_of(record)]
    constants = ["_ eq_refl"] * len({share for share, *_ in record["monomials"]})
    return "\n".join([
        "Require Import Touchstone.permanent.", "", "Theorem sign : (", f"{says.for_coq()})%R.", "Proof.", says.introduced_in_coq(),
        f"destruct (proved {' '.join(names + constants)}) as",
        f"  ({' & '.join(f'below{i} & above{i}' for i in range(len(record['monomials'])))}).",
        *(f"generalize (weighed ({atoms}) _ _ _ (conj below{i} above{i})); clear below{i} above{i}."
          for i, (_, atoms, _) in enumerate(record["monomials"])),
        "rewrite ?Rabs_mult.", *(f"abstracted {name}." for name in names), "intros; decided.", "Qed.", "",
        "Print Assumptions sign.", ""])
