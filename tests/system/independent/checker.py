# SPDX-License-Identifier: GPL-3.0-or-later
"""An independent checker of the contract: what an exact method must answer, in integers and fractions alone.

    python3 checker.py [--method NAME] CASES.jsonl VERDICTS.jsonl

compares the verdicts that `touchstone judge --methods exact CASES.jsonl` printed with the ones derived here, key by
key. Exit status 0 if all agree and at least one was compared, else 1.

Every double is an integer over a power of two, so each case is scaled by one power of two to integers. Nothing is
rounded before the last step, and there is no tolerance. Written from the contract; shares no code with the project.
"""
import argparse
import json
import math
import sys
from fractions import Fraction
from functools import cmp_to_key
from itertools import combinations, zip_longest

import surd
from surd import nearest_double

ANSWER_KEYS = ("plane", "plane_tangent", "foot", "edges_hit", "relation", "contact", "nearest", "point", "distance",
               "contact_normal", "depth", "off_plane")
MOVING_KEYS = ("contact", "first", "time", "momentary", "feature", "point", "contact_normal", "depth", "off_plane")
MESH_KEYS = ("touched", "face")
POLYGON_KEYS = ("plane", "plane_tangent", "foot", "edges_hit", "off_plane")
EXPLAIN_KEYS = ("stage", "margin")
SHOWN = 20


class Rejected(Exception):
    """The case is rejected; the only argument is the code."""


def reject_if(condition, code):
    if condition:
        raise Rejected(code)


# Reading a case

def read_json(line):
    """The JSON value of a line, each number a float, and the flaws that only the text shows: a set of codes.

    ValueError if the line is not JSON; the literals NaN and Infinity are not.
    """
    flaws = set()

    def number(text):
        value = float(text)
        if math.isinf(value):
            flaws.add("not-finite")
        return value

    def members(pairs):
        if len(dict(pairs)) < len(pairs):
            flaws.add("malformed-case")
        return dict(pairs)

    def not_json(literal):
        raise ValueError(literal)

    text = line.decode("utf-8") if isinstance(line, bytes) else line
    return json.loads(text, parse_int=number, parse_float=number, parse_constant=not_json,
                      object_pairs_hook=members), flaws


def member(parent, key, kind, default=None):
    """parent[key], which must be of the kind; without a default it must be there."""
    reject_if(not isinstance(parent, dict), "malformed-case")
    value = parent.get(key, default)
    reject_if(not isinstance(value, kind), "malformed-case")
    return value


def read_point(value):
    reject_if(not isinstance(value, list) or len(value) != 3, "malformed-case")
    reject_if(not all(isinstance(x, float) for x in value), "malformed-case")
    return tuple(value)


def read_loop(value, closed):
    reject_if(not isinstance(value, list), "malformed-case")
    points = [read_point(p) for p in value]
    reject_if(closed and (len(points) < 2 or points[0] != points[-1]), "malformed-case")
    return points[:-1] if closed else points


def read_polygon(case):
    """The loops of a well-formed polygon, the outer one first."""
    polygon = member(case, "polygon", dict)
    closed = member(polygon, "closed", bool, False)
    return [read_loop(v, closed) for v in [member(polygon, "outer", list), *member(polygon, "holes", list, [])]]


def read_mesh(case):
    """The loops of each face of a well-formed mesh, as it has them and then posed; None for posed ones beyond the doubles."""
    reject_if("polygon" in case or "file" in member(case, "mesh", dict), "malformed-case")  # this reads no files
    mesh, pose = member(case, "mesh", dict), member(case, "pose", dict, {})
    vertices = read_loop(member(mesh, "vertices", list), False)
    faces = member(mesh, "faces", list)
    reject_if(not faces, "malformed-case")
    for face in faces:
        reject_if(not isinstance(face, list), "malformed-case")
        reject_if(not all(isinstance(i, float) and i in range(len(vertices)) for i in face), "malformed-case")
    rotation = read_loop(member(pose, "rotation", list, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), False)
    reject_if(len(rotation) != 3, "malformed-case")
    translation = read_point(member(pose, "translation", list, [0.0] * 3))
    reject_if(not all(map(math.isfinite, [*translation, *(x for p in vertices + rotation for x in p)])), "not-finite")

    def posed(point):
        rows = (sum(Fraction(a) * Fraction(x) for a, x in zip(row, point)) for row in rotation)
        return tuple(nearest_double(x + Fraction(t)) for x, t in zip(rows, translation))

    def loops(face, place):
        points = [place(vertices[int(i)]) for i in face]
        return None if any(x is None for p in points for x in p) else [points]

    return [loops(face, place) for face in faces for place in (tuple, posed)]


