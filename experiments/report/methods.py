# SPDX-License-Identifier: GPL-3.0-or-later
"""What kinds of arithmetic methods use. A headline counts by kind, because any number of variants could be added to one."""
from looks import LOOKS

EXACT = {"filtered", "exact", "rational", "interval", "cgal-epeck", "cgal-epeck-distance", "cgal-epeck-intersect"}
MORE_DIGITS = {"fast-double-double", "fast-mpfr-101", "fast-mpfr-201"}
NOT_LIFTED = {"cgal-epeck-distance", "cgal-epeck-intersect", "convex-parts"}  # about parts of a loop, which on rotated polygons are another question
OTHER_SHAPE = {"hull"}


def rounds(method):
    """Whether a method of this program computes in floats, doubles or long doubles, whose rounding can decide its answer."""
    return method in LOOKS and method not in EXACT | MORE_DIGITS


def asks_the_question(method, placement):
    """Whether a method is asked about the polygon as the contract defines it."""
    return method not in OTHER_SHAPE and (placement != "rotated" or method not in NOT_LIFTED)
