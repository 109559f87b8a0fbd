# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: object_code_test.py RECORD OBJDUMP COMMANDS BASELINE AVX2

The object code of the first stage for triangles decides by the signs that RECORD prints: operation by operation, fused or
not, from the numbers in memory on. BASELINE and AVX2 are the object files of the kernels; COMMANDS is the file that says how
they were compiled. Exit status 1 otherwise.
"""

import functools
import json
import pathlib
import re
import shlex
import struct
import subprocess
import sys
import tempfile
import unittest

import object_code

SOURCE = pathlib.Path(__file__).resolve().parents[3]
RECORD, OBJDUMP, COMMANDS, *FILES = sys.argv[1:6]
FILES = dict(zip(("baseline", "AVX2"), FILES))
# The kernels of one triangle, and the function whose record says by what they decide. Their first argument points to
# three vertices; the second to a centre, a radius and, for a motion, its end.
KERNELS = {"contact": "triangle_filter", "triangle_motion_contact": "capsule_filter"}
KERNELS_OF_SETS = ("set_contact", "set_any_contact", "set_triangles_hit")
FOURTH_LANE = {"baseline": (6, 8, 8), "AVX2": (7, 8, 7)}  # what load_three_points puts there, of nine coordinates
CONTACT = """#define TOUCHSTONE_TARGET avx2
#include "robust/filtered/detail/triangle/triangle_contact.h"
template bool touchstone::filtered::detail::avx2::contact(BallTriangleView, touchstone::filtered::NoCounts&);
"""
PLANTED = {  # more flags, and a change of LANES that the record does not see
    "none": ([], "#pragma once", "#pragma once"),
    "products are fused that are not in the source": (["-ffp-contract=fast"], "#pragma once", "#pragma once"),
    "a sum is computed in another order":
        ([], "multiply_add(a.x, b.x, multiply_add(a.y, b.y, a.z * b.z))", "multiply_add(a.z, b.z, multiply_add(a.y, b.y, a.x * b.x))"),
    "a difference is rounded twice":
        ([], "return fused_difference(a.parts[i], b.parts[i], c.parts[i])", "return a.parts[i] * b.parts[i] - c.parts[i]"),
    "an edge ends at the wrong vertex": ([], "_mm256_permute4x64_pd(a.parts[0], 0b01'00'10'01)", "_mm256_permute4x64_pd(a.parts[0], 0b01'00'10'10)"),
}
LANES = "robust/filtered/detail/numbers/lanes.h"


@functools.cache
def printed():
    model, *records = map(json.loads, subprocess.run([RECORD], check=True, capture_output=True, text=True).stdout.splitlines())
    functions = {(record["function"], record["target"]): record for record in records if "function" in record}
    return model, functions, [record for record in records if record.get("arithmetic") == "floats"]


def claims_about_floats(target):
    """The operations of a point of a triangle, and of a product of vectors, in lanes of floats."""
    found = [{node["node"]: node for node in record["nodes"]} for record in printed()[2]]
    return found[:2] if target == "baseline" else found[2:]


@functools.cache
def object_file(target):
    return object_code.ObjectFile(OBJDUMP, FILES[target])


def kernels(file, name):
    """The functions of this name, one for each way of counting stages."""
    return [function for function in file.functions if re.match(rf"\w[^()]* touchstone::[\w:]*::{name}<", function)]


def bits(number):
    return int.from_bytes(struct.pack("<d", number), "little")


def place(name, target):
    """Where a kernel finds an input of the record."""
    if found := re.fullmatch(r"vertex_([xyz])(\d)", name):
        axis, lane = "xyz".index(found[1]), int(found[2])
        return "rdi", 8 * (FOURTH_LANE[target][axis] if lane == 3 else 3 * lane + axis)
    return "rsi", 8 * ["centre_x", "centre_y", "centre_z", "radius", "to_x", "to_y", "to_z"].index(name)


def recorded(nodes, record):
    """The numbers of a record's nodes among those of object code."""
    numbers = {}
    for node in record["recorded"]:
        if "input" in node:
            added = nodes.add("input", *place(node["input"], record["target"]))
        elif "constant" in node:
            added = nodes.add("constant", bits(node["constant"]))
        else:
            added = nodes.add(node["operation"], *(numbers[of] for of in node["of"]))
        numbers[node["node"]] = added
    return numbers