def read_case(case):
    """Centre, end of the motion or None, radius and polygons, each a list of loops, of a well-formed case, in floats.

    The polygons are one, or each face of a mesh as it has it and then posed.
    """
    member(case, "id", str)
    reject_if("pose" in case and "mesh" not in case, "malformed-case")
    ball = member(case, "ball", dict)
    center, radius = read_point(member(ball, "center", list)), member(ball, "radius", float)
    to = read_point(member(member(case, "motion", dict), "to", list)) if "motion" in case else None
    polygons = read_mesh(case) if "mesh" in case else [read_polygon(case)]
    expected = member(case, "expected", dict, {})
    reject_if(not set(expected) <= {*ANSWER_KEYS, *MOVING_KEYS, *MESH_KEYS, "error"}, "malformed-case")
    reject_if(not all(isinstance(tag, str) for tag in member(case, "tags", list, [])), "malformed-case")
    return center, to, radius, polygons


# Arithmetic

def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def times(k, a):
    return tuple(k * x for x in a)


def nearest_root(value):
    """The double nearest to the square root of a rational >= 0.

    The root is cut to at least 64 bits and a last bit says whether something was cut: no double and no midpoint of
    doubles lies between that and the root.
    """
    a, b = value.numerator, value.denominator
    shift = max(0, (130 - a.bit_length() + b.bit_length()) // 2)
    a <<= 2 * shift
    root = math.isqrt(a // b)
    return nearest_double(Fraction(2 * root + (root * root * b != a), 2 << shift))


def nearest_unit(v):
    """The doubles nearest to the coordinates of a rational vector, not zero, divided by its length."""
    length2 = Fraction(dot(v, v))
    return [surd.sign(x) * nearest_root(x * x / length2) + 0.0 for x in v]  # -0 + 0 is 0


# Loops with one coordinate dropped: points are pairs of integers

def edges(loop):
    return list(zip(loop, loop[1:] + loop[:1]))


def turn(a, b, c):
    """Positive if a, b, c turn left, negative if right, 0 if collinear."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def between(a, b, p):
    """Whether p lies in the box with corners a and b."""
    return all(min(x, y) <= z <= max(x, y) for x, y, z in zip(a, b, p))


def apart(a, b, p):
    """Whether all of p's points lie strictly to one side of both a and b in some coordinate."""
    return any(max(x, y) < min(z) or max(z) < min(x, y) for x, y, z in zip(a, b, zip(*p)))


def opposite(s, t):
    return s < 0 < t or t < 0 < s


def is_left(a, b, c, p):
    """Whether p is to the left of the path a, b, c near b, if it is on neither ray from b."""
    both = turn(a, b, p) > 0, turn(b, c, p) > 0
    return all(both) if turn(a, b, c) >= 0 else any(both)


def run(loop, i, p):
    """The loop on its way through the point p of edge i: what names it, the vertex before, the vertex after."""
    n = len(loop)
    j = (i + 1) % n
    if p == loop[i]:
        return i, loop[i - 1], loop[j]
    return (j, loop[i], loop[(j + 1) % n]) if p == loop[j] else (n + i, loop[i], loop[j])


def edges_meet(first, i, second, j):
    """Whether two edges cross, overlap, or share a point in which their loops cross."""
    a, b, c, d = first[i], first[(i + 1) % len(first)], second[j], second[(j + 1) % len(second)]
    if apart(a, b, (c, d)):
        return False
    turns = turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)
    if opposite(turns[0], turns[1]) and opposite(turns[2], turns[3]):
        return True
    ends = zip(turns, ((a, b), (a, b), (c, d), (c, d)), (c, d, a, b))
    shared = {p for t, segment, p in ends if t == 0 and between(*segment, p)}
    if len(shared) > 1:
        return True
    for p in shared:
        here, before, after = run(first, i, p)
        other, come, go = run(second, j, p)
        if first is second and here == other:
            continue
        if is_left(before, p, after, come) != is_left(before, p, after, go):
            return True
    return False


def meets_itself(loop):
    """Whether an edge is a point, or two edges meet; those of a spike overlap."""
    return any(a == b for a, b in edges(loop)) or any(
        edges_meet(loop, i, loop, j) for i, j in combinations(range(len(loop)), 2))


def meet(first, second):
    return any(edges_meet(first, i, second, j) for i in range(len(first)) for j in range(len(second)))


def begins_inside(hole, outer):
    """Whether the hole is inside the outer loop, near the start of its first edge, where no edge of that loop is."""
    start, end = hole[0], hole[1]
    most = 4 * max(abs(x - y) for p, q in edges(outer + hole) for x, y in zip(p, q)) ** 2 + 1  # above any cross product
    return locate(tuple(most * x + y - x for x, y in zip(start, end)), [[times(most, p) for p in outer]]) == "inside"


def locate(p, loops):
    """`inside`, `boundary` or `outside`: p against the even-odd region of the loops."""
    inside = False
    for a, b in (edge for loop in loops for edge in edges(loop)):
        if not min(a[1], b[1]) <= p[1] <= max(a[1], b[1]):
            continue
        side = turn(a, b, p)
        if side == 0 and between(a, b, p):
            return "boundary"
        if (a[1] > p[1]) != (b[1] > p[1]) and (side > 0) == (b[1] > a[1]):
            inside = not inside
    return "inside" if inside else "outside"


# Judging: sections 1 and 2

def newell(loop):
    """Sum of p_i x p_(i+1)."""
    return tuple(map(sum, zip(*(cross(a, b) for a, b in edges(loop)))))


def drop(p, axis):
    return p[:axis] + p[axis + 1:]


def dropped_axis(normal):
    """The coordinate of the largest magnitude, the lowest on a tie."""
    return max(range(3), key=lambda k: abs(normal[k]))


def validate(radius, loops):
    """Raises Rejected with the first code that applies to finite numbers."""
    reject_if(radius < 0, "negative-radius")
    reject_if(any(len(loop) < 3 for loop in loops), "too-few-vertices")
    reject_if(any(a == b for loop in loops for a, b in edges(loop)), "repeated-vertex")
    normal = newell(loops[0])
    reject_if(normal == (0, 0, 0), "zero-normal")
    flat = [[drop(p, dropped_axis(normal)) for p in loop] for loop in loops]
    reject_if(any(map(meets_itself, flat)), "loop-meets-itself")
    reject_if(any(meet(a, b) for a, b in combinations(flat, 2)), "loops-meet")
    reject_if(not all(begins_inside(hole, flat[0]) for hole in flat[1:]), "hole-outside")


def scaled_to_integers(center, to, radius, polygons):
    """The power of two that makes every number an integer, and the numbers times it."""
    numbers = [radius, *center, *(to or ()), *(x for loops in polygons if loops for loop in loops for p in loop for x in p)]
    scale = max(x.as_integer_ratio()[1] for x in numbers)

    def exact(x):
        numerator, denominator = x.as_integer_ratio()
        return numerator * (scale // denominator)

    def point(p):
        return tuple(map(exact, p))

    return scale, point(center), to and point(to), exact(radius), [loops and [[point(p) for p in loop] for loop in loops] for loops in polygons]


def quotient(a, b):
    """a / b, exactly, for an integer or a surd a and an integer b."""
    return Fraction(a, b) if isinstance(a, int) else a / b


def closest_on_edge(a, b, c, i, j):
    """Where edge i from vertex i (at a) to vertex j (at b) is closest to c.

    (squared distance, 0 for the edge or 1 for a vertex, index, numerators of the point, their denominator): the least
    of these is the contract's choice among equal distances.
    """
    along, to_c = sub(b, a), sub(c, a)
    t, length2 = dot(to_c, along), dot(along, along)
    if t <= 0:
        return quotient(dot(to_c, to_c), 1), 1, i, a, 1
    if t >= length2:
        return quotient(dot(sub(c, b), sub(c, b)), 1), 1, j, b, 1
    point = tuple(length2 * x + t * y for x, y in zip(a, along))
    return quotient(dot(to_c, to_c) * length2 - t * t, length2), 0, i, point, length2


def successors(loops):
    """The vertex that follows each vertex: edge i runs from i to successors[i]."""
    result = []
    for loop in loops:
        first = len(result)
        result += [*range(first + 1, first + len(loop)), first]
    return result


class Face:
    """A polygon in integers, lifted; its lengths are the case's times `scale`."""

    def __init__(self, loops):
        self.normal, self.count = newell(loops[0]), len(loops[0])
        self.total = tuple(map(sum, zip(*loops[0])))
        self.axis = dropped_axis(self.normal)
        self.follows = successors(loops)
        # Lifted vertices, times `unit` (which may be negative: a point reflection keeps all distances).
        vertices = [p for loop in loops for p in loop]
        self.heights = [self.height(p) for p in vertices]
        self.unit = self.count * self.normal[self.axis] if any(self.heights) else 1
        self.lifted = [tuple(self.unit * x - (h if k == self.axis else 0) for k, x in enumerate(p))
                       for p, h in zip(vertices, self.heights)]
        # The square of N, times `count`; and the loops in the projection, times this.
        self.magnitude = self.count * dot(self.normal, self.normal)
        self.flat = [[times(self.magnitude, drop(p, self.axis)) for p in loop] for loop in loops]

    def height(self, p):
        """count * N.(p - g)."""
        return self.count * dot(self.normal, p) - dot(self.normal, self.total)

    def foot(self, c):
        """q = c - (s / N.N) N, times `magnitude`."""
        s = self.height(c)
        return tuple(self.magnitude * x - s * y for x, y in zip(c, self.normal))

    def place(self, c):
        """Where the foot lies."""
        return locate(drop(self.foot(c), self.axis), self.flat)

    def edge(self, i, c):
        """Where edge i is closest to c, as closest_on_edge has it, all lengths times `unit`."""
        j = self.follows[i]
        return closest_on_edge(self.lifted[i], self.lifted[j], times(self.unit, c), i, j)

    def closest(self, c):
        """(squared distance, nearest, closest point as exact numbers)."""
        if self.place(c) == "inside":
            s = self.height(c)
            return (quotient(s * s, self.count * self.magnitude), {"kind": "face"},
                    [quotient(x, self.magnitude) for x in self.foot(c)])
        d2, is_vertex, index, point, denominator = min(self.edge(i, c) for i in range(len(self.lifted)))
        return (d2 / self.unit ** 2, {"kind": "vertex" if is_vertex else "edge", "index": index},
                [quotient(x, denominator * self.unit) for x in point])

    def normal_at(self, c, point):
        """The contact normal, for exact numbers: from the closest point to c, or N if they are equal."""
        away = sub(c, point)
        return nearest_unit(away if any(away) else self.normal)

    def off_plane(self, scale):
        most = max(map(abs, self.heights))
        return nearest_double(Fraction(most, self.count * abs(self.normal[self.axis]) * scale))


def nearest_depth(scale, r, d2):
    """The double nearest to r less the root of d2, both of which are times `scale`."""
    return nearest_double(surd.Surd(r, -1, d2) / scale)


def answer(scale, c, r, loops):
    """The contract's answer for valid integers, which are the case's numbers times `scale`."""
    face = Face(loops)
    foot, s = face.place(c), face.height(c)
    d2, nearest, point = face.closest(c)
    beyond_plane = s * s - r * r * face.count * face.magnitude
    return {
        "plane": "intersects" if beyond_plane <= 0 else "in_front" if s > 0 else "behind",
        "plane_tangent": beyond_plane == 0,
        "foot": foot,
        "edges_hit": [i for i in range(len(face.lifted)) if face.edge(i, c)[0] <= (face.unit * r) ** 2],
        "relation": "separate" if d2 > r * r else "touching" if d2 == r * r else "overlapping",
        "contact": d2 <= r * r,
        "nearest": nearest,
        "point": [nearest_double(x / scale) for x in point],
        "distance": nearest_root(d2 / scale ** 2),
        "contact_normal": face.normal_at(c, point),
        "depth": nearest_depth(scale, r, d2),
        "off_plane": face.off_plane(scale),
    }


# Moving balls. D(t) = r can only hold where the distance from the plane, from an edge's line or from a vertex is r:
# at roots of quadratics. Between two neighbouring roots the ball touches either always or never.

def roots(at):
    """The real roots of the quadratic with the values at(0), at(1) and at(2); none if it is constant."""
    f0, f1, f2 = (Fraction(at(t)) for t in (0, 1, 2))
    a, b = (f2 - 2 * f1 + f0) / 2, (4 * f1 - 3 * f0 - f2) / 2
    if a == 0:
        return [surd.Surd(-f0 / b)] if b else []
    discriminant = b * b - 4 * a * f0
    if discriminant < 0:
        return []
    return [surd.Surd(-b / (2 * a), sign / (2 * a), discriminant) for sign in (Fraction(-1), Fraction(1))]


def moments(face, center, r):
    """(time, whether the ball touches what gives rise to it) of each root, ascending."""
    def squared(v):
        return dot(v, v)

    def plane(t):
        return face.height(center(t)) ** 2 - r * r * face.count * face.magnitude

    result = [(t, face.place(center(t)) != "outside") for t in roots(plane)]
    for i, start in enumerate(face.lifted):
        along = sub(face.lifted[face.follows[i]], start)
        length2 = dot(along, along)

        def away(t):
            return sub(times(face.unit, center(t)), start)

        def vertex(t):
            return squared(away(t)) - (face.unit * r) ** 2

        def line(t):
            return squared(cross(away(t), along)) - (face.unit * r) ** 2 * length2

        result += [(t, True) for t in roots(vertex)]
        result += [(t, 0 <= dot(away(t), along) <= length2) for t in roots(line)]
    return sorted(result, key=lambda moment: cmp_to_key(surd.compare)(moment[0]))


def first_contact(scale, c, to, r, loops):
    """The exact first time, None without a contact, and the verdict on a moving ball for valid integers, which are the
    case's numbers times `scale`."""
    face, way = Face(loops), sub(to, c)

    def center(t):
        return tuple(x + t * y for x, y in zip(c, way))

    def verdict(first, time, momentary, feature, point, normal, depth):
        return {"contact": first != "none", "first": first, "time": time, "momentary": momentary, "feature": feature,
                "point": point, "contact_normal": normal, "depth": depth, "off_plane": face.off_plane(scale)}

    d2, feature, point = face.closest(c)
    if d2 <= r * r:
        return surd.Surd(Fraction(0)), verdict("start", 0, None, feature, [nearest_double(x / scale) for x in point], face.normal_at(c, point),
                                               nearest_depth(scale, r, d2))
    times_of_events = [moment for moment in moments(face, center, r) if moment[0] > 0]
    first = next((t for t, touches in times_of_events if touches), None)
    if first is None or first > 1:
        return None, verdict("none", None, None, None, None, None, None)
    d2, feature, point = face.closest(center(first))
    assert d2 == r * r, "the ball touches at its first time"
    later = next((t for t, _ in times_of_events if surd.compare(t, first) > 0), first + 1)
    after = face.closest(center(surd.between(first, later)))[0]
    if r > 0:
        normal = [nearest_double(quotient(x, 1) / r) for x in sub(center(first), point)]
    else:
        normal = nearest_unit(times(-1 if face.height(c) < 0 else 1, face.normal))
    return first, verdict("way", nearest_double(first), after > r * r, feature,
                   [nearest_double(x / scale) for x in point], normal, 0)


def answer_of_mesh(scale, c, to, r, faces):
    """The verdict on the posed faces of a mesh, likewise."""
    if to is None:
        found = [answer(scale, c, r, face) for face in faces]
        distances = [Face(face).closest(c)[0] for face in faces]
        order = cmp_to_key(lambda i, j: surd.sign(distances[i] - distances[j]))
    else:
        pairs = [first_contact(scale, c, to, r, face) for face in faces]
        found = [verdict for _, verdict in pairs]

        def compare_times(i, j):
            a, b = pairs[i][0], pairs[j][0]
            return (a is None) - (b is None) if a is None or b is None else surd.compare(a, b)

        order = cmp_to_key(compare_times)
    least = min(sorted(range(len(faces)), key=lambda i: len(faces[i][0]) != 3), key=order)
    verdict = {key: value for key, value in found[least].items() if key not in POLYGON_KEYS}
    verdict["touched"] = [i for i, one in enumerate(found) if one["contact"]]
    verdict["face"] = None if verdict.get("first") == "none" else least
    return verdict


def judge_case(text_line):
    """The verdict for one line: id and all answer keys, or id and `error`; None if the line is not JSON."""
    try:
        case, flaws = read_json(text_line)
    except ValueError:
        return None
    name = case.get("id") if isinstance(case, dict) else None
    verdict = {"id": name if isinstance(name, str) else None}
    try:
        reject_if("malformed-case" in flaws, "malformed-case")
        center, to, radius, polygons = read_case(case)
        reject_if("not-finite" in flaws, "not-finite")
        scale, center, to, radius, polygons = scaled_to_integers(center, to, radius, polygons)
        for loops in polygons:
            reject_if(loops is None, "not-finite")
            validate(radius, loops)
        if "mesh" in case:
            verdict.update(answer_of_mesh(scale, center, to, radius, polygons[1::2]))
        elif to is not None:
            verdict.update(first_contact(scale, center, to, radius, *polygons)[1])
        else:
            verdict.update(answer(scale, center, radius, *polygons))
    except Rejected as rejection:
        verdict["error"], = rejection.args
    return verdict


# Comparing

def differences(ours, line, method):
    """One sentence for each way in which the verdict line differs from our verdict."""
    try:
        theirs, flaws = read_json(line)
    except ValueError:
        return [f"the verdict is not JSON: {line!r}"]
    if not isinstance(theirs, dict) or flaws:
        return [f"the verdict is no object of finite numbers with distinct keys: {line!r}"]
    wanted = {**ours, "method": method}
    message = theirs.pop("message", None) if "error" in theirs else None
    result = [] if "error" not in theirs or isinstance(message, str) and message else ["an error without a message"]
    keys = [*wanted, *(k for k in theirs if k not in wanted and k not in EXPLAIN_KEYS)]
    for key in keys if ("error" in theirs) == ("error" in ours) else ["id", "method", "error"]:
        mine, other = (canonical(side[key]) if key in side else "nothing" for side in (wanted, theirs))
        if mine != other:
            result.append(f"{key} is {other}, should be {mine}")
    return result


def canonical(value):
    """A text that is equal for equal values: 1 and 1.0 are equal; 1 and true are not, nor 0 and -0 (never written)."""
    return json.dumps(json.loads(json.dumps(value), parse_int=float), sort_keys=True)


def filled_lines(path):
    """The lines of a file that are not only white space."""
    with open(path, "rb") as file:
        yield from (line for line in file if line.strip())


def compare(cases, verdicts, method, out):
    """Writes every difference between our verdicts for the cases and the given ones; whether all agree."""
    compared = rejects = found = 0
    ours = (verdict for verdict in map(judge_case, filled_lines(cases)) if verdict is not None)
    for mine, line in zip_longest(ours, filled_lines(verdicts)):
        if mine is None or line is None:
            problems = ["no verdict for this case" if line is None else f"a verdict too many: {line!r}"]
        else:
            problems = differences(mine, line, method)
            compared, rejects = compared + 1, rejects + ("error" in mine)
        for problem in problems:
            found += 1
            if found <= SHOWN:
                print(f"case {mine['id'] if mine else None}: {problem}", file=out)
    if found > SHOWN:
        print(f"... {found - SHOWN} differences more", file=out)
    print(f"{compared} cases compared, {rejects} of them rejects: {found or 'no'} differences", file=out)
    return compared > 0 and found == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--method", default="exact", help="the method that the verdicts must name")
    parser.add_argument("cases")
    parser.add_argument("verdicts")
    options = parser.parse_args()
    return 0 if compare(options.cases, options.verdicts, options.method, sys.stdout) else 1


if __name__ == "__main__":
    sys.exit(main())
