# SPDX-License-Identifier: Apache-2.0
"""What is claimed of the quotient, the reciprocal and the root of double-doubles, from what they are recorded to do.

Every operation on words is off by at most u = 2^-53 of its result, sums and differences of double-doubles by
3 u^2 + 13 u^3, products by 7 u^2 [joldes2017]; the high word by 2^-53 of itself from its double-double. The model has no
scale, so operands are 1. The result's error is an identity in all these errors, which is written by hand; that it is
one for the recorded operations Gappa and Coq check.
"""

import fractions

import statement

UNIT = fractions.Fraction(1, 2**53)
ERRORS = {"/": UNIT, "+": UNIT, "-": UNIT, "*": UNIT, "sqrt": UNIT, "high": UNIT * (1 + 2 * UNIT),
          "double-double +": 3 * UNIT**2 + 13 * UNIT**3, "double-double -": 3 * UNIT**2 + 13 * UNIT**3,
          "double-double *": 7 * UNIT**2}


def exact(node, values, unrounded):
    """What an operation would be without its rounding."""
    operation, operands = node["operation"], [values[i] for i in node["of"]]
    if operation == "high":
        return operands[0]
    if operation == "rest":
        return f"({unrounded[node['of'][0]]} - {operands[0]})"
    if operation == "doubled":
        return f"(2 * {operands[0]})"
    if operation == "sqrt":
        return f"(sqrt({operands[0]}))"
    return f"({operands[0]} {operation[-1]} {operands[1]})"


def claim(record, constant):
    """|computed / exact - 1| <= constant u^2."""
    values = {node["node"]: "1" for node in record["numbers"] if "input" in node or node.get("constant") == 1}
    operations = [node for node in record["numbers"] if "operation" in node]
    says, unrounded, of_kind = statement.Statement(), {}, {}
    operands = {i for node in operations if node["operation"] != "exact +" for i in node["of"]}
    for node in operations:
        number, operation = node["node"], node["operation"]
        if operation in ("high", "low", "rest") and number not in operands:
            continue  # words that no operation reads, and rests that are part of exact sums alone
        if operation == "exact +":
            values[number] = unrounded[node["of"][0]]  # a rounded operation and its rest
            continue
        values[number] = f"c{number}"
        if operation == "low":  # what the high word leaves
            high, = (n for n in of_kind["high"] if n["of"] == node["of"])
            unrounded[number] = f"({values[node['of'][0]]} - c{high['node']})"
        else:
            unrounded[number] = exact(node, values, unrounded)
        of_kind.setdefault(operation, []).append(node)
        if operation in ERRORS:
            says.rounded(f"c{number}", unrounded[number], f"d{number}", ERRORS[operation])
        else:
            says.defined(f"c{number}", unrounded[number])
    error = f"{values[record['result']]} - 1"
    says.at_most(error, constant * UNIT * UNIT)
    for node in of_kind.get("+", []):  # a quick two-sum is exact where the first number is the larger one
        larger, smaller = node["of"]
        says.at_least(f"c{larger}", fractions.Fraction(1, 2))
        says.at_most(f"c{smaller}", fractions.Fraction(1, 2))
    identity, *hints = {"/": of_quotient, "reciprocal": of_reciprocal, "sqrt": of_root}[record["instance"]](of_kind)
    says.hints += [statement.Hint(error, *identity), *(statement.Hint(*hint) for hint in hints)]
    return says


def of_quotient(of_kind):
    """What the error is, and further hints.

    1 = R + P where R = 1 - P: what is left over is known through the products and differences, not the quotients.
    """
    first, second, third = (node["node"] for node in of_kind["/"])
    divisor = of_kind["/"][0]["of"][1]
    high, second_high = (node["of"][0] for node in of_kind["/"][1:])
    product, second_product = (node["node"] for node in of_kind["double-double *"])
    rest, second_rest = (node["node"] for node in of_kind["double-double -"])
    total, = (node["node"] for node in of_kind["double-double +"])
    return [(f"d{total} * (c{first} + c{second} + c{third}) - ((c{second_rest} - c{third})"
             f" + c{second} * d{second_product} - (c{rest} - c{second_product}) * d{second_rest}"
             f" + c{first} * d{product} - (1 - c{product}) * d{rest})",),
            (f"c{rest} - c{second_product}", f"-c{rest} * ((1 + d{high}) * (1 + d{second}) * (1 + d{second_product})"
             f" / c{divisor} - 1)", f"c{divisor}"),
            (f"c{second_rest} - c{third}", f"-c{second_rest} * ((1 + d{second_high}) * (1 + d{third}) / c{divisor} - 1)",
             f"c{divisor}")]


def of_reciprocal(of_kind):
    """What the error is, and further hints.

    1 = R + P as above, where P is the exact product with both words; R^2 is what Newton's step leaves out.
    """
    first, = (node["node"] for node in of_kind["/"])
    high, low = of_kind["high"][0]["node"], of_kind["low"][0]["node"]
    product, of_low, step = (node["node"] for node in of_kind["*"])
    after_high, after_rest, rest = (node["node"] for node in of_kind["-"])
    product_rest, = (node["node"] for node in of_kind["rest"])
    left, before = f"(c{after_high} - c{product_rest})", f"(c{after_rest} - c{of_low})"
    return [(f"c{first} * (c{rest} * d{step} + {before} * d{rest} - (c{low} * c{first}) * d{of_low}"
             f" + {left} * d{after_rest} + (1 - c{product}) * d{after_high}) - (1 - c{first}) * (1 - c{first})",),
            (f"1 - c{first}", f"-((1 + d{first}) / c{high} - 1)", f"c{high}"),
            (f"1 - c{product}", f"-(d{first} + d{product} + d{first} * d{product})", f"c{high}"),
            (left[1:-1], f"(1 - c{product}) * d{after_high} - d{first}", f"c{high}")]


def of_root(of_kind):
    """What the error is, and a further hint.

    The rest 1 - root^2 is a product of two numbers, and half of it over the root is Newton's step.
    """
    root, = (node["node"] for node in of_kind["sqrt"])
    rest, = (node["node"] for node in of_kind["double-double -"])
    quotient, = (node["node"] for node in of_kind["/"])
    high = of_kind["/"][0]["of"][0]
    return [(f"(1 - c{root}) * ((1 + c{root}) / (2 * c{root})"
             f" * ((1 + d{rest}) * (1 + d{high}) * (1 + d{quotient})) - 1)", f"c{root}"),
            (f"c{rest}", f"(1 - c{root}) * (1 + c{root}) * (1 + d{rest})")]
