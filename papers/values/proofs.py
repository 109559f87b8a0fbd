# SPDX-License-Identifier: GPL-3.0-or-later
"""The claims about the recorded expressions, from the page that the proofs generate."""
import collections
import pathlib
import re

from values.latex import table

PAGE = pathlib.Path(__file__).resolve().parents[2] / "robust/proofs/CLAIMS.md"
ROW = re.compile(r"^\| `[^`]+` \| `(\w+)`([^|]*) \| [\d.]+ \| [^|]+ \| ([a-z, -]+) \| ", re.M)
ARITHMETICS = ("doubles", "floats", "double-doubles")


def files():
    return [PAGE]


def claims():
    """Constant, instance and arithmetic of each."""
    found = [(constant, instance.strip(), arithmetic) for constant, instance, arithmetics in ROW.findall(PAGE.read_text())
             for arithmetic in arithmetics.split(", ")]
    if not found or any(arithmetic not in ARITHMETICS for _, _, arithmetic in found):
        raise ValueError(f"{PAGE}: its table of claims is not understood")
    return found


def values():
    found = claims()
    yield "claims", str(len(found))
    arithmetics = collections.Counter((constant, instance) for constant, instance, _ in found)
    yield "expressions", str(len(arithmetics))
    yield "shared", str(sum(count == len(ARITHMETICS) for count in arithmetics.values()))


def tables():
    found = claims()
    of_words = {"kDot", "kCross", "kQuotient"}
    rows = [[f"signs and coordinates, in {arithmetic}", str(sum(a == arithmetic and c not in of_words for c, _, a in found))] for arithmetic in ARITHMETICS]
    rows += [["sums of products, quotients and roots of double-doubles", str(sum(c in of_words for c, _, _ in found))], None, ["all", str(len(found))]]
    yield "claims", table("lr", ["expressions", "claims"], rows)
