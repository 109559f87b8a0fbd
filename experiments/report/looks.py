# SPDX-License-Identifier: GPL-3.0-or-later
"""The colour, line and marker of each method, the same in every picture of report, thesis page and paper; and what kind of
arithmetic each uses, because a headline counts by kind: any number of variants could be added to one.

The colours are Okabe and Ito's, which all eyes tell apart, and a brown; methods of one colour differ by line and marker."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Look:
    group: str
    colour: str
    line: str
    marker: str


BLACK, BLUE, SKY, GREEN, ORANGE, RED, PURPLE, BROWN, GREY = ("#000000", "#0072B2", "#56B4E9", "#009E73", "#E69F00", "#D55E00", "#CC79A7",
                                                             "#7F6000", "#777777")

# In the order of legends.
LOOKS = {
    "filtered": Look("certified", GREEN, "-", "o"),
    "exact": Look("certified", BLACK, ":", "v"),
    "rational": Look("certified", BLACK, "--", "^"),
    "interval": Look("certified", BLACK, "-.", "D"),
    "fast": Look("fast", BLUE, "-", "s"),
    "fast-float": Look("fast", SKY, "--", "^"),
    "fast-long-double": Look("fast", BLUE, "-.", "D"),
    "fast-double-double": Look("fast", BLUE, ":", "P"),
    "fast-mpfr-101": Look("fast", BLUE, "--", "X"),
    "fast-mpfr-201": Look("fast", BLUE, "-.", "<"),
    "ericson": Look("fast", SKY, "-.", "d"),
    "ericson-absolute": Look("fast", SKY, ":", "p"),
    "hull": Look("fast", BROWN, "-", "s"),
    "convex-parts": Look("fast", BROWN, "--", "D"),
    "thesis": Look("thesis", RED, "-", "X"),
    "thesis-float": Look("thesis", RED, "--", "^"),
    "thesis-0.9999": Look("thesis", RED, "-.", "<"),
    "thesis-1": Look("thesis", RED, ":", ">"),
    "thesis-signed": Look("thesis", ORANGE, "--", "*"),
    "thesis-signed-float": Look("thesis", ORANGE, "-", "^"),
    "thesis-atan2": Look("thesis", ORANGE, ":", "v"),
    "thesis-newell": Look("thesis", ORANGE, "-.", "D"),
    "thesis-closed": Look("thesis", ORANGE, "-", "P"),
    "cgal-double": Look("CGAL", PURPLE, "-", "o"),
    "cgal-epick": Look("CGAL", PURPLE, "--", "s"),
    "cgal-epeck": Look("CGAL", PURPLE, ":", "^"),
    "cgal-double-distance": Look("CGAL", PURPLE, "-.", "v"),
    "cgal-double-intersect": Look("CGAL", PURPLE, "-", "D"),
    "cgal-epick-distance": Look("CGAL", PURPLE, "--", "P"),
    "cgal-epick-intersect": Look("CGAL", PURPLE, ":", "X"),
    "cgal-epeck-distance": Look("CGAL", PURPLE, "-.", "<"),
    "cgal-epeck-intersect": Look("CGAL", PURPLE, "-", ">"),
    "boost-geometry": Look("engines", GREY, "-", "o"),
    "fcl": Look("engines", GREY, "--", "s"),
    "libccd": Look("engines", GREY, ":", "^"),
    "bullet": Look("engines", GREY, "-.", "v"),
    "bullet-defaults": Look("engines", GREY, "--", "v"),
    "bullet-float": Look("engines", GREY, "-", "D"),
    "ode": Look("engines", GREY, "--", "P"),
    "embree-fast": Look("engines", GREY, ":", "X"),
}
# Libraries and structures that `touchstone bench-scenes` times.
LIBRARIES = {
    "Scene": LOOKS["filtered"],
    "Scene of objects": Look("certified", LOOKS["filtered"].colour, "--", "s"),
    "Scene, all together": Look("certified", LOOKS["filtered"].colour, ":", "o"),
    "Uniform grid": Look("structures", BLUE, "-", "s"),
    "Octree": Look("structures", SKY, "--", "^"),
    "k-d tree": Look("structures", BROWN, "-.", "D"),
    "Sphere tree": Look("structures", RED, ":", "<"),
    "18-DOP tree": Look("structures", ORANGE, "--", "*"),
    "CGAL AABB_tree": Look("CGAL", PURPLE, "-", "P"),
    "Embree 3": LOOKS["embree-fast"],
    "FCL BVHModel": LOOKS["fcl"],
    "Bullet": LOOKS["bullet"],
}
OF_THE_USER = Look("engines", "#555555", "--", "h")


def look_of(method):
    """Of an engine of the user, too."""
    return LOOKS.get(method, OF_THE_USER)


def in_order(methods):
    """Each once, in the order of legends; engines of the user last."""
    places = {name: place for place, name in enumerate(LOOKS)}
    return sorted(dict.fromkeys(methods), key=lambda method: places.get(method, len(places)))


def by_group(methods):
    """Each once, in the order of legends, by the title of its group."""
    groups = {}
    for method in in_order(methods):
        groups.setdefault(look_of(method).group, []).append(method)
    return groups


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
