# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases that nobody has seen: every family of the contract, drawn from a seed.

    python3 unseen_cases.py --seed S --count N

prints N cases as JSON Lines; case i is a function of (S, i) alone. Where the family implies an answer it is in
`expected`; the family is the case's tag. About a tenth are rejected. The checker places radii next to exact distances.
"""
import argparse
import json
import math
import random
import re
from decimal import Context, Decimal
from fractions import Fraction

import checker

TINY, HUGE = 5e-324, 1.7976931348623157e308
FRAMES = (  # lattice vectors u, v, w, pairwise orthogonal and equally long; that length
    ((1, 0, 0), (0, 1, 0), (0, 0, 1), 1), ((1, 2, 2), (2, 1, -2), (2, -2, 1), 3),
    ((2, 3, 6), (3, -6, 2), (6, 2, -3), 7), ((3, 4, 0), (4, -3, 0), (0, 0, 5), 5),
    ((1, 4, 8), (4, 7, -4), (8, -4, 1), 9))
DART = [[0.0, HUGE, HUGE], [-HUGE, 0.0, -HUGE], [HUGE, 0.0, 0.0], [-HUGE, -HUGE, 0.0]]  # lifted beyond the doubles
TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17), (20, 21, 29))
QUADRUPLES = ((1, 2, 2, 3), (2, 3, 6, 7), (1, 4, 8, 9), (4, 4, 7, 9), (2, 6, 9, 11))


# Outlines: simple loops of integer pairs

def triangle(rng):
    return scatter(rng, 3)


def rectangle(rng):
    w, h = rng.randint(1, 20), rng.randint(1, 20)
    return [(0, 0), (w, 0), (w, h), (0, h)]


def ell(rng):
    a, b, c, d = (rng.randint(1, 9) for _ in range(4))
    return [(0, 0), (a + b, 0), (a + b, c), (a, c), (a, c + d), (0, c + d)]


def comb(rng):
    """A back with 2 (a U) to 9 teeth."""
    teeth, depth = rng.randint(2, 9), rng.randint(2, 12)
    loop = [(0, 0), (2 * teeth - 1, 0)]
    for i in reversed(range(teeth)):
        loop += [(2 * i + 1, depth), (2 * i, depth)] + ([(2 * i, 1), (2 * i - 1, 1)] if i else [])
    return loop


def star(rng):
    """Star-shaped about the origin: increasing directions, any lengths."""
    n = rng.randint(5, 40)
    angles = [2 * math.pi * (i + 0.5 * rng.random()) / n for i in range(n)]
    sharp = rng.random() < 0.5
    lengths = [1000 if sharp and i % 2 else rng.randint(200, 4000) for i in range(n)]
    return [(round(r * math.cos(a)), round(r * math.sin(a))) for a, r in zip(angles, lengths)]


def scatter(rng, n=None):
    """Random points, the tour untangled by 2-opt."""
    n = n or rng.randint(4, 14)
    while True:
        loop = [(rng.randint(-60, 60), rng.randint(-60, 60)) for _ in range(n)]
        while shorten(loop):
            pass
        if n > 3 and not checker.meets_itself(loop) or n == 3 and checker.turn(*loop):
            return loop


def shorten(loop):
    """Reverses one stretch of the tour if that shortens it; whether it did."""
    n = len(loop)
    for i in range(n - 1):
        for j in range(i + 2, n):
            a, b, c, d = loop[i], loop[i + 1], loop[j], loop[(j + 1) % n]
            if math.dist(a, c) + math.dist(b, d) < math.dist(a, b) + math.dist(c, d) - 1e-9:
                loop[i + 1:j + 1] = reversed(loop[i + 1:j + 1])
                return True
    return False


def with_runs(rng, loop):
    """The loop doubled in size, some edges cut at their middles: legal straight runs."""
    result = []
    for a, b in checker.edges(loop):
        result.append((2 * a[0], 2 * a[1]))
        if rng.random() < 0.4 and len(loop) < 25:
            result.append((a[0] + b[0], a[1] + b[1]))
    return result


def outline(rng):
    loop = rng.choice((triangle, rectangle, ell, comb, star, scatter))(rng)
    return with_runs(rng, loop) if rng.random() < 0.3 else loop


def square(x, y, half):
    return [(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]


def touching(rng):
    """Loops that touch: an outline that visits a point twice, and holes with vertices on the outline or on others."""
    slab, k = square(6, 6, 6), rng.randint(1, 3)
    loops = rng.choice((
        [[(0, 0), (6, 0), (3, 3), (6, 6), (0, 6), (3, 3)]], [[(0, 0), (8, 0), (8, 5), (4, 0), (0, rng.randint(1, 9))]],
        [slab, [(0, rng.randint(1, 11)), (5, 1), (5, 11)]], [slab, [(0, 0), (8, 3), (3, 8)]],
        [slab, [(6, 0), (12, 6), (6, 12), (0, 6)]], [slab, square(6, 6, 4), [(2, 2), (9, 4), (6, 9)]],
        [slab, [(2, 2), (6, 3), (3, 6)], [(6, 3), (10, rng.randint(0, 2)), (9, 8)]]))
    return [[(k * x, k * y) for x, y in loop] for loop in loops]


def region(rng):
    """Loops of a legal region: an outline, loops that touch, a frame with islands in holes, or a slab with holes."""
    kind = rng.random()
    if kind < 0.5:
        return [outline(rng)]
    if kind < 0.6:
        return touching(rng)
    if kind < 0.75:
        return [square(0, 0, 2 * half) for half in range(rng.randint(2, 6), 0, -1)]
    holes = rng.sample([(x, y) for x in range(3) for y in range(2)], rng.randint(1, 4))
    shapes = ([(0, 0), (4, 1), (1, 4)], square(2, 2, 2), [(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)],
              [(0, 2), (2, 0), (4, 2), (2, 4)])
    slab = [(-1, -1), (18, -1), (18, 12), (-1, 12)]
    return [slab] + [[(6 * x + a, 6 * y + b) for a, b in rng.choice(shapes)] for x, y in holes]


# From the plane into space

def embed(frame, pair, height=0):
    """The lattice point x u + y v + height w of a frame."""
    return [pair[0] * u + pair[1] * v + height * w for u, v, w in zip(*frame[:3])]


def placed(frame, loops):
    """The loops on the frame's lattice; a vertex may have a height as its third number."""
    return [[embed(frame, p[:2], *p[2:]) for p in loop] for loop in loops]


