# SPDX-License-Identifier: Apache-2.0
"""Gappa scripts from recorded operations, and what Gappa says to them [melquiond2007].

Maxima are 1: with relative errors alone, scaling every input of a group scales result and bound alike.
"""

import re
import subprocess

OPERATORS = {"+": "add_rel", "-": "sub_rel", "*": "mul_rel"}


def dyadic(value):
    """A Fraction whose denominator is a power of two, as Gappa writes it."""
    if value.denominator & (value.denominator - 1):
        raise ValueError(f"{value} is not a dyadic number")
    return f"{value.numerator}b-{value.denominator.bit_length() - 1}"


def script(record, unit, constant):
    """|computed - exact| <= constant factor unit, for every relative error of at most unit in every operation."""
    precision = unit.denominator.bit_length() - 1  # add_rel<p>: relative error at most 2^-p
    operations = [(node["operation"], *node["of"]) for node in record["nodes"] if "of" in node]
    if len(set(operations)) < len(operations):
        raise ValueError("an operation is carried out twice; Gappa would take both to have the same error")
    definitions, hypotheses = [], []
    for node in record["nodes"]:
        name = node["node"]
        if "input" in node:
            # Where squares are products, their right factor is another number under the same hypotheses.
            for name in (name, f"{name}_right") if record["squares_are_products"] else (name,):
                definitions.append(f"# {node['input']}: computed c{name}, exact e{name}")
                hypotheses.append(f"|c{name}| <= 1")
                hypotheses.append(f"|c{name} - e{name}| <= {dyadic(node['error'] * unit)}")
        else:
            left, right = node["of"]
            if left == right and record["squares_are_products"]:
                right = f"{right}_right"
            definitions.append(f"c{name} = {OPERATORS[node['operation']]}<{precision}>(c{left}, c{right});")
            definitions.append(f"e{name} = e{left} {node['operation']} e{right};")
    result = record["nodes"][-1]["node"]
    goal = f"|c{result} - e{result}| <= {dyadic(constant * record['factor'] * unit)}"
    return "\n".join(definitions) + "\n{ " + " /\\\n  ".join(hypotheses) + "\n  -> " + goal + " }\n"


def proves(program, text, unit):
    """True if Gappa proves the script, False if it refuses; anything else is an error."""
    digits = 2 * unit.denominator.bit_length() + 64
    # Hints with a denominator say that it must be shown not to be zero; that they are identities is checked but for that.
    result = subprocess.run([program, "-Wno-null-denominator", f"-Eprecision={digits}"], input=text, capture_output=True, text=True)
    complaint = result.stdout + result.stderr
    if result.returncode == 0 and not complaint.strip():
        return True
    if result.returncode == 1 and re.search(r"some (properties|enclosures) were not satisfied", complaint):
        return False
    raise RuntimeError(f"gappa ends with status {result.returncode}: {complaint[-600:]}\n{text}")
