# SPDX-License-Identifier: Apache-2.0
"""What is claimed of sums of products of double-doubles, from their records.

Two lines of operations are recorded: those of words, each rounded to within u = 2^-53 of its result, with error-free
transformations, whose rests are exact; and those of numbers, without any rounding, that they stand for. As in signs.py
the model has no scale, and maxima are 1.

Gappa's intervals do not see that rests cancel roundings, so the difference of the two lines is multiplied out here. It
is a hint, an identity that Gappa reports and Coq refuses if it is none.
"""

import collections
import fractions

import statement

UNIT = fractions.Fraction(1, 2**53)
# A number of magnitude at most 1 has words that are at most so large, the lower one times UNIT.
WORD = 1 + 2 * UNIT


def multiplied_out(nodes, inputs, roundings):
    """Each node as a polynomial: a dictionary from sorted tuples of symbols to coefficients.

    Symbols are inputs, `inputs(node)`, and where `roundings` is set the rounding of each operation, ("rounding", node).
    """
    values = {}
    for node in nodes:
        value = collections.Counter()
        if "input" in node:
            value.update(inputs(node))
        elif node["operation"] == "rest":
            value[(("rounding", node["of"][0]),)] = 0 if "forgotten" in node else -1
        else:
            left, right = (values[i] for i in node["of"])
            if node["operation"] == "*":
                for a, x in left.items():
                    for b, y in right.items():
                        value[tuple(sorted(a + b))] += x * y
            else:
                value.update(left)
                (value.update if node["operation"] == "+" else value.subtract)(right)
            if roundings:
                value[(("rounding", node["node"]),)] = 1
        values[node["node"]] = value
    return values


def claim(record, constant):
    """|computed - exact| <= constant u^2, for every relative error of at most u in every operation."""
    says, rounding, words_of = statement.Statement(), {}, {}
    for node in record["words"]:
        name = f"c{node['node']}"
        if "input" in node:
            number, word = node["input"].split()
            says.comment(f"{number}, {word} word: {name}")
            says.within(name, WORD if word == "high" else WORD * UNIT)
            words_of.setdefault(number, []).append(name)
        elif node["operation"] == "rest":
            factor = "0 * " if "forgotten" in node else "-"
            says.defined(name, f"{factor}{rounding[node['of'][0]]}")
        else:
            left, right = node["of"]
            operation = f"c{left} {node['operation']} c{right}"
            says.operation(name, operation, f"d{node['node']}", UNIT)
            rounding[node["node"]] = f"({name} - ({operation}))"
    for node in record["exact"]:
        name = f"e{node['node']}"
        if "input" in node:
            says.defined(name, " + ".join(words_of[node["input"]]))
        else:
            left, right = node["of"]
            says.defined(name, f"e{left} {node['operation']} e{right}")
    error = f"c{record['high']} + c{record['low']} - e{record['exact'][-1]['node']}"
    says.at_most(error, constant * UNIT * UNIT)
    says.hints.append(statement.Hint(error, difference(record, words_of, rounding)))
    return says


def faulty(record):
    """The record once for each error-free transformation, with its rest forgotten."""
    for rest in record["words"]:
        if rest.get("operation") == "rest":
            yield dict(record, words=[dict(node, forgotten=True) if node is rest else node for node in record["words"]])


def difference(record, words_of, rounding):
    """The computed number less the exact one, multiplied out."""
    words = multiplied_out(record["words"], lambda node: {(("word", f"c{node['node']}"),): 1}, True)
    exact = multiplied_out(record["exact"], lambda node: {(("word", word),): 1 for word in words_of[node["input"]]}, False)
    total = collections.Counter(words[record["high"]])
    total.update(words[record["low"]])
    total.subtract(exact[record["exact"][-1]["node"]])
    terms = []
    for symbols, coefficient in sorted(total.items()):
        if coefficient:
            factors = [rounding[value] if kind == "rounding" else value for kind, value in symbols]
            terms.append(" * ".join([str(coefficient), *factors]))
    return " + ".join(f"({term})" for term in terms)
