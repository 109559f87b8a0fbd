# SPDX-License-Identifier: GPL-3.0-or-later
"""An engine that knows nothing of this project but its page of formats: exact contact in fractions, balls at a place only."""
import json
import sys
from fractions import Fraction


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def edges(loops):
    return [(a, b) for loop in loops for a, b in zip(loop, loop[1:] + loop[:1])]


def lifted(loops):
    """The contract's lift: vertices move along one axis onto the plane of the mean vertex."""
    outer = loops[0]
    normal = [sum(column) for column in zip(*(cross(a, b) for a, b in edges([outer])))]
    axis = max(range(3), key=lambda i: (abs(normal[i]), -i))
    mean = [sum(column) / len(outer) for column in zip(*outer)]
    lift = lambda p: [x + (dot(normal, minus(mean, p)) / normal[axis] if i == axis else 0) for i, x in enumerate(p)]
    return [[lift(p) for p in loop] for loop in loops], normal, axis


def is_inside(loops, q, axis):
    i, j = [k for k in range(3) if k != axis]
    crossed = [a[i] + (b[i] - a[i]) * (q[j] - a[j]) / (b[j] - a[j]) for a, b in edges(loops) if (a[j] > q[j]) != (b[j] > q[j])]
    return sum(q[i] < x for x in crossed) % 2 == 1


def squared_distance(c, a, b):
    along = min(max(dot(minus(b, a), minus(c, a)) / dot(minus(b, a), minus(b, a)), Fraction(0)), Fraction(1))
    away = [x - along * y for x, y in zip(minus(c, a), minus(b, a))]
    return dot(away, away)


def contact(case):
    centre, radius = [Fraction(x) for x in case["ball"]["center"]], Fraction(case["ball"]["radius"])
    given = [case["polygon"]["outer"], *case["polygon"].get("holes", [])]
    loops, normal, axis = lifted([[[Fraction(x) for x in p] for p in loop] for loop in given])
    height = dot(normal, minus(centre, loops[0][0])) / dot(normal, normal)
    squared = min(squared_distance(centre, a, b) for a, b in edges(loops))
    if is_inside(loops, [x - height * y for x, y in zip(centre, normal)], axis):
        squared = min(squared, height**2 * dot(normal, normal))
    return squared <= radius**2


if __name__ == "__main__":
    for line in sys.stdin:
        case = json.loads(line)
        answer = {} if "motion" in case else {"contact": contact(case)}
        print(json.dumps({"id": case["id"], **answer}), flush=True)