def middle(a, b):
    return [(x + y) / 2 for x, y in zip(a, b)]


def turned(rng):
    """A rotation matrix in doubles, so not exactly one."""
    q = [rng.gauss(0, 1) for _ in range(4)]
    a, b, c, d = (x / math.hypot(*q) for x in q)
    return [[1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c)]]


def moved(matrix, shift, p):
    return [sum(m * x for m, x in zip(row, p)) + t for row, t in zip(matrix, shift)]


def make(center, radius, loops, **expected):
    case = {"ball": {"center": list(center), "radius": radius}, "polygon": {"outer": loops[0], "holes": loops[1:]}}
    return {**case, "expected": expected} if expected else case


def mapped(case, change):
    """The case with every number changed, the radius as well."""
    ball, polygon = case["ball"], case["polygon"]
    loops = [[[change(x) for x in p] for p in loop] for loop in (polygon["outer"], *polygon["holes"])]
    return make([change(x) for x in ball["center"]], change(ball["radius"]), loops, **case.get("expected", {}))


def shuffled(rng, case):
    """The same sets: loops turned around and started anywhere, axes permuted and mirrored, scaled by a power of two."""
    axes, signs = rng.sample(range(3), 3), [rng.choice((1, -1)) for _ in range(3)]
    factor = 2.0 ** rng.choice((0, 0, 0, rng.randint(-30, 30)))

    def place(p):
        return [p[k] * s for k, s in zip(axes, signs)]

    def restart(loop):
        k = rng.randrange(len(loop))
        return [place(p) for p in loop[k:] + loop[:k]][::rng.choice((1, -1))]

    ball, polygon = case["ball"], case["polygon"]
    loops = [restart(loop) for loop in (polygon["outer"], *polygon["holes"])]
    same = make(place(ball["center"]), ball["radius"], loops, **case.get("expected", {}))
    return mapped(same, lambda x: x * factor)


# Radii next to exact thresholds

