# SPDX-License-Identifier: Apache-2.0
"""The claims that functions rest on which take signs in lanes to be certain, from what they are recorded to compute.

Such a function takes a value to be positive where it exceeds a bound, and negative where it is below minus that bound. The
record holds the operations of both comparisons, from the inputs on. It says what has to be proved: the constant and the
maxima of the bound, which numbers each maximum bounds, and the operations of the value. A maximum whose numbers the record
does not show is declared with them: a claim says that it bounds them, or a reason.
"""

import collections
import fractions
import itertools
import math

import permanents
from statement import Misuse


UNITS = {"doubles": "unit", "doubles to nearest": "nearest_unit", "double-doubles": "double_double_unit",
         "floats": "float_unit"}  # names in the model


class Function:
    """A recorded function."""

    def __init__(self, record, model):
        self.nodes = {node["node"]: node for node in record["recorded"]}
        self.unit, self.smallest, self.largest = model[UNITS[record["arithmetic"]]], model["smallest"], model["largest"]
        self.tiny, self.own_units = model["tiny"], "own_units" in record
        # Of a filter: what it compares before any sign. Where such a comparison is true, it returns no sign.
        compared = [pair for use in record["uses"]
                    for *pair, _ in itertools.takewhile(lambda of: of[-1] == 0, use.get("compared", []))]
        self.lowest = {of: self.constant(low) for low, of in compared if self.constant(low) is not None}
        self.highest = {of: self.constant(high) for of, high in compared if self.constant(high) is not None}
        self.known = collections.defaultdict(dict)  # by maximum, the errors of the numbers that it is declared to bound
        for known in record["known"]:
            self.known[known["maximum"]].update(dict.fromkeys(known["bounds"], known["error"]))

    def operation(self, node):
        return self.nodes[node].get("operation")

    def operands(self, node):
        return self.nodes[node].get("of", [])

    def constant(self, node):
        return self.nodes[node].get("constant")

    def is_input(self, node):
        return "input" in self.nodes[node]

    def is_difference(self, node):
        """Of two exact inputs: it is known to its rounding."""
        return self.operation(node) == "-" and all(self.nodes[of].get("error") == 0 for of in self.operands(node))

    def key(self, node):
        """Equal for numbers whose magnitudes differ by their rounding at most: a - b and b - a."""
        return frozenset(self.operands(node)) if self.is_difference(node) else node

    def name(self, node):
        """What a known number is called."""
        if self.is_input(node):
            return self.nodes[node]["input"]
        return " - ".join(map(self.name, self.operands(node))) if self.is_difference(node) else f"known {node}"

    def terms(self, node):
        """What a maximum is the largest of."""
        if self.operation(node) == "maximum":
            return [term for operand in self.operands(node) for term in self.terms(operand)]
        return [node]

    def bounded(self, node):
        """The keys of the numbers that a node bounds, and whether it is too large to need kTiny. None if it is no maximum."""
        if node in self.known:
            return set(map(self.key, self.known[node])), True
        keys, is_large = set(), False
        for term in self.terms(node):
            if term in self.known:
                return None  # the largest of several maxima
            if self.operation(term) == "magnitude":
                keys.add(self.key(*self.operands(term)))
            elif self.nodes[term].get("is_length") and term != node:
                keys.add(self.key(term))
            elif self.constant(term) is not None and term != node:
                is_large |= self.constant(term) >= self.smallest
            else:
                return None
        return keys, is_large

    def product(self, node):
        """A bound as (factor, products): the factor times the largest of these products, each a Counter of maxima."""
        if self.bounded(node):
            return 1, [collections.Counter([node])]
        if self.constant(node) is not None:
            return self.constant(node), [collections.Counter()]
        if self.operation(node) == "*":
            (a, left), (b, right) = map(self.product, self.operands(node))
            return a * b, [x + y for x in left for y in right]
        if self.operation(node) == "maximum":
            parts = list(map(self.product, self.terms(node)))
            if all(factor == 1 for factor, _ in parts):
                return 1, [product for _, products in parts for product in products]
        if self.operation(node) == "+" and len(set(self.operands(node))) == 1:
            factor, products = self.product(self.operands(node)[0])
            return 2 * factor, products
        raise Misuse(f"node {node} is no product of maxima")

    def error(self, node, maxima):
        """The error in units of its maximum of what the value takes as known: an input, a difference, or what a maximum is
        declared to bound. None for what it computes."""
        if self.is_input(node):
            return self.nodes[node]["error"]
        if self.is_difference(node):
            return fractions.Fraction(1)
        return next((self.known[maximum][node] for maximum in maxima if node in self.known.get(maximum, ())), None)

    def claim(self, value, bound, adds_tiny=False):
        """What has to hold of the value with this bound: its operations, and the bound's factor."""
        factor, products = self.product(bound)
        maxima = sorted(set().union(*products))
        self.check_range(factor, products, adds_tiny)
        numbers, degrees, operations = {}, {}, []

        def visit(node):
            if node in numbers:
                return
            if (error := self.error(node, maxima)) is not None:
                its = [maximum for maximum in maxima if self.key(node) in self.bounded(maximum)[0]]
                if len(its) != 1:
                    raise Misuse(f"{len(its)} maxima of the bound are those of node {node}")
                degrees[node] = [collections.Counter(its)]
                operations.append({"input": self.name(node), "error": error})
            else:
                operation, of = self.operation(node), self.operands(node)
                if operation not in ("+", "-", "*", "fused +", "fused -"):
                    raise Misuse(f"node {node} is neither known nor a sum or product")
                for operand in of:
                    visit(operand)
                terms = [degrees[operand] for operand in of]
                if operation not in ("+", "-"):
                    terms[:2] = [product_of(*terms[:2])]
                degrees[node] = [degree for i, degree in enumerate(sum(terms, [])) if degree not in sum(terms, [])[:i]]
                operations.append({"operation": operation, "of": [numbers[operand] for operand in of]})
            numbers[node] = len(numbers)
            operations[-1]["node"] = numbers[node]

        visit(value)
        if not all(degree in products for degree in degrees[value]):
            raise Misuse("value and bound are of different degrees")
        return {"factor": factor, "squares_are_products": len(products) > 1, "nodes": operations}

    def check_range(self, factor, products, adds_tiny):
        """No bound may overflow, and one without kTiny must exceed it, whatever its maxima are."""
        if self.own_units and len(products) > 1:
            raise Misuse("it adds numbers of different units")
        for product in products:
            degree = sum(count * (2 if self.is_of_second_degree(maximum) else 1) for maximum, count in product.items())
            is_large = all(self.bounded(maximum)[1] for maximum in product)
            if not adds_tiny and not (is_large and factor * self.unit * self.smallest**degree > self.tiny):
                raise Misuse("its maxima may be so small that the bound needs kTiny")
            if factor * (2 * self.largest)**degree > 2**1023:
                raise Misuse("its bound may overflow")

    def underflow(self, value, factor, products):
        """How far a product may underflow, in units of its maxima: a filter returns no sign where one is too small."""
        lowest = min(math.prod(min(self.lowest.get(of, 0), 1)**count for of, count in product.items()) for product in products)
        highest = max(math.prod(max(self.highest.get(of, 2**1024), 1)**count for of, count in product.items())
                      for product in products)
        if min(factor, 1) * lowest < fractions.Fraction(2)**-1022:
            raise Misuse("its maxima may be so small that its bound underflows")
        if max(factor, 2 * len(permanents.terms(self, value))) * highest > 2**1023:
            raise Misuse("its maxima may be so large that it overflows")
        return fractions.Fraction(2)**(lowest.denominator.bit_length() - lowest.numerator.bit_length() + 1 - 1075)

    def value_and_bound(self, comparisons):
        """What a filter compares before it returns 1 and -1."""
        signs = sorted((sign, *of) for *of, sign in comparisons if sign != 0)
        if [sign for sign, *_ in signs] != [-1, 1]:
            raise Misuse("it does not return each sign after one comparison")
        (_, negated, other), (_, value, bound) = signs
        if self.operation(negated) != "negated" or {*self.operands(negated), other} != {value, bound}:
            raise Misuse("its two comparisons are of different numbers")
        return value, bound

    def is_of_second_degree(self, maximum):
        """Whether a maximum is a sum of products, as that of a normal."""
        return any(self.operation(of) == "*" for of in self.operands(maximum))

    def claim_of_use(self, use):
        """The claim of a sign, with the constant that it takes."""
        if "compared" in use:
            value, bound = self.value_and_bound(use["compared"])
            if permanents.is_permanent(self, bound):
                return permanents.claim_of(self, value, bound)
            claim = self.claim(value, bound, adds_tiny=True)
            claim["underflow"] = self.underflow(value, *self.product(bound))
        elif "greater" in use:
            (value, error), (opposite, same) = use["greater"], use["less"]
            if same != value or self.operation(opposite) != "negated" or self.operands(opposite) != [error]:
                raise Misuse("its two comparisons are of different numbers")
            bound, *tiny = self.operands(error)
            if self.operation(error) != "+" or self.constant(tiny[0]) != self.tiny:
                raise Misuse("its error has no kTiny")
            claim = self.claim(value, bound, adds_tiny=True)
        else:
            positive, negative = self.comparison(use["positive"], "-"), self.comparison(use["negative"], "+")
            if positive != negative:
                raise Misuse("its two comparisons are of different numbers")
            constant, bound, value = positive
            claim = self.claim(value, bound)
            claim["factor"] *= self.constant(constant)
        return {**claim, "value": claim["factor"] / self.unit, "factor": fractions.Fraction(1)}

    def check_decisions(self, record):
        """Every sign on which the function was seen to decide must be one of its uses."""
        claimed = {node for use in record["uses"] for node in (use.get("positive"), use.get("negative"))}
        claimed.update(record["ignored"])
        open_nodes = list(record["decided"])
        while open_nodes:
            node = open_nodes.pop()
            if self.operation(node) in ("both", "either"):
                open_nodes += self.operands(node)
            elif node not in claimed:
                raise Misuse(f"it decides by node {node}, of which there is no claim")

    def comparison(self, node, operation):
        """(constant, bound, value): the node is constant * bound - value, or their sum."""
        of = self.operands(node)
        if self.operation(node) == operation and self.operation(of[0]) == "*":
            of = [*self.operands(of[0]), of[1]]
        elif self.operation(node) != f"fused {operation}":
            raise Misuse(f"node {node} compares no value with a bound")
        if self.constant(of[0]) is None:
            raise Misuse(f"node {node} has no constant")
        return tuple(of)


