# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: other_languages.py LIBRARY CORPUS [--rust RUSTC SCRATCH]

Python's ctypes, and with --rust a program in Rust without a crate, call the shared library LIBRARY about every case of
CORPUS and its folder `floats`, by the declarations of bindings/c: each answer has the certified keys, and each rejection the certified code. The program in
Rust answers with the same bits and messages as ctypes.
"""

import argparse
import ctypes as c
import json
import pathlib
import re
import struct
import sys

HERE = pathlib.Path(__file__)
sys.path += [str(HERE.parents[2] / "system"), str(HERE.parents[3] / "bindings/c")]
from running import expect, run  # noqa: E402
from touchstone_ctypes import Answer, Ball, Error, FirstContact, Motion, Vector, load  # noqa: E402

WORDS = {"plane": ("in_front", "behind", "intersects"), "foot": ("inside", "boundary", "outside"),
         "relation": ("separate", "touching", "overlapping"), "kind": ("face", "edge", "vertex"),
         "first": ("start", "way", "none")}
FIRST, TRIANGLE = "first", [[0, 0, 0], [1, 0, 0], [0, 1, 0]]


def feature_verdict(feature):
    word = WORDS["kind"][feature.kind]
    return {"kind": word} if word == "face" else {"kind": word, "index": feature.index}


def answer_verdict(answer, edges_hit):
    return {"plane": WORDS["plane"][answer.plane], "plane_tangent": bool(answer.plane_tangent),
            "foot": WORDS["foot"][answer.foot], "edges_hit": edges_hit, "relation": WORDS["relation"][answer.relation],
            "contact": answer.relation != 0, "nearest": feature_verdict(answer.nearest), "point": list(answer.point),
            "distance": answer.distance, "contact_normal": list(answer.contact_normal), "depth": answer.depth,
            "off_plane": answer.off_plane}


def contact_verdict(first):
    touches, on_way = first.kind != 2, first.kind == 1
    return {"contact": touches, "first": WORDS["first"][first.kind], "time": first.time if touches else None,
            "momentary": bool(first.momentary) if on_way else None,
            "feature": feature_verdict(first.feature) if touches else None, "point": list(first.point) if touches else None,
            "contact_normal": list(first.contact_normal) if touches else None, "depth": first.depth if touches else None}


def finite(value):
    """As JSON has it: a number beyond the finite doubles is null."""
    return json.loads(json.dumps(value), parse_constant=lambda _: None)


def bits(numbers):
    return [f"{word:x}" for word in struct.unpack(f"<{len(numbers)}Q", struct.pack(f"<{len(numbers)}d", *numbers))]


def members(answer, contact):
    a, f = answer, contact
    return " ".join(map(str, [
        a.plane, a.plane_tangent, a.foot, a.relation, a.nearest.index, a.nearest.kind,
        *bits([*a.point, a.distance, *a.contact_normal, a.depth, a.off_plane]),
        f.kind, f.momentary, f.feature.index, f.feature.kind, *bits([f.time, *f.point, *f.contact_normal, f.depth])]))


class Library:
    def __init__(self, path):
        self.c = load(path)
        self.error = Error()

    def call(self, name, *arguments):
        status = getattr(self.c, "touchstone_" + name)(*arguments, c.byref(self.error))
        expect(status == self.error.status, f"{name} returns {status}, the error says {self.error.status}")
        return status

    def polygon(self, loops):
        """The status and the handle."""
        numbers = [number for loop in loops for point in loop for number in point]
        sizes, polygon = [len(loop) for loop in loops], c.c_void_p()
        status = self.call("polygon_create", (c.c_double * len(numbers))(*numbers), (c.c_size_t * len(sizes))(*sizes),
                           len(sizes), c.byref(polygon))
        expect((status == 0) == bool(polygon), "a handle is NULL exactly after an error")
        return status, polygon

    def answer(self, polygon, motion):
        """The status, and of the ball at its start and on its way what is asked."""
        answer, contact, edges, count = Answer(), FirstContact(), (c.c_uint64 * 8)(), c.c_size_t()
        ball = c.byref(motion.ball)
        status = self.call("polygon_first_contact", polygon, c.byref(motion), 1, c.byref(contact))
        if not status:
            self.call("polygon_answer", polygon, ball, 1, c.byref(answer))
            self.call("polygon_edges_hit", polygon, ball, edges, 8, c.byref(count))
            if count.value > 8:
                edges = (c.c_uint64 * count.value)()
                self.call("polygon_edges_hit", polygon, ball, edges, count, c.byref(count))
        return status, answer, list(edges[:count.value]), contact


def cases(corpus):
    for file in sorted([*corpus.glob("*.jsonl"), *corpus.glob("floats/*.jsonl")]):
        for line in file.read_text().splitlines():
            case = json.loads(line)
            if case["expected"].get("error") == "malformed-case":
                continue  # no C program can ask it
            polygon = case["polygon"]
            loops = [polygon["outer"], *polygon.get("holes", [])]
            if polygon.get("closed"):
                loops = [loop[:-1] for loop in loops]
            ball = Ball(Vector(*case["ball"]["center"]), case["ball"]["radius"])
            to = case.get("motion", {}).get("to", case["ball"]["center"])
            yield file.name, case, loops, Motion(ball, Vector(*to))


def asked_in_rust(rustc, scratch, library, corpus):
    """What the program in Rust prints about all cases."""
    scratch.mkdir(parents=True, exist_ok=True)
    folder = library.resolve().parent
    run(rustc, "--edition=2021", "-Dwarnings", "-L", folder, "-l", "dylib=touchstone_c", "-C", f"link-arg=-Wl,-rpath,{folder}",
        HERE.with_name("caller.rs"), "-o", scratch / "caller")
    lines = []
    for _, _, loops, motion in cases(corpus):
        numbers = [number for loop in loops for point in loop for number in point]
        numbers += [*motion.ball.center, motion.ball.radius, *motion.to]
        lines.append(" ".join([f"{len(loops):x}", *(f"{len(loop):x}" for loop in loops), *bits(numbers)]))
    return run(scratch / "caller", input="\n".join(lines)).stdout.splitlines()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("library", type=pathlib.Path)
    parser.add_argument("corpus", type=pathlib.Path)
    parser.add_argument("--rust", nargs=2, type=pathlib.Path)
    options = parser.parse_args()
    library = Library(options.library)
    in_rust = iter(asked_in_rust(*options.rust, options.library, options.corpus) if options.rust else [])
    _, triangle = library.polygon([TRIANGLE])
    answers = rejections = 0
    for file, case, loops, motion in cases(options.corpus):
        place, expected = f"{file}: {case['id']}", case["expected"]
        code, polygon = library.polygon(loops)
        message = f"{code} {library.error.message.decode()}"
        if not code:
            code, answer, edges, contact = library.answer(polygon, motion)
            message = f"{code} {library.error.message.decode()}" if code else members(answer, contact)
        if options.rust:
            in_its_words = next(in_rust, None)
            expect(in_its_words == message, f"{place}: ctypes gets {message}, Rust {in_its_words}")
        if "error" in expected:
            # Of the rejections of polygon and ball, the first in the order of the codes.
            code = min(status for status in (code, library.answer(triangle, motion)[0]) if status)
            name = library.c.touchstone_status_name(code).decode()
            expect(name == expected["error"], f"{place}: {name}, expected is {expected['error']}")
            rejections += 1
        else:
            expect(code == 0, f"{place}: {message}")
            verdict = contact_verdict(contact) | {"off_plane": answer.off_plane} if FIRST in expected else answer_verdict(answer, edges)
            differing = [key for key in expected if finite(verdict[key]) != expected[key]]
            expect(not differing, f"{place}: {[(key, verdict[key], expected[key]) for key in differing]}")
            answers += 1
        library.c.touchstone_polygon_free(polygon)
    library.c.touchstone_polygon_free(triangle)
    expect(next(in_rust, None) is None, "Rust says more than it was asked")
    expect(answers > 8000 and rejections > 30, f"only {answers} answers and {rejections} rejections")
    print(f"{answers} answers and {rejections} rejections{', the same in Rust' if options.rust else ''}")


if __name__ == "__main__":
    main()