def thresholds(case):
    """The doubles nearest to the distances from the centre to the polygon, the plane, some edges; none if rejected."""
    text = json.dumps({"id": "", **case})
    if "error" in checker.judge_case(text):
        return []
    scale, c, _, _, (loops,) = checker.scaled_to_integers(*checker.read_case(checker.read_json(text)[0]))
    normal = checker.newell(loops[0])
    offset = Fraction(sum(checker.dot(normal, checker.sub(c, p)) for p in loops[0]), len(loops[0]) * scale)
    edges = [checker.closest_on_edge(a, b, c, 0, 0)[0] / scale ** 2 for a, b in checker.edges(loops[-1])]
    return [checker.judge_case(text)["distance"], checker.nearest_root(offset ** 2 / checker.dot(normal, normal)),
            *map(checker.nearest_root, edges)]


def near_threshold(rng, case):
    """The case with a radius at most two doubles from a threshold, half of the time from the distance itself."""
    first, *others = thresholds(case) or [1.0]
    radius = first if rng.random() < 0.5 else rng.choice([first, *others])
    radius, steps = HUGE if radius is None else radius, rng.choice((-2, -1, 0, 0, 1, 2))
    for _ in range(abs(steps)):
        radius = math.nextafter(radius, HUGE if steps > 0 else 0)
    case["ball"]["radius"] = radius
    return case


# Motions

def moving(rng, case):
    """The case with its ball on a way through the centre, mostly in the middle of it: at rest, along an edge, to or from
    a vertex, perpendicular to the way to a vertex, along an axis, or anywhere. In integers the ball often grazes."""
    ball, loops = case["ball"], [case["polygon"]["outer"], *case["polygon"]["holes"]]
    a, b = rng.choice(checker.edges(rng.choice(loops)))
    away, along = checker.sub(ball["center"], a), checker.sub(b, a)
    size, sign, axis = max(map(abs, along)), rng.choice((-1, 1)), rng.randrange(3)
    perpendicular, one_axis = [0.0] * 3, [0.0] * 3
    perpendicular[axis - 1], perpendicular[axis - 2] = away[axis - 2], -away[axis - 1]
    one_axis[axis] = 2 * size
    half = rng.choice(([0.0] * 3, along, along, away, away, perpendicular, perpendicular, one_axis, one_axis,
                       [x + y / 2 for x, y in zip(along, one_axis)], [rng.randint(-4, 4) * size / 2 for _ in range(3)],
                       [rng.uniform(-2, 2) * size for _ in range(3)]))
    half, middle_of = [sign * x for x in half], rng.choice(("way", "way", "way", "start", "end"))
    start, end = (placed_at(ball["center"], half, by) for by in (-(middle_of != "start"), middle_of != "end"))
    touches = case.pop("expected", {}).get("relation") == "touching"
    if touches and all(map(is_sum, start, ball["center"], half)) and all(map(is_sum, end, ball["center"], half)):
        case["expected"] = {"contact": True}
    return {**case, "ball": {**ball, "center": start}, "motion": {"to": end}}


def placed_at(center, half, by):
    return [max(-HUGE, min(HUGE, x + by * y)) for x, y in zip(center, half)]


def is_sum(x, y, z):
    """Whether x is exactly y, y + z or y - z."""
    return Fraction(x) - Fraction(y) in (0, Fraction(z), -Fraction(z))


# Families of legal cases (a few are rejected by nature)

def lattice(rng):
    """A ball of integers at an outline of integers: feet often on the boundary, often tangent to the plane."""
    frame, loops = rng.choice(FRAMES), region(rng)
    loop = rng.choice(loops)
    (a, b), corner = rng.choice(checker.edges(loop)), rng.choice(loop)
    foot = rng.choice((corner, middle(a, b), [x + rng.randint(-3, 3) for x in corner]))
    height = rng.randint(-6, 6)
    radius = abs(height) * frame[3] + rng.choice((0, 0, 0, 0.5, 2))
    return make(embed(frame, foot, height), radius, placed(frame, loops))


def tangent_face(rng):
    frame, height, loop = rng.choice(FRAMES), rng.choice((-5, -2, -1, 1, 2, 9)), rectangle(rng)
    return make(embed(frame, (loop[2][0] / 4, loop[2][1] / 2), height), abs(height) * frame[3], placed(frame, [loop]),
                relation="touching", plane_tangent=True, nearest={"kind": "face"})


