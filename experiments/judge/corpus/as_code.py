#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: as_code.py LANGUAGE CASES... > FILE

Prints cases with their certified answers as code, for the tests of a project that neither builds nor runs Touchstone.
LANGUAGE is c (a header in C99, also for C++), rust or python. Each number is written exactly. Coordinates and radii have
the type of floats if all of them are floats, else that of doubles; answers are doubles. An answer that the contract calls
null is not a number. Cases of rejected input are left out.
"""
import json
import pathlib
import re
import struct
import sys

ABOUT = """Certified cases of Touchstone's corpus: does a ball touch a planar polygon?

Each case has a ball, the end of its motion if it moves, a polygon (loops of vertices: the outer loop, then the holes) and
the exact answer, rounded once: contact, and for balls at a place distance, depth, point and normal; for moving balls the
time of first contact, with its point and normal. `planar` says whether the vertices lie in one plane exactly. `size` is the
largest magnitude of the case's coordinates and radius: an engine that rounds may leave out balls at a place whose depth is
below, say, 2^-20 of it.

The cases are licensed under CC-BY-4.0: copy them, and name Touchstone."""


class Case:
    def __init__(self, case):
        answer = case["expected"]
        self.id = case["id"]
        self.center, self.radius = case["ball"]["center"], case["ball"]["radius"]
        self.moves = "motion" in case
        self.to = case["motion"]["to"] if self.moves else self.center
        polygon = case["polygon"]
        self.loops = [polygon["outer"], *polygon.get("holes", [])]
        if polygon.get("closed"):  # the first point of each loop is there again
            self.loops = [loop[:-1] for loop in self.loops]
        self.vertices = [vertex for loop in self.loops for vertex in loop]
        self.planar, self.contact = answer["off_plane"] == 0, answer["contact"]
        self.time, self.distance, self.depth = (answer.get(key) for key in ("time", "distance", "depth"))
        self.point, self.normal = (answer[key] or [None] * 3 for key in ("point", "contact_normal"))
        self.size = max(abs(number) for number in self.numbers())

    def numbers(self):
        """Those of the question."""
        return [*self.center, self.radius, *self.to, *(x for vertex in self.vertices for x in vertex)]


def is_float(number):
    try:
        return struct.unpack("f", struct.pack("f", number))[0] == number
    except OverflowError:
        return False


def read(files):
    cases = []
    for file in files:
        try:
            lines = pathlib.Path(file).read_text(encoding="utf-8").split("\n")
        except (OSError, UnicodeDecodeError) as error:
            raise SystemExit(f"{file}: cannot be read: {error}")
        for number, line in enumerate(lines, 1):
            try:
                if not line.strip():
                    continue
                case = json.loads(line)
                if "mesh" in case:
                    raise ValueError("it asks about a mesh, and the code has polygons alone")
                if "error" not in case["expected"]:
                    cases.append(Case(case))
            except (ValueError, KeyError, TypeError) as error:
                raise SystemExit(f"{file}: line {number}: is not a case with its whole answer: {error!r}")
    if not cases:
        raise SystemExit("there is no case with an answer")
    return cases


def quoted(text, escape):
    """A string of C or Rust: all that is not a plain character is escaped."""
    return '"' + "".join(c if c.isascii() and c.isprintable() and c not in '"\\?' else escape(c) for c in text) + '"'


def octal(character):
    return "".join(f"\\{byte:03o}" for byte in character.encode("utf-8", "surrogatepass"))


def scalar(character):
    return f"\\u{{{ord(character) if not 0xD800 <= ord(character) < 0xE000 else 0xFFFD:x}}}"  # Rust has no surrogates


def code(cases, comment, vector, case, begin_vertices, begin_loops, begin_cases, end, before, after=""):
    """The code: vertices and sizes of loops, each in one list, and the cases, which say where theirs begin."""
    lines = [f"{comment} {line}".rstrip() for line in ABOUT.split("\n")] + ["", before, begin_vertices]
    lines += [f"  {vector(vertex)}," for one in cases for vertex in one.vertices]
    lines += [end, "", begin_loops, *(f"  {', '.join(str(len(loop)) for loop in one.loops)}," for one in cases), end, "", begin_cases]
    vertices = loops = 0
    for one in cases:
        lines.append(f"  {case(one, loops, vertices)},")
        vertices, loops = vertices + len(one.vertices), loops + len(one.loops)
    return "\n".join([*lines, end, after])


def in_c(cases, real):
    def number(x):
        return "NAN" if x is None else re.sub("\\.?0*p", "p", float(x).hex())

    def exact(x):
        return number(x) + ("f" if real == "float" else "")

    def vector(v, of=exact):
        return "{" + ", ".join(map(of, v)) + "}"

    def case(one, loops, vertices):
        return "{" + ", ".join((
            quoted(one.id, octal), vector(one.center), exact(one.radius), str(int(one.moves)), vector(one.to), str(len(one.loops)),
            f"touchstone_loops + {loops}", f"touchstone_vertices + {vertices}", str(int(one.planar)), str(int(one.contact)),
            number(one.time), number(one.distance), number(one.depth), vector(one.point, number), vector(one.normal, number),
            number(one.size))) + "}"

    before = f"""#ifndef TOUCHSTONE_CASES_H
