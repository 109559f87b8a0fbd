# SPDX-License-Identifier: Apache-2.0
"""Inputs and rounding errors within the model that make the error of an expression large.

What they reach is reached: no smaller constant can be proved by anybody. To first order the worst rounding errors of
given inputs are known, from the derivative of the result by every node; inputs are tried among -1, 0 and 1, the first
of them at 1.
"""

import itertools


def value(operation, left, right, added=0):
    """What an operation would be without its rounding; one that is fused adds to a product, or subtracts from it."""
    if operation in ("+", "-"):
        return left + right if operation == "+" else left - right
    return left * right - added if operation == "fused -" else left * right + added


def computed(record, inputs, relative_errors):
    """The value of every node, with relative_errors[node] in each operation."""
    values = dict(inputs)
    for node in record["nodes"]:
        if "input" in node:
            continue
        exact = value(node["operation"], *(values[i] for i in node["of"]))
        values[node["node"]] = exact * (1 + relative_errors.get(node["node"], 0))
    return values


def derivatives(record, values):
    """The derivative of the result by every node."""
    result = record["nodes"][-1]["node"]
    derivative = {node["node"]: 0 for node in record["nodes"]}
    derivative[result] = 1
    for node in reversed(record["nodes"]):
        if "input" in node:
            continue
        *factors, last = node["of"]
        above = derivative[node["node"]]
        if node["operation"] in ("+", "-"):
            derivative[factors[0]] += above
        else:
            left, right = factors if len(factors) == 2 else node["of"]
            derivative[left] += above * values[right]
            derivative[right] += above * values[left]
        if node["operation"] != "*":
            derivative[last] += -above if node["operation"][-1] == "-" else above
    return derivative


def first_order(record, inputs):
    """The largest error of the model in units, products of units neglected."""
    values = computed(record, inputs, {})
    derivative = derivatives(record, values)
    return sum(abs(derivative[node["node"]]) * (float(node["error"]) if "input" in node else abs(values[node["node"]]))
               for node in record["nodes"])


def sign(value):
    return (value > 0) - (value < 0)


def reached(record, unit):
    """A constant that the model's error reaches, exactly, at this unit."""
    names = [node["node"] for node in record["nodes"] if "input" in node]
    corners = itertools.product((1, 0, -1), repeat=len(names) - 1)
    grid = (dict(zip(names, (1, *corner))) for corner in corners)
    inputs = max(grid, key=lambda corner: first_order(record, corner))
    values = computed(record, inputs, {})
    derivative = derivatives(record, values)
    errors = {node["node"]: unit * sign(derivative[node["node"]] * values[node["node"]]) for node in record["nodes"]}
    exact_inputs = {node["node"]: inputs[node["node"]] - sign(derivative[node["node"]]) * node["error"] * unit
                    for node in record["nodes"] if "input" in node}
    result = record["nodes"][-1]["node"]
    error = computed(record, inputs, errors)[result] - computed(record, exact_inputs, {})[result]
    return abs(error) / (unit * record["factor"])