def tangent_edge(rng):
    frame, (a, b, c), k, loop = rng.choice(FRAMES), rng.choice(TRIPLES), rng.choice((-3, -1, 1, 2)), rectangle(rng)
    center = embed(frame, (loop[2][0] / 2, -a * abs(k)), b * k)
    return make(center, c * abs(k) * frame[3], placed(frame, [loop]),
                relation="touching", plane="intersects", foot="outside", plane_tangent=False)


def tangent_vertex(rng):
    frame, (a, b, c, d), k = rng.choice(FRAMES), rng.choice(QUADRUPLES), rng.choice((-3, -1, 1, 2))
    center, loop = embed(frame, (-a * abs(k), -b * abs(k)), c * k), rng.choice((rectangle, ell))(rng)
    return make(center, d * abs(k) * frame[3], placed(frame, [loop]), relation="touching", foot="outside")


def tangent_feature(rng):
    """Exactly at the radius from some vertex of any region, nearest or not."""
    frame, (a, b, c, d), loops = rng.choice(FRAMES), rng.choice(QUADRUPLES), region(rng)
    x, y = rng.choice(rng.choice(loops))
    return make(embed(frame, (x + a, y - b), rng.choice((c, -c))), d * frame[3], placed(frame, loops))


def rotated(rng):
    """A region turned and rounded: off its plane by a few roundings, near thresholds."""
    matrix, shift, loops = turned(rng), [rng.uniform(-50, 50) * rng.randint(0, 1) for _ in range(3)], region(rng)
    extent = max(abs(x) for loop in loops for p in loop for x in p)
    pairs = [p for loop in loops for p in loop]
    base = rng.choice((rng.choice(pairs), [rng.uniform(-extent, extent) for _ in range(2)]))
    center = moved(matrix, shift, [*base, rng.choice((0, 1, -1)) * rng.uniform(0, extent)])
    case = make(center, rng.uniform(0, extent), [[moved(matrix, shift, [*p, 0]) for p in loop] for loop in loops])
    return near_threshold(rng, case) if rng.random() < 0.7 else case


def threshold(rng):
    """A lattice case or a random triangle in doubles, its radius next to a threshold."""
    center, *corners = [[rng.uniform(-1, 1) for _ in range(3)] for _ in range(4)]
    return near_threshold(rng, rng.choice((lattice(rng), make(center, 1.0, [corners]))))


def off_plane(rng):
    """A region whose vertices are pushed off the plane, by some doubles in any direction or by far along the normal."""
    frame, loops = rng.choice(FRAMES), region(rng)
    size, push = rng.choice(((1e-15, 0), (1e-9, 0), (0.01, 0), (0, 0.3), (0, 1), (0, 30), (1, 30)))

    def pushed(p):
        exact = embed(frame, p, push * rng.randint(-2, 2))
        return [x * (1 + size * rng.randint(-2, 2)) + size * rng.randint(-2, 2) for x in exact]

    center = embed(frame, rng.choice(loops[-1]), rng.randint(-5, 5))
    case = make(center, rng.randint(0, 40), [[pushed(p) for p in loop] for loop in loops])
    return near_threshold(rng, case) if rng.random() < 0.4 else case


def axis_tie(rng):
    """A parallelogram whose normal has equal components, its diagonals pushed apart, which keeps the normal exactly."""
    u, v = rng.choice((((1, -1, 0), (0, 0, 1)), ((1, -1, 0), (0, 1, -1)), ((1, 0, 0), (0, 1, -1))))
    push = rng.choice(([0, 0, 0], [rng.randint(-20, 20), 0, 0], [rng.randint(-2, 2) for _ in range(3)]))
    corners = (1, 1, 1), (-1, 1, -1), (-1, -1, 1), (1, -1, -1)
    loop = [[5 * (s * a + t * b) + z * p for a, b, p in zip(u, v, push)] for s, t, z in corners]
    return make([rng.randint(-9, 9) for _ in range(3)], rng.randint(0, 9), [loop])


def needle(rng):
    """Slivers: a vertex that leaves the line of two others by little."""
    a, along = ([rng.uniform(-1, 1) * 10 ** rng.randint(0, 6) for _ in range(3)] for _ in range(2))
    b, t = [x + y for x, y in zip(a, along)], rng.choice((0.5, 1e-3, 1 - 1e-12, 1.5))
    c = [x + t * y + rng.choice((0, 1e-16, 1e-12, 1e-5)) * rng.uniform(-1, 1) * y for x, y in zip(a, along)]
    center = [x + rng.gauss(0, 1) * 10.0 ** rng.randint(-8, 4) for x in rng.choice((a, c))]
    return near_threshold(rng, make(center, 1.0, [[a, b, c]]))


