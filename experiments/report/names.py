# SPDX-License-Identifier: GPL-3.0-or-later
"""What the names in the data are called in pictures and on pages."""

# near-edge and tradeoff: what is crossed, the test that crosses it, where polygons are, and how far away.
THRESHOLDS = ["face", "edge", "vertex", "tangent", "foot-edge", "foot-vertex"]
OWN_TEST = {"face": "plane", "edge": "edges", "vertex": "edges", "tangent": "plane", "foot-edge": "foot",
            "foot-vertex": "foot"}
TITLES = {"face": "radius at a face", "edge": "radius at an edge", "vertex": "radius at a vertex",
          "tangent": "radius exactly tangent", "foot-edge": "foot crosses an edge", "foot-vertex": "foot passes a vertex"}
PLACEMENTS = {"planar": "exactly planar polygons",
              "lattice-frame": "exactly planar polygons on an integer lattice, whose coordinates have few bits",
              "rotated": "rotated polygons, vertices rounded to doubles"}
DISTANCES = {0: "at the origin", 1000: "10³ sizes away", 1000000: "10⁶ sizes away"}

# Methods that a sentence names, and in what words.
NAMED = {"fast": "careful plain doubles", "cgal-double": "CGAL’s kernel of plain doubles", "thesis": "the method of the 2008 thesis",
         "fast-float": "floats, to which the input is rounded first"}


def of_method(name):
    """HTML: its words, and its name."""
    return f"{NAMED[name]} (<code>{name}</code>)"
