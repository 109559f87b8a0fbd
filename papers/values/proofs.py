# SPDX-License-Identifier: GPL-3.0-or-later
"""The claims about the recorded expressions, from the page that the proofs generate; and the bounds that they prove."""
import pathlib
import re

from values.latex import table

ROBUST = pathlib.Path(__file__).resolve().parents[2] / "robust"
PAGE, BOUNDS = ROBUST / "proofs/CLAIMS.md", ROBUST / "filtered/detail/signs/bounds.h"
SIGNS = re.compile(r"^\| \[.*\| ([a-z, -]+) \|$", re.M)  # a row of signs, by its arithmetics
PARTS = re.compile(r"^\| `[^`]+` \| `(\w+)`.*\| ([a-z, -]+) \|$", re.M)
COUNTED = re.compile(r"From (\d+) of them follow the (\d+) signs")
ARITHMETICS = {"doubles": "doubles", "fused doubles": "doubles, fused", "double-doubles": "double-doubles", "floats": "floats",
               "fused floats": "floats, fused"}
BOUNDED = [  # expression, maxima, constant of bounds.h
    (r"$w\cdot w-r^2$", "$m_w^2$", "kVertex"),
    (r"$w\cdot e$", "$m_wm_e$", "kAlong"),
    (r"$w\cdot e-e\cdot e$", r"$m_e\max(m_w,m_e)$", "kBeyond"),
    (r"$|e\times w|^2-r^2\,e\cdot e$", "$m_w^2m_e^2$", "kLine"),
    (r"$N\cdot w$", "$m_Nm_w$", "kFront"),
    (r"$(N\cdot w)^2-r^2\,N\cdot N$", "$m_N^2m_w^2$", "kPlane"),
    (r"$N\cdot(e\times w)$", "$m_Nm_em_w$", "kSide"),
    (r"$(N\cdot N)\,w_k-(N\cdot w)\,N_k$", "$m_N^2m_w$", "kAbove"),
    (r"$u\times v$", "$2m_um_v$", "kNormal"),
]
IN_FRAME = [("height above the plane in the frame", "$S$", "kHeight"),
            ("along, across an edge in the frame", "$S$", "kEdgeFrame")]


def files():
    return [PAGE, BOUNDS]


def claims():
    """Constant ("" for a sign) and arithmetic of each."""
    text = PAGE.read_text()
    signs = [("", arithmetic) for arithmetics in SIGNS.findall(text) for arithmetic in arithmetics.split(", ")]
    parts = [(constant, arithmetic) for constant, arithmetics in PARTS.findall(text) for arithmetic in arithmetics.split(", ")]
    if str(len(signs)) != COUNTED.search(text)[1] or not parts or any(arithmetic not in ARITHMETICS for _, arithmetic in signs + parts):
        raise ValueError(f"{PAGE}: its tables of claims are not understood")
    return signs + parts


def bounds():
    constants = dict(re.findall(r"constexpr double (k\w+) = ([\d.]+);", BOUNDS.read_text()))
    row = lambda words, maxima, constant: [words, maxima, f"{float(constants[constant]):.4f}"]
    return table("llr", ["sign of", "maxima", "constant"], [*(row(*sign) for sign in BOUNDED), None, *(row(*quantity) for quantity in IN_FRAME)])


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
    yield "bounds", bounds()
    yield "claims", table("lr", ["expressions", "claims"], rows)