def far(rng):
    """Far from the origin, where the sums round."""
    matrix, reach = turned(rng), 10.0 ** rng.randint(3, 17)
    shift, loops = [rng.uniform(-reach, reach) for _ in range(3)], region(rng)
    center = moved(matrix, shift, [*rng.choice(loops[0]), rng.uniform(-30, 30)])
    return near_threshold(rng, make(center, 1.0, [[moved(matrix, shift, [*p, 0]) for p in loop] for loop in loops]))


def scaled(rng):
    """Another family's case times 1e-300 to 1e300."""
    case, factor = rng.choice((lattice, rotated, off_plane))(rng), 10.0 ** rng.randint(-300, 300)
    return mapped(case, lambda x: x * factor)


def subnormal(rng):
    """Integers counted in the least double: exactly tangent cases stay so, results round to subnormals and to 0."""
    case = rng.choice((lattice, axis_tie, tangent_face, tangent_edge))(rng)
    whole = mapped(case, lambda x: 4 * x * TINY)  # 4: the families use quarters
    return mapped(case, lambda x: int(x) * TINY) if "expected" not in case and rng.random() < 0.5 else whole


def huge(rng):
    """Near the end of the doubles, where distances, points and displacements may overflow."""
    if rng.random() < 0.5:
        count, ends = rng.choice((4, 5, 5)), (HUGE, -HUGE, HUGE / 2, 0.0, 1.0)
        center, *loop = [[rng.choice(ends) for _ in range(3)] for _ in range(count)]
        center, loop = rng.choice(((center, loop), (center, loop), (center, DART), ([-HUGE, HUGE, HUGE], DART)))
        return near_threshold(rng, make(center, HUGE, [loop]))
    case = rng.choice((lattice, off_plane, axis_tie))(rng)
    largest = max(abs(x) for p in (*case["polygon"]["outer"], case["ball"]["center"]) for x in p)
    return mapped(case, lambda x: max(-1.0, min(1.0, x / largest)) * HUGE)


def mixed(rng):
    """Coordinates of every magnitude within one polygon."""
    def number():
        any_size = math.ldexp(rng.uniform(-1, 1), rng.randint(-1074, 1024))
        return rng.choice((0.0, 1.0, -1.0, any_size, any_size, rng.uniform(-9, 9), TINY, -TINY))
    center, *loop = [[number() for _ in range(3)] for _ in range(rng.choice((4, 4, 4, 5)))]
    case = make(center, abs(number()), [loop])
    return near_threshold(rng, case) if rng.random() < 0.5 else case


def point_ball(rng):
    """r = 0: on the region, on its boundary, or off by the least double."""
    frame, loops = rng.choice(FRAMES), region(rng)
    a, b = rng.choice(checker.edges(rng.choice(loops)))
    case = make(embed(frame, rng.choice((a, middle(a, b)))), rng.choice((0, -0.0)),
                placed(frame, loops), relation="touching", foot="boundary", distance=0)
    if rng.random() < 0.3:
        case["ball"]["center"][2] = math.nextafter(case["ball"]["center"][2], rng.choice((-1e9, 1e9)))
        del case["expected"]
    return case


def minus_zeros(rng):
    """Another family's case with every zero negative."""
    return mapped(rng.choice((lattice, tangent_face, point_ball, axis_tie))(rng), lambda x: x or -0.0)


# Rejected cases

FOLDED = (
    [(2, 2), (4, 4), (4, 2), (3, 5)], [(2, 2), (5, 2), (4, 2), (4, 4)], [(2, 2), (6, 2), (6, 4), (4, 2), (3, 1)],
    [(2, 2), (4, 3), (6, 5), (6, 2), (4, 3), (2, 5)], [(2, 2), (5, 2), (5, 2, 1), (3, 5)], [(2, 2), (3, 3), (5, 5)],
    [(2, 2), (6, 2), (6, 5), (5, 5), (5, 2), (2, 2, 3)])
