# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: judged_engines.py NAME [doubles]

Engines for the judge of the module and, behind a pipe, for the program's: what they return is a function of the question.
"""

import json
import random
import sys

import numpy as np
import touchstone_contact as touchstone
from touchstone_contact.judging.answers import KEYS, exact_answer, of_polygon
from touchstone_contact.judging.engine import Engine
from touchstone_contact.judging.question import Question, _question_of as question_of


def made(centre, radius, vertices, holes, to, faces, pose):
    """The question again, in doubles."""
    points = lambda array: tuple(tuple(map(float, point)) for point in array)
    return Question(points([centre])[0], float(radius), points(vertices), tuple(map(points, holes)), None if to is None else points([to])[0],
                    faces and tuple(map(tuple, faces)), None if pose is None else points(pose))


def fast(centre, radius, vertices, holes, to):
    return of_polygon(touchstone.fast, made(centre, radius, vertices, holes, to, None, None))


def corners(centre, radius, vertices):
    """Considers only the vertices, in floats."""
    return bool(np.min(np.linalg.norm(vertices - centre, axis=1)) <= radius)


def careless(centre, radius, vertices, holes, to, faces, pose):
    """The exact answer, with numbers rounded to floats and something wrong in every other key."""
    question = made(centre, radius, vertices, holes, to, faces, pose)
    draw = random.Random(repr((question.row(), question.points(), question.faces)))
    if draw.randrange(700) == 0:
        raise ArithmeticError("this one is too hard")
    answer = exact_answer(question)
    other = exact_answer(question.with_radius(question.radius * (1 + draw.choice([-1, 1]) * 2.0 ** draw.randrange(-30, -8))))
    for key in [key for key in KEYS if key in answer]:
        answer[key] = wrongly(key, answer[key], other.get(key), draw)
        if answer[key] == "omitted":
            del answer[key]
    return answer


def wrongly(key, value, other, draw):
    """The value of a key, or in about half of the cases another one."""
    kind, shift = draw.randrange(24), 1 + draw.choice([-1, 1]) * 2.0 ** draw.randrange(-24, -8)
    if kind < 8:
        return value
    if kind < 16 or value is None:
        return other
    if kind == 16:
        return draw.choice(["omitted", "nonsense", None])
    if isinstance(value, bool):
        return not value
    if isinstance(value, float):
        return float(np.float32(min(value * shift, 3e38)))
    if isinstance(value, int):
        return value + draw.choice([-1, 1])
    if key in ("edges_hit", "touched"):
        return draw.choice([value[1:], [0, *value], value[::-1], [*value, 1]])
    if isinstance(value, list):
        return [float(np.float32(max(min(x * shift, 3e38), -3e38))) for x in value]
    if isinstance(value, dict):
        return {"kind": draw.choice(["edge", "vertex"]), "index": draw.randrange(4)} if draw.randrange(3) else {"kind": "face"}
    return draw.choice(["in_front", "intersects", "inside", "boundary", "touching", "overlapping", "start", "way"])


ENGINES = {one.__name__: one for one in (fast, corners, careless)}

if __name__ == "__main__":
    engine = Engine(ENGINES[sys.argv[1]], np.float64 if "doubles" in sys.argv else np.float32)
    for line in sys.stdin:
        case = json.loads(line)
        question = question_of(case, None)
        if not engine.can(question):
            print(json.dumps({"id": case["id"]}), flush=True)
            continue
        try:
            print(json.dumps({"id": case["id"], **engine.answer(question)}).replace("Infinity", "null").replace("NaN", "null"), flush=True)
        except ArithmeticError as error:
            print(error, flush=True)
