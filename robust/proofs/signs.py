# SPDX-License-Identifier: Apache-2.0
"""What is claimed of a sign or a coordinate, from its record.

Maxima are 1: with relative errors alone, scaling every input of a group scales result and bound alike.
"""

import fractions

import permanents
import statement

EXCESS = fractions.Fraction(1, 2**50)  # by which magnitudes may exceed their maximum: kExcess of expressions.h


def claim(record, unit, constant):
    """|computed - exact| <= constant factor unit, for every relative error of at most unit in every operation."""
    if "monomials" in record:
        return permanents.claim(record, unit, constant)
    says = statement.Statement()
    for node in record["nodes"]:
        name = node["node"]
        if "input" in node:
            # Where squares are products, their right factor is another number under the same hypotheses.
            for name in (name, f"{name}_right") if record["squares_are_products"] else (name,):
                says.comment(f"{node['input']}: computed c{name}, exact e{name}")
                says.known(f"c{name}", f"e{name}", 1, node["error"] * unit)
        else:
            (left, right, *added), operation = node["of"], node["operation"]
            if left == right and record["squares_are_products"]:
                right = f"{right}_right"

            def expression(prefix):
                if added:  # a product and a sum, rounded once
                    return f"{prefix}{left} * {prefix}{right} {operation[-1]} {prefix}{added[0]}"
                return f"{prefix}{left} {operation} {prefix}{right}"

            if operation == "*" and "underflow" in record:
                says.underflowing(f"c{name}", expression("c"), f"d{name}", unit, record["underflow"])
            else:
                says.operation(f"c{name}", expression("c"), f"d{name}", unit)
            says.defined(f"e{name}", expression("e"))
    result = record["nodes"][-1]["node"]
    says.at_most(f"c{result} - e{result}", constant * record["factor"] * unit)
    if "is_within_maximum" in record:  # other claims take it to be so
        says.at_most(f"c{result}", record["factor"] * (1 + EXCESS))
    return says