MEETING = (
    [square(10, 10, 1), square(11, 11, 1)], [square(10, 10, 2), square(13, 11, 2)],
    [square(10, 10, 1), square(12, 10, 1)], [square(10, 10, 1), square(10, 10, 1)], [square(0, 10, 2)],
    [[(22, 5), (15, 3), (15, 7)]], [square(18, 18, 2)])
OUTSIDE = square(30, 10, 2), square(10, 10, 50), [(-5, -5), (-3, -5), (-5, -3)]
NULL_NORMAL = (
    [(0, 0), (1, 1), (2, 2)], [(0, 0), (8, 8), (8, 0), (0, 8)], [(0, 0), (1, 2), (2, 4), (5, 10)],
    [(0, 0), (1, 0), (0, 0), (0, 1)])
CODES = ("malformed-case", "not-finite", "negative-radius", "too-few-vertices", "repeated-vertex", "zero-normal",
         "loop-meets-itself", "loops-meet", "hole-outside")


def literal(text):
    """A value that is printed as this text, not as a string."""
    return f"@{text}@"


def rejected(rng):
    """A slab with one defect, or several: the first in the contract's order is the answer."""
    defects = [CODES[k] for k in sorted(rng.sample(range(1, len(CODES)), rng.choice((1, 1, 1, 2, 3))))]
    loops = [square(10, 10, 10)]
    if "too-few-vertices" in defects:
        loops.append([(1, 1), (2, 2)][:rng.randint(0, 2)])
    if "repeated-vertex" in defects:
        loops.append(rng.choice(([(1, 1), (1, 1), (2, 1), (2, 2)], [(1, 1), (2, 1), (2, 2), (1, 1)])))
    if "loop-meets-itself" in defects:
        loops.append(rng.choice(FOLDED))
    if "loops-meet" in defects:
        loops += rng.choice(MEETING)
    if "hole-outside" in defects:
        loops.append(rng.choice(OUTSIDE))
    if "zero-normal" in defects:
        loops[0] = rng.choice(NULL_NORMAL)
    loops[1:] = rng.sample(loops[1:], len(loops) - 1)
    frame = rng.choice(FRAMES)
    radius = -rng.choice((1, TINY, HUGE)) if "negative-radius" in defects else 3
    case = make(embed(frame, (9, 9), 2), radius, placed(frame, loops), error=defects[0])
    if "not-finite" in defects:
        spoil = rng.choice((case["ball"]["center"], case["polygon"]["outer"][1]))
        spoil[rng.randrange(3)] = literal(rng.choice(("1e400", "-1e400", "1.7976931348623159e308", "17" + "0" * 308)))
    return case


def nearly_folded(rng):
    """A bow-tie whose areas cancel but for a rounding: N is not 0, and the loop meets itself or does not."""
    frame = rng.choice(FRAMES)
    exact = [embed(frame, p) for p in rng.choice(NULL_NORMAL)]
    loop = [[x + rng.choice((0, 0, 1e-15)) * rng.randint(-4, 4) for x in p] for p in exact]
    return make(embed(frame, (3, 3), 1), 1, [loop])


NULL = literal("null")
CORNERS = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]
WRONG = (  # (path to a value, what stands there instead); None: nothing
    ("id", None), ("id", 7), ("id", [[]]), ("ball", None), ("ball", [1, 2]), ("ball center", None),
    ("ball radius", None), ("ball radius", "1"), ("ball radius", True), ("ball radius", NULL), ("ball radius", [1]),
    ("ball center", "0 0 0"), ("ball center", []), ("ball center", [1, 2]), ("ball center", [1, 2, 3, 4]),
    ("ball center", [1, 2, False]), ("ball center", [1, 2, "3"]), ("polygon", None), ("polygon", CORNERS), ("polygon outer", None),
    ("polygon outer", {}), ("polygon outer", NULL), ("polygon outer", [1, 2, 3]), ("polygon outer", [*CORNERS, [1, 1]]),
    ("polygon outer", [*CORNERS, [1, 1, 0, 0]]), ("polygon outer", [*CORNERS, [1, [1], 0]]),
    ("polygon outer", [*CORNERS, {"x": 1, "y": 1, "z": 0}]), ("polygon holes", {}), ("polygon holes", NULL),
    ("polygon holes", [7]), ("polygon holes", CORNERS), ("polygon holes", [[[0, 0]]]), ("expected", []),
    ("expected", NULL), ("expected", "touching"), ("expected", {"relatoin": "touching"}),
    ("expected", {"distance": 1, "radius": 1}), ("expected", {"when": "start"}),
    ("motion", 7), ("motion", {}), ("motion", NULL), ("motion", {"to": [1, 2]}), ("motion", {"to": [1, 2, "3"]}),
    ("motion", {"from": [1, 2, 3]}), ("tags", "tangent"), ("tags", {}), ("tags", NULL))
