# SPDX-License-Identifier: GPL-3.0-or-later
"""What the names in the data are called in pictures and on pages."""

# near-edge and tradeoff: what is crossed, the test that crosses it, where polygons are, and how far away.
THRESHOLDS = ["face", "edge", "vertex", "tangent", "foot-edge", "foot-vertex"]
OWN_TEST = {"face": "plane", "edge": "edges", "vertex": "edges", "tangent": "plane", "foot-edge": "foot",
            "foot-vertex": "foot"}
TITLES = {"face": "radius at a face", "edge": "radius at an edge", "vertex": "radius at a vertex",
          "tangent": "radius exactly tangent", "foot-edge": "foot crosses an edge", "foot-vertex": "foot passes a vertex"}
PLACEMENTS = {"lattice-frame": "exactly planar polygons on an integer lattice",
              "rotated": "rotated polygons, vertices rounded to doubles"}
DISTANCES = {0: "at the origin", 1000: "10³ sizes away", 1000000: "10⁶ sizes away"}

# What stability makes worse: the title of each axis, and what its levels are.
AXES = {"aspect": ("slivers", "length / width"),
        "parallel": ("near-parallel edges", "angle, radians"),
        "duplicate": ("near-duplicate vertices", "distance / size"),
        "collinear-exact": ("straight side, exactly", "vertices on it"),
        "collinear-rounded": ("straight side, rounded", "vertices on it"),
        "origin": ("away from the origin", "distance / size"),
        "small": ("small numbers", "binary exponent"),
        "large": ("large numbers", "binary exponent"),
        "mixed": ("mixed exponents", "binary orders between axes"),
        "off-plane": ("a vertex off the plane", "ulps"),
        "vertices": ("many vertices", "vertices"),
        "chain-input": ("chain of rotations,\nagainst exact on its end", "steps"),
        "chain-motion": ("chain of rotations,\nagainst the motion meant", "steps"),
        "pose-input": ("chain of pose products,\nagainst exact on its end", "steps"),
        "pose-motion": ("chain of pose products,\nagainst the motion meant", "steps"),
        "rounding": ("rounding direction", "mode"),
        "flush": ("subnormals flushed", "mode")}
MODES = {"rounding", "flush"}  # axes whose levels are not in an order
# Signs that stability computes with plain and with fused products.
SIGNS = {"orientation": "on which side of a line in the plane a point is: (b − a) × (c − a)",
         "side": "on which side of an edge the foot is: ((b − a) × (c − a)) · n",
         "line": "whether an edge's line comes within the radius: |(c − a) × (b − a)|² − r² |b − a|²",
         "plane": "whether the plane does: ((c − a) · n)² − r² n · n"}
NEARNESSES = {"one-double": "radius at the exact distance, or one double off",
              "close": "radius off by 2⁻³⁰ of the distance",
              "ample": "radius off by a quarter of the distance"}

# Methods that a sentence names, and in what words.
NAMED = {"fast": "careful plain doubles", "cgal-double": "CGAL’s kernel of plain doubles", "thesis": "the method of the 2008 thesis",
         "fast-float": "floats, to which the input is rounded first"}


def of_method(name):
    """HTML: its words, and its name."""
    return f"{NAMED[name]} (<code>{name}</code>)"


# motions: how the ball moves, and what one of the threshold radius does.
WAYS = {"across": "passes across the way to its closest point", "along": "moves along an edge", "through": "falls through the plane",
        "start": "starts near the polygon", "end": "ends near the polygon", "anywhere": "moves anywhere"}
EVENTS = {("graze", "face"): "grazes a face", ("graze", "edge"): "grazes an edge", ("graze", "vertex"): "grazes a vertex",
          ("start", "face"): "starts at a face", ("start", "edge"): "starts at an edge", ("start", "vertex"): "starts at a vertex",
          ("end", "face"): "ends at a face", ("end", "edge"): "ends at an edge", ("end", "vertex"): "ends at a vertex"}

# bench-scenes
QUESTIONS = {"any": "touches any?", "all": "touches which?", "nearest": "nearest?"}
BALLS = {"near": "near the surface", "anywhere": "anywhere", "touching": "just touching"}

# regress: the engines of the tables, in their order. Method: what it is.
ENGINES = {
    "filtered": "ours, certified",
    "fast": "ours, plain doubles",
    "fast-float": "ours, plain floats",
    "cgal-epeck-distance": "CGAL's exact kernel, squared distance",
    "cgal-epeck-intersect": "CGAL's exact kernel, do_intersect",
    "cgal-epick-distance": "CGAL's inexact constructions, squared distance",
    "cgal-double-distance": "CGAL over plain doubles, squared distance",
    "cgal-epick-intersect": "CGAL's inexact constructions, do_intersect",
    "cgal-double-intersect": "CGAL over plain doubles, do_intersect",
    "fcl": "FCL, doubles",
    "libccd": "libccd's GJK, doubles",
    "bullet": "Bullet, doubles",
    "bullet-defaults": "Bullet, doubles, within its own contact threshold",
    "bullet-float": "Bullet, its default build in floats",
    "ode": "ODE, doubles, each triangle both ways round",
    "embree-fast": "Embree's culling in floats, then our doubles",
    "thesis": "the thesis of 2008",
}
