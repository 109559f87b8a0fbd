#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: contract.py ROOT [--write]

Draws docs/contract.svg, the figure of the contract: the first sample of the tutorial, seen obliquely. Compares it with
the file (exit status 1 if it differs), or writes it.
"""

import math
import pathlib
import sys

from svg import dot, drawing, path, text, write_or_compare

AZIMUTH, ELEVATION = math.radians(-78), math.radians(34)
SCALE, ORIGIN = 116, (80, 322)
LOOP = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
CENTRE, RADIUS = (1.5, 2, 0.5), 1
RIGHT = (-math.sin(AZIMUTH), math.cos(AZIMUTH), 0)
UP = (-math.sin(ELEVATION) * math.cos(AZIMUTH), -math.sin(ELEVATION) * math.sin(AZIMUTH), math.cos(ELEVATION))


def seen(x, y, z=0.0):
    return (ORIGIN[0] + SCALE * (RIGHT[0] * x + RIGHT[1] * y + RIGHT[2] * z),
            ORIGIN[1] - SCALE * (UP[0] * x + UP[1] * y + UP[2] * z))


def beside(point, dx, dy):
    return point[0] + dx, point[1] + dy


def outline_of_ball(in_front):
    """The part of the ball's outline on one side of the plane z = 0."""
    points = []
    for step in range(241):
        angle = math.radians(1.5 * step - 120)
        point = [CENTRE[i] + RADIUS * (math.cos(angle) * RIGHT[i] + math.sin(angle) * UP[i]) for i in range(3)]
        if (point[2] >= 0) == in_front:
            points.append((angle, seen(*point)))
    # The hidden part is one run; the visible one wraps around where the angles begin.
    gap = next((i for i in range(1, len(points)) if points[i][0] - points[i - 1][0] > 0.1), 0)
    return [point for _, point in points[gap:] + points[:gap]]


def cut():
    """The circle in which the ball meets the plane."""
    radius = math.sqrt(RADIUS**2 - CENTRE[2]**2)
    return [seen(CENTRE[0] + radius * math.cos(math.radians(3 * k)), CENTRE[1] + radius * math.sin(math.radians(3 * k)))
            for k in range(120)]


def edge(i):
    return [seen(*LOOP[i]), seen(*LOOP[(i + 1) % len(LOOP)])]


def contract():
    c, q, p = seen(*CENTRE), seen(*CENTRE[:2]), seen(2, 2)
    corner = (3.55, 0.9)
    base, tip = seen(*corner), seen(*corner, 1.05)
    shapes = path([seen(*xy) for xy in ((-0.4, -0.45), (4.2, -0.45), (4.2, 3.5), (-0.4, 3.5))], "plane", closed=True)
    shapes += path([seen(*xy) for xy in LOOP], "region", closed=True)
    shapes += path(outline_of_ball(False), "thin hidden")
    shapes += f'<circle class="ball" style="stroke:none" cx="{c[0]:.1f}" cy="{c[1]:.1f}" r="{SCALE * RADIUS}"/>\n'
    shapes += path(outline_of_ball(True), "thin") + path(cut(), "thin", closed=True)
    shapes += path(edge(3), "bad") + path(edge(5), "bad")

    square = [seen(1.5 + 0.12, 2), seen(1.5 + 0.12, 2, 0.12), seen(1.5, 2, 0.12)]  # the right angle at the foot
    shapes += path(square, "thin") + path([c, q], "thin hidden") + path([c, p], "near")
    rim = (c[0] + SCALE * RADIUS * math.cos(math.radians(65)), c[1] - SCALE * RADIUS * math.sin(math.radians(65)))
    shapes += path([c, rim], "thin")
    shapes += path([base, tip], "line") + path([beside(tip, -5, 11), tip, beside(tip, 5, 11)], "line")
    shapes += dot(c) + dot(q) + dot(p, "near-dot", 4.5)

    shapes += text(beside(c, 7, -7), "centre c") + text(beside(rim, -14, 58), "r")
    shapes += text(beside(q, -7, 17), "foot q", anchor="end")
    shapes += text(beside(((c[0] + p[0]) / 2, (c[1] + p[1]) / 2), 8, 0), "d", "near-text")
    shapes += text(beside(p, 12, 5), "nearest point p", "near-text")
    shapes += text(beside(seen(2, 2.62), 9, 4), "edge 3: hit", "bad-text")
    shapes += text(beside(seen(1, 1.45), -9, 4), "edge 5: hit", "bad-text", "end")
    shapes += text(beside(tip, 10, 6), "normal N") + text(beside(tip, 10, 24), "(in front)", "quiet", size=12)
    shapes += text(beside(seen(3.2, -0.3), 0, 0), "supporting plane", "quiet")
    shapes += text(beside(seen(0.2, 0.3), 0, 0), "polygon", "quiet")
    shapes += text(beside((c[0], c[1] - SCALE), 0, -8), "ball", anchor="middle")
    middle = (sum(x for x, _ in LOOP) / 8, sum(y for _, y in LOOP) / 8)
    for i, (x, y) in enumerate(LOOP):
        away = 0.16 / math.dist((x, y), middle)
        shapes += text(beside(seen(x + away * (x - middle[0]), y + away * (y - middle[1])), 0, 4), str(i), "quiet", "middle", 11)
    return drawing(690, 440, "The parts of an answer about a ball and a polygon", shapes)


def main(root, *options):
    return write_or_compare({pathlib.Path(root, "docs/contract.svg"): contract()}, options, "docs/drawing/contract.py")


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