DOUBLED = (  # (text, what replaces it)
    ('"ball": {', '"ball": {"radius": 1, '), ('"polygon": {', '"polygon": {"outer": [], '),
    ("[[", '[{"x": 1, "x": 1}, ['),
    ('"ball": {', '"b\\u0061ll": {}, "ball": {'), ('"ball": {', '"tags": [], "tags": [], "ball": {'),
    ('"ball": {', '"expected": {"distance": 1, "distance": 1}, "ball": {'),
    ('"ball": {', '"expected": {"nearest": {"kind": "face", "kind": "face"}}, "ball": {'))


def malformed(rng, name):
    """The text of a malformed line."""
    radius, kind = rng.choice((1, -1, literal("1e400"))), rng.random()
    case = {"id": name, **make([1, 1, rng.randint(-3, 3)], radius, placed(FRAMES[0], [rectangle(rng)]))}
    if kind < 0.05:
        return rng.choice(("[]", "{}", "3", '"text"', "null", "true", "1e400", " { } ", '[{"id": "a"}]'))
    if kind < 0.25:
        return text_of(case).replace(*rng.choice(DOUBLED), 1)
    path, value = rng.choice(WRONG)
    *parents, key = path.split()
    holder = case[parents[0]] if parents else case
    holder.pop(key, None) if value is None else holder.update({key: value})
    return text_of(case)


# Lines

def text_of(case):
    return re.sub(r'"@([^"@]*)@"', r"\1", json.dumps(case, allow_nan=False))


def spelled(rng, x):
    """Another text that is read as this double: exact expansions, midpoints that round to it, exponents of any kind."""
    exact = Context(prec=1200).create_decimal(Decimal(x))
    following = math.nextafter(x, math.inf)
    if x and rng.random() < 0.4 and math.isfinite(following):
        middle = Context(prec=1200).divide(Context(prec=1200).add(exact, Decimal(following)), Decimal(2))
        if float(middle) == x:
            return literal(f"{middle:E}")
    return literal(rng.choice((repr(x), f"{exact:E}", f"{exact:e}", f"{x:.25e}", f"{x:.17E}")))


LEGAL = (
    lattice, lattice, tangent_face, tangent_edge, tangent_vertex, tangent_feature, rotated, rotated, rotated, threshold,
    threshold, off_plane, off_plane, axis_tie, needle, far, scaled, subnormal, huge, mixed, point_ball, minus_zeros)


def case_line(seed, i):
    """Line i of the cases of a seed."""
    rng = random.Random(f"{seed}/{i}")
    kind = rng.random()
    if kind < 0.02:
        return malformed(rng, f"malformed-{seed}-{i}")
    family = rejected if kind < 0.07 else nearly_folded if kind < 0.08 else rng.choice(LEGAL)
    case = family(rng)
    if family not in (rejected, huge, mixed, subnormal, scaled):
        case = shuffled(rng, case)
    motion = random.Random(f"{seed}/{i}/motion")
    if family not in (rejected, nearly_folded) and motion.random() < 0.3:
        case = moving(motion, case)
    if not case["polygon"]["holes"] and rng.random() < 0.5:
        del case["polygon"]["holes"]
    if family is not rejected and rng.random() < 0.05:
        case = respelled(rng, case)
    tags = [family.__name__, *(["moving"] if "motion" in case else [])]
    return text_of({"id": f"{'-'.join(tags)}-{seed}-{i}", **case, "tags": tags})


def respelled(rng, case):
    """The case with its numbers spelled in other ways."""
    def respell(value):
        if isinstance(value, dict):
            return {key: respell(x) for key, x in value.items()}
        return [respell(x) for x in value] if isinstance(value, list) else spelled(rng, float(value))
    return {key: respell(value) if key in ("ball", "motion", "polygon") else value for key, value in case.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    options = parser.parse_args()
    for i in range(options.count):
        print(case_line(options.seed, i))


if __name__ == "__main__":
    main()