#define TOUCHSTONE_CASES_H

#include <math.h>

typedef {real} touchstone_real;

typedef struct {{
  const char *id;
  touchstone_real center[3], radius;
  int moves;              /* 0: the ball is at a place */
  touchstone_real to[3];  /* where its centre ends */
  int loops;              /* how many: the outer loop and the holes */
  const int *loop_sizes;
  const touchstone_real (*vertices)[3];  /* of all loops, one after the other */
  int planar, contact;
  double time, distance, depth, point[3], normal[3], size;
}} touchstone_case;

#define TOUCHSTONE_CASES {len(cases)}
"""
    return code(cases, "//", vector, case, "static const touchstone_real touchstone_vertices[][3] = {",
                "static const int touchstone_loops[] = {", "static const touchstone_case touchstone_cases[TOUCHSTONE_CASES] = {", "};", before,
                "\n#endif\n")


def in_rust(cases, real):
    kind = {"float": "f32", "double": "f64"}[real]

    def number(x):
        return "f64::NAN" if x is None else repr(float(x))

    def vector(v):
        return "[" + ", ".join(map(number, v)) + "]"

    def case(one, loops, vertices):
        fields = {"id": quoted(one.id, scalar), "center": vector(one.center), "radius": number(one.radius), "moves": str(one.moves).lower(),
                  "to": vector(one.to), "loops": f"({loops}, {len(one.loops)})", "vertices": f"({vertices}, {len(one.vertices)})",
                  "planar": str(one.planar).lower(), "contact": str(one.contact).lower(), "time": number(one.time),
                  "distance": number(one.distance), "depth": number(one.depth), "point": vector(one.point),
                  "normal": vector(one.normal), "size": number(one.size)}
        return "Case { " + ", ".join(f"{name}: {value}" for name, value in fields.items()) + " }"

    before = f"""pub type Real = {kind};

pub struct Case {{
    pub id: &'static str,
    pub center: [Real; 3],
    pub radius: Real,
    pub moves: bool,
    pub to: [Real; 3],
    pub loops: (usize, usize),    // the first of them in LOOPS, which has their sizes, and how many
    pub vertices: (usize, usize), // the first of them in VERTICES, and how many
    pub planar: bool,
    pub contact: bool,
    pub time: f64,
    pub distance: f64,
    pub depth: f64,
    pub point: [f64; 3],
    pub normal: [f64; 3],
    pub size: f64,
}}
"""
    vertices, loops = sum(len(one.vertices) for one in cases), sum(len(one.loops) for one in cases)
    return code(cases, "//", vector, case, f"pub static VERTICES: [[Real; 3]; {vertices}] = [",
                f"pub static LOOPS: [usize; {loops}] = [", f"pub static CASES: [Case; {len(cases)}] = [", "];", before)


def in_python(cases, _):
    def number(x):
        return "nan" if x is None else repr(float(x))

    def vector(v):
        return "(" + ", ".join(map(number, v)) + ")"

    def case(one, loops, vertices):
        return "Case(" + ", ".join((
            repr(one.id), vector(one.center), number(one.radius), str(one.moves), vector(one.to), f"_loops({loops}, {len(one.loops)}, {vertices})",
            str(one.planar), str(one.contact), number(one.time), number(one.distance), number(one.depth), vector(one.point),
            vector(one.normal), number(one.size))) + ")"

    before = """from collections import namedtuple
from math import nan

Case = namedtuple("Case", "id center radius moves to loops planar contact time distance depth point normal size")


def _loops(first, count, vertex):
    loops = []
    for size in LOOPS[first:first + count]:
        loops.append(VERTICES[vertex:vertex + size])
        vertex += size
    return loops

"""
    return code(cases, "#", vector, case, "VERTICES = [", "LOOPS = [", "CASES = [", "]", before)


LANGUAGES = {"c": in_c, "rust": in_rust, "python": in_python}


def text(language, files):
    cases = read(files)
    return LANGUAGES[language](cases, "float" if all(is_float(x) for one in cases for x in one.numbers()) else "double")


if __name__ == "__main__":
    if len(sys.argv) < 3 or sys.argv[1] not in LANGUAGES:
        sys.exit(f"usage: as_code.py {'|'.join(LANGUAGES)} CASES... > FILE")
    sys.stdout.write(text(sys.argv[1], sys.argv[2:]))