def guarded(nodes, node):
    """The inputs of which a node says that they are at most half the largest number for lanes. None if it does not."""
    operation, *of = nodes.all[node]
    if operation != "-" or nodes.all[of[0]] != ("constant", bits(printed()[0]["largest"] / 2)):
        return None
    inputs, todo = set(), of[1:]
    while todo:
        operation, *of = nodes.all[node := todo.pop()]
        if operation == "input":
            inputs.add(node)
        elif operation in ("maximum", "magnitude"):
            todo += of
        elif (operation, *of) != ("constant", 0):
            return None
    return inputs


def differences(file, function, record):
    """In what the signs by which a kernel decides differ from those of the record, in sentences."""
    nodes = object_code.Nodes()
    numbers = recorded(nodes, record)
    decided = nodes.leaves(numbers[node] for node in record["decided"])
    names = {numbers[use[sign]]: f"{use['name']}, {sign}" for use in record["uses"] for sign in ("positive", "negative")}
    names.update({numbers[node]: "a sign of the fourth lane" for node in record["ignored"]})
    found = nodes.leaves(object_code.decisions(nodes, file, function, 8))
    guards = {node: guarded(nodes, node) or set() for node in found - set(names)}
    unguarded = {node for node in numbers.values() if nodes.all[node][0] == "input"}.difference(*guards.values())
    return [*(f"it does not decide by {names[node]}" for node in decided - found),
            *(f"it decides by {nodes.text(node)}" for node, inputs in guards.items() if not inputs),
            *(f"it takes any {nodes.text(node)}" for node in unguarded)]


def matches(nodes, claim, expected, node, inputs):
    """The ways to see a node as what a claim is about, by the nodes that stand for the claim's inputs."""
    if "input" in claim[expected]:
        if inputs.get(claim[expected]["input"], node) == node:
            yield {**inputs, claim[expected]["input"]: node}
        return
    operation, *of = nodes.all[node]
    if operation == claim[expected]["operation"]:
        for order in dict.fromkeys([tuple(of), (of[1], of[0], *of[2:])]):
            ways = [inputs]
            for operand, one in zip(claim[expected]["of"], order):
                ways = [way for inputs in ways for way in matches(nodes, claim, operand, one, inputs)]
            yield from ways


def computed(nodes, claim, inputs):
    """The node of what a claim is about, of these inputs."""
    numbers = {}
    for number, node in claim.items():
        numbers[number] = inputs[node["input"]] if "input" in node else nodes.add(node["operation"], *map(numbers.get, node["of"]))
    return numbers[number]


def is_corner(vertex, first, second):
    """Whether these are the differences of a vertex and the centre, and of the other vertices and this one."""
    return vertex[0] == first[0] == second[0] == "-" and vertex[1] == first[2] == second[2]


def supports(nodes, point, product, square):
    """What bounds the distance of a triangle from below, for each way to see `square` as that of the length of its point."""
    vectors = [[f"{name}_{axis}" for axis in "xyz"] for name in ("first_exact", "lane_vertex")]
    for way in matches(nodes, product, max(product), square, {}):
        coordinates, same = ([way[name] for name in names] for names in vectors)
        corners = [({}, [])] if coordinates == same else []
        for coordinate in coordinates:
            corners = [({name: found[name] for name in ("first_weight", "second_weight")},
                        [*known, [found[name] for name in ("lane_vertex_x", "lane_edge_x", "lane_edge_y")]])
                       for weights, known in corners for found in matches(nodes, point, max(point), coordinate, weights)]
        for _, corner in corners:
            if not all(is_corner(*map(nodes.all.__getitem__, components)) for components in corner):
                continue
            vertex, first, second = (computed(nodes, product, dict(zip(sum(vectors, []), [*coordinates, *vector])))
                                     for vector in zip(*corner))
            least = nodes.add("minimum", nodes.add("minimum", first, second), nodes.add("constant", 0))
            yield nodes.add("+", vertex, least)


