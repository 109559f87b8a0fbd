#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: rejections.py ROOT [--write]

Draws docs/rejections/CODE.svg from the case of each code in docs/rejections.md: the loops seen along z, with the ball, and
what is wrong marked. Compares the drawings with the files (exit status 1 if one differs), or writes them.
"""

import json
import math
import pathlib
import re
import sys

from svg import circle, dot, drawing, path, text, write_or_compare

PAGE = "docs/rejections.md"
WIDTH, HEIGHT, MARGIN = 340, 200, 28


def cases(page):
    """The case and the sentence of each code, in the order of the page. Numbers beyond the doubles stay text."""
    number = lambda digits: digits if math.isinf(float(digits)) else float(digits)
    entries = re.findall(r"^## (\S+)\n.*?^```json\n(.+?)\n```\n\n> (.+?)$", page, re.MULTILINE | re.DOTALL)
    return {code: (json.loads(case, parse_float=number), sentence) for code, case, sentence in entries}


class View:
    """The loops, and the ball where it is drawn, seen along z and fitted into the drawing."""

    def __init__(self, points):
        xs, ys = zip(*points)
        self.low, self.high = (min(xs), min(ys)), (max(xs), max(ys))
        width, height = self.high[0] - self.low[0], self.high[1] - self.low[1]
        self.scale = min((WIDTH - 2 * MARGIN) / (width or 1), (HEIGHT - 2 * MARGIN) / (height or 1))
        self.left = (WIDTH - self.scale * width) / 2
        self.top = (HEIGHT - self.scale * height) / 2

    def __call__(self, point):
        return (self.left + self.scale * (point[0] - self.low[0]), self.top + self.scale * (self.high[1] - point[1]))


def edges(loops):
    """The ends of each edge and its loop, by its index."""
    return [(loop[i], loop[(i + 1) % len(loop)], loop) for loop in loops for i in range(len(loop))]


def middle_of(loop, view):
    return [sum(view(point)[i] for point in loop) / len(loop) for i in (0, 1)]


def outwards(point, loops, view, by):
    """Beside a vertex, away from the middle of its loop."""
    middle, here = middle_of(next(loop for loop in loops if point in loop), view), view(point)
    length = math.dist(here, middle)
    if length < 1:
        return [here[0] - by, here[1] - by]
    return [here[i] + by * (here[i] - middle[i]) / length for i in (0, 1)]


def beside_edge(ends, middle):
    """Beside an edge, a third along it, on the side away from the middle of its loop."""
    (x0, y0), (x1, y1) = ends
    length = math.dist(*ends)
    here = [x0 + 0.3 * (x1 - x0), y0 + 0.3 * (y1 - y0)]
    across = [(y1 - y0) / length, (x0 - x1) / length]
    side = 1 if sum(a * (h - m) for a, h, m in zip(across, here, middle)) > 0 else -1
    return [here[0] + side * (22 * across[0]), here[1] + side * (12 * across[1]) + 4]


def marks(code, sentence, loops, view):
    """What the sentence says is wrong: the vertices, the edges or the ball that it names."""
    vertices = [vertex for loop in loops for vertex in loop]
    shapes = ""
    if code == "zero-normal":
        shapes += path([view(vertex) for vertex in loops[0]], "bad")
    for i in map(int, re.findall(r"edge (\d+)", sentence)):
        *ends, loop = edges(loops)[i]
        ends = [view(end) for end in ends]
        shapes += path(ends, "bad") + text(beside_edge(ends, middle_of(loop, view)), f"edge {i}", "bad-text", "middle", 12)
    for i in map(int, re.findall(r"vertex (\d+)", sentence)) if "edge" not in sentence else ():
        shapes += dot(view(vertices[i]), "bad-dot", 5.5)
    if code == "too-few-vertices":
        shapes += path([view(vertex) for vertex in vertices], "bad")
    return shapes


def names(loops, view):
    """The vertices with their numbers; equal ones share a place and a label."""
    numbers = {}
    for i, vertex in enumerate(vertex for loop in loops for vertex in loop):
        numbers.setdefault(tuple(vertex), []).append(str(i))
    return "".join(dot(view(vertex)) + text(beside[:1] + [beside[1] + 4], " and ".join(which), "quiet", "middle", 12)
                   for vertex, which in numbers.items()
                   for beside in [outwards(list(vertex), loops, view, 12 + 8 * (len(which) > 1))])


BALLS = ("malformed-case", "not-finite", "negative-radius")  # the codes that are about the ball


def ball(code, case, view):
    """Only where the code is about it: elsewhere it would hide the loops."""
    if code not in BALLS:
        return ""
    centre = case["ball"]["center"]
    words = {"malformed-case": "no radius", "not-finite": f"z = {centre[2]}",
             "negative-radius": f"radius {case['ball'].get('radius')}"}[code]
    here = view(centre)
    return circle(here, view.scale, "bad hidden") + dot(here) + text((here[0] - view.scale - 8, here[1] + 5), words, "bad-text", "end")


def draw(code, case, sentence):
    polygon = case["polygon"]
    loops = [[vertex[:2] for vertex in loop] for loop in [polygon["outer"], *polygon.get("holes", [])]]
    around = [vertex for loop in loops for vertex in loop]
    if code in BALLS:
        x, y = case["ball"]["center"][:2]
        around += [[x - 1, y - 1], [x + 1, y + 1]]
    view = View(around)
    shapes = path([view(vertex) for vertex in loops[0]], "region", closed=True)
    for hole in loops[1:]:
        shapes += path([view(vertex) for vertex in hole], "hole", closed=True)
    shapes += marks(code, sentence, loops, view) + ball(code, case, view) + names(loops, view)
    return drawing(WIDTH, HEIGHT, f"The case of {code}", shapes)


def main(root, *options):
    found = cases(pathlib.Path(root, PAGE).read_text())
    if not found:
        sys.exit(f"{PAGE} has no cases")
    drawings = {pathlib.Path(root, f"docs/rejections/{code}.svg"): draw(code, *entry) for code, entry in found.items()}
    for file in sorted(set(pathlib.Path(root, "docs/rejections").glob("*.svg")) - set(drawings)):
        sys.exit(f"{file}: no code of {PAGE} has this name")
    return write_or_compare(drawings, options, "docs/drawing/rejections.py")


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