def product_of(left, right):
    if len(left) != 1 or len(right) != 1:
        raise Misuse("it multiplies sums of different degrees")
    return [left[0] + right[0]]


def claims(model, records):
    """The record of each claim that functions rest on, as those of expressions.h, with all uses that rest on it."""
    found = {}

    def checked(record, name, what):
        try:
            return what()
        except Misuse as misuse:
            raise Misuse(", ".join(filter(None, (record["function"], record["target"], name))) + f": {misuse}") from None

    def add(record, name, claim_of):
        claim = checked(record, name, claim_of)
        claim = {"arithmetic": record["arithmetic"], **claim}
        key = repr([{**node, "input": ""} if "input" in node else node for node in claim["nodes"]] + [claim["value"], claim["factor"],
                   claim["squares_are_products"], claim["arithmetic"], "is_within_maximum" in claim, claim.get("monomials"), claim.get("underflow")])  # whatever its inputs are called
        found.setdefault(key, (claim, []))[1].append(f"{record['function']} {name}")

    for record in records:
        function = Function(record, model)
        checked(record, "its decisions", lambda: function.check_decisions(record))
        for known in filter(lambda known: known["constant"], record["known"]):
            assumed = function.known.pop(known["maximum"])
            for node in known["bounds"]:
                add(record, known["constant"], lambda: {"value": known["error"], "is_within_maximum": True,
                                                        **function.claim(node, known["maximum"], adds_tiny=True)})
            function.known[known["maximum"]] = assumed
        for use in record["uses"]:
            add(record, use["name"], lambda: function.claim_of_use(use))
    return [dict(claim, constant=names[0], instance="", uses=sorted(set(names))) for claim, names in found.values()]