def differences_of_floats(file, function, target):
    """In what the comparisons of a set's kernel differ from those of triangle_groups_contact.h, in sentences."""
    nodes = object_code.Nodes()
    found = {node: nodes.all[node] for node in object_code.decisions(nodes, file, function, 4)}
    lengths = {of[0] for operation, *of in found.values() if operation == "-" and nodes.all[of[0]][0] == "root"}
    bounds = set()
    for length in lengths:
        operation, *of = nodes.all[nodes.all[length][1]]
        for tiny, square in (of, reversed(of)) if operation == "+" else ():
            if nodes.all[tiny][0] == "constant":
                bounds.update((length, support) for support in supports(nodes, *claims_about_floats(target), square))
    missed = {}
    for node, (operation, *of) in found.items():
        if operation == "-" and of[0] not in lengths:
            missed[node] = {(length, of[1]) for length in nodes.all[of[0]][1:] if nodes.all[of[0]][0] == "*"} & bounds
    certain = {length for of in missed.values() for length, _ in of}
    return [*(f"it decides by {nodes.text(node)}" for node, of in missed.items() if not of),
            *(f"it decides by {nodes.text(node)}" for node, (operation, *_) in found.items() if operation != "-"),
            *(f"it compares the length {nodes.text(length)}" for length in lengths - certain),
            *["it does not decide in eight lanes"] * (len(lengths) != 8)]


class ObjectCode(unittest.TestCase):
    def check_kernels(self, name, found):
        for target in FILES:
            file = object_file(target)
            self.assertEqual(len(kernels(file, name)), 2)
            for kernel in kernels(file, name):
                with self.subTest(kernel):
                    self.assertEqual(found(file, kernel, target), [])

    def test_doubles_decide_by_the_recorded_signs(self):
        for name, function in KERNELS.items():
            self.check_kernels(name, lambda file, kernel, target: differences(file, kernel, printed()[1][function, target]))

    def test_floats_compare_as_recorded(self):
        for name in KERNELS_OF_SETS:
            self.check_kernels(name, differences_of_floats)


class Planted(unittest.TestCase):
    """Each bug is in the object code alone."""

    def changed(self, target, kernel, at, name):
        """The object file with an instruction of another name."""
        file = object_file(target)
        code = {**file.code(kernel), at: file.code(kernel)[at]._replace(name=name)}
        other = object_code.ObjectFile.__new__(object_code.ObjectFile)
        other.functions, other.starts = {**file.functions, kernel: code}, file.starts
        other.sections, other.symbols = file.sections, file.symbols
        return other

    def check_every_rounding(self, target, name, kind, found):
        kernel = kernels(object_file(target), name)[0]
        others = {"add": "sub", "sub": "add", "mul": "add"}
        rounding = {at: of.name for at, of in object_file(target).code(kernel).items()
                    if re.fullmatch(rf"v?(add|sub|mul|fn?m(add|sub)\d+)p{kind}", of.name)}
        self.assertGreater(len(rounding), 50)
        for at, name in rounding.items():
            other = re.sub("add|sub|mul", lambda found: others[found[0]], name)
            with self.subTest(f"{target}, {at:x}: {other} in place of {name}"):
                self.assertNotEqual(found(self.changed(target, kernel, at, other), kernel), [])

    def test_every_rounding_of_doubles_is_compared(self):
        for target in FILES:
            record = printed()[1]["triangle_filter", target]
            self.check_every_rounding(target, "contact", "d", lambda file, kernel: differences(file, kernel, record))

    def test_every_rounding_of_floats_is_compared(self):  # where those of the weights are in a function of their own
        self.check_every_rounding("baseline", "set_any_contact", "s",
                                  lambda file, kernel: differences_of_floats(file, kernel, "baseline"))

    def compiled(self, flags, old, new):
        """The object file of the kernel for one triangle, compiled for AVX2 as the kernels are, with a change."""
        command, = (shlex.split(entry["command"]) for entry in json.loads(pathlib.Path(COMMANDS).read_text())
                    if entry["file"].endswith("/kernels_avx2.cpp"))
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        lanes, source, result = folder / LANES, folder / "contact.cpp", folder / "contact.o"
        lanes.parent.mkdir(parents=True)
        text = (SOURCE / LANES).read_text()
        self.assertEqual(text.count(old), 1)
        lanes.write_text(text.replace(old, new))
        source.write_text(CONTACT)
        command[command.index("-o") + 1], command[command.index("-c") + 1] = str(result), str(source)
        subprocess.run([*command, *flags, f"-iquote{folder}", "-w"], check=True)
        return object_code.ObjectFile(OBJDUMP, result)

    def test_bugs_of_a_compiler_are_noticed(self):
        for bug, changes in PLANTED.items():
            with self.subTest(bug):
                file = self.compiled(*changes)
                kernel, = kernels(file, "contact")
                found = differences(file, kernel, printed()[1]["triangle_filter", "AVX2"])
                self.assertEqual(found != [], bug != "none")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
