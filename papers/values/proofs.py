# SPDX-License-Identifier: GPL-3.0-or-later
"""The claims about the recorded expressions, from the page that the proofs generate."""
import pathlib
import re

from values.latex import table

PAGE = pathlib.Path(__file__).resolve().parents[2] / "robust/proofs/CLAIMS.md"
SIGNS = re.compile(r"^\| \[.*\| ([a-z, -]+) \|$", re.M)  # a row of signs, by its arithmetics
PARTS = re.compile(r"^\| `[^`]+` \| `(\w+)`.*\| ([a-z, -]+) \|$", re.M)
COUNTED = re.compile(r"From (\d+) of them follow the (\d+) signs")
ARITHMETICS = {"doubles": "doubles", "fused doubles": "doubles, fused", "double-doubles": "double-doubles", "floats": "floats",
               "fused floats": "floats, fused"}


def files():
    return [PAGE]


def claims():
    """Constant ("" for a sign) and arithmetic of each."""
    text = PAGE.read_text()
    signs = [("", arithmetic) for arithmetics in SIGNS.findall(text) for arithmetic in arithmetics.split(", ")]
    parts = [(constant, arithmetic) for constant, arithmetics in PARTS.findall(text) for arithmetic in arithmetics.split(", ")]
    if str(len(signs)) != COUNTED.search(text)[1] or not parts or any(arithmetic not in ARITHMETICS for _, arithmetic in signs + parts):
        raise ValueError(f"{PAGE}: its tables of claims are not understood")
    return signs + parts


def values():
    found = claims()
    yield "claims", str(len(found))
    yield "of-signs", str(sum(not constant for constant, _ in found))
    yield "signs", COUNTED.search(PAGE.read_text())[2]


def tables():
    found = claims()
    of_words = {"kDot", "kCross", "kQuotient"}
    rows = [[f"signs, in {words}", str(sum(arithmetic == a and not constant for constant, a in found))]
            for arithmetic, words in ARITHMETICS.items() if ("", arithmetic) in found]
    rows += [["coordinates, products and points, in lanes and doubles", str(sum(bool(c) and c not in of_words for c, _ in found))],
             ["sums of products, quotients and roots of double-doubles", str(sum(c in of_words for c, _ in found))], None,
             ["all", str(len(found))]]
    yield "claims", table("lr", ["expressions", "claims"], rows)
