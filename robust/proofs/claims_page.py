# SPDX-License-Identifier: Apache-2.0
"""Usage: python3 claims_page.py RECORD [--write]

Compares CLAIMS.md, the page of all claims and of what is left to trust, with what expressions.h, the record and the
sources say; --write writes it. Exit status 1 if the page differs, or if it has nothing to say about a constant.
"""

import collections
import os
import pathlib
import re
import sys

import claims
import coq
import prove

PROOFS = pathlib.Path(__file__).resolve().parent
ROOT = PROOFS.parents[1]
PAGE = PROOFS / "CLAIMS.md"
BOUNDS = "robust/filtered/detail/signs/bounds.h"
# Headers with constants that are proved over the calculus or by counting roundings, and where these may be used.
OTHER_HEADERS = ["geometry/contact/fast_error.h", "robust/filtered/detail/motion/polygon_events.h",
                 *(f"robust/scene/detail/{name}.h" for name in ("rounded_sum", "culling_ball", "culling_motion", "own_frame",
                                                                "distance_bound", "held_vertex", "lifted_box",
                                                                "crossed_triangles"))]

# What is left to trust of the constants of bounds.h that no claim is about.
AFTER_STEPS = "Coq checks the steps of the calculus; roots, powers and the comparison are C++ over GMP"
RATIOS = "ratios of computed numbers to exact ones, over the operations that run, in C++ over GMP"
BY_DEFINITION = "part of the model or of what callers ensure"
LEFT = {
    **dict.fromkeys(("kUnit", "kDoubleDoubleUnit", "kFloatUnit", "kFloatTiny", "kLargest", "kLongestMotion"),
                    BY_DEFINITION),
    **dict.fromkeys(("kTiny", "kSmallest", "kFramePoint", "kFrameDirection", "kFrameLength", "kExtent", "kHeight", "kGivenHeight",
                     "kDistance", "kNear", "kBoxReach", "kBoxRounding", "kLaneDistance", "kLaneVertex", "kLift", "kSlope",
                     "kLiftedEdge", "kLiftedMaximum", "kPerSquare", "kClosest", "kUnnormalised"), AFTER_STEPS),
    **dict.fromkeys(("kWide", "kNarrow"), RATIOS),
    "kWideError": AFTER_STEPS + ". The roundings of errors: " + RATIOS,
    **dict.fromkeys(("kLaneCentre", "kLaneStored"), RATIOS), "kLaneTiny": AFTER_STEPS,
    "kNormalUnderflow": "an argument about underflow, in rationals; measured, against rationals",
}
LEFT_OF_OTHERS = {
    "polygon_events": AFTER_STEPS + ". Times, reaches and boxes: by hand, what they contain if numbers are off by so much",
    "rounded_sum": "what `Permanent` guarantees, and C++ over GMP", "culling_ball": AFTER_STEPS,
    "own_frame": "that the constants cover the roundings, which `Permanent`, ratios and the calculus count: C++ over GMP",
    "distance_bound": AFTER_STEPS + ". `kWide`: " + RATIOS,
    "culling_motion": AFTER_STEPS + ". `kStill`: C++ over GMP", "held_vertex": RATIOS, "lifted_box": AFTER_STEPS,
    "crossed_triangles": AFTER_STEPS,
    "fast_error": AFTER_STEPS + ". Squares and quotients: " + RATIOS + ". From numbers to contact: by hand, the steps of its proof",
}


def listed_expressions():
    """The expression of each claim of expressions.h, by constant and instance."""
    text = (PROOFS / "expressions.h").read_text()
    found = re.findall(r'visit\(\w+\{"(\w+)", "([^"]*)",.*?return (.*?);', text, re.DOTALL)
    return {(constant, instance): re.sub(r"\s+", " ", expression.replace("in.", ""))
            for constant, instance, expression in found}


def sources(folder):
    return sorted(path for path in (ROOT / folder).rglob("*")
                  if path.suffix in (".h", ".cpp") and PROOFS not in path.parents)


def users(constant, folder):
    """The files of a folder whose code names the constant of bounds.h."""
    name = re.compile(rf"\bbounds::{constant}\b")
    return [path for path in sources(folder) if name.search(re.sub(r"//.*", "", path.read_text()))]


def links(paths, otherwise="other constants"):
    return ", ".join(f"[{path.name}]({os.path.relpath(path, PROOFS)})" for path in paths) or otherwise


def constants_of(header):
    declared = ("inline constexpr double", "static constexpr double")
    lines = (line for line in (ROOT / header).read_text().splitlines() if line.lstrip().startswith(declared))
    return re.findall(r"\b(k[A-Z]\w*) = ", "\n".join(lines))


def named_constants_of(header):
    """The constants of a header, each with the innermost namespace before it."""
    space = ""
    for line in (ROOT / header).read_text().splitlines():
        space = next(iter(re.findall(r"^namespace (?:\w+::)*(\w+) \{", line)), space)
        if line.startswith("inline constexpr double"):
            yield from (f"`{space}::{constant}`" for constant in re.findall(r"\b(k[A-Z]\w*) = ", line))


def table(head, rows):
    lines = ["| " + " | ".join(row) + " |" for row in [head, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:]])


def named(record, listed):
    """The constants of bounds.h that may be that of the signs: the record knows only its value."""
    values = dict(re.findall(r"constexpr double (k\w+) = ([\d.]+);", (ROOT / BOUNDS).read_text()))
    declared = {name for use in record["uses"] if (name := use.split()[1]) in values}
    return sorted(declared or {name for name, value in values.items()
                               if float(value) == float(record["value"]) and name not in {*LEFT, *listed}})


def defining(function):
    """The header that defines a function, or a class, which decides."""
    definition = re.compile(rf"^(class|(TOUCHSTONE_INLINE |inline )?(FilterResult|int)) {function}\b", re.MULTILINE)
    return [path for path in sources("robust") if path.suffix == ".h" and definition.search(path.read_text())][:1]


def joined(rows):
    """Rows that differ in their arithmetic alone, the last column, are one."""
    found = {}
    for *row, arithmetic in rows:
        found.setdefault(tuple(row), []).append(arithmetic)
    return [[*row, ", ".join(dict.fromkeys(arithmetics))] for row, arithmetics in found.items()]


def rows_of_uses(model, used, listed):
    """What each function takes to be certain, by claim."""
    for record in used:
        claim, = claims.of_record(model, record)
        by_function = collections.defaultdict(list)
        for use in record["uses"]:
            function, _, sign = use.partition(" ")
            by_function[function].append(f"`{sign}`")
        signs = "; ".join(f"{links(defining(function))}: {', '.join(its)}" for function, its in by_function.items())
        names = ", ".join(f"`{name}`" for name in named(record, listed))
        yield [signs, names, str(float(record["value"])), claim.proved, claim.arithmetic]


def rows_of_list(model, listed):
    expressions = listed_expressions()
    for record in listed:
        constant, instance = record["constant"], record["instance"]
        claim, = claims.of_record(model, record)
        yield [f"`{expressions[constant, instance]}`", f"`{constant}`{' ' + instance if instance else ''}",
               str(float(record["value"])), links(users(constant, "robust")), claim.proved, claim.arithmetic]


def rows_left(used, listed):
    proved = {record["constant"] for record in listed}
    proved |= {name for record in used for name in named(record, proved)}
    constants = [constant for constant in constants_of(BOUNDS) if constant not in proved]
    if set(constants) ^ set(LEFT):
        raise ValueError(f"nothing is said, or too much, about {sorted(set(constants) ^ set(LEFT))}")
    for constant in constants:
        tests = links(users(constant, "tests/robust"), "none names it")
        yield [f"`{constant}`", links(users(constant, "robust")), tests, LEFT[constant]]
    for header in OTHER_HEADERS:
        name = pathlib.Path(header).stem
        tests = [path for path in sources("tests/robust") if header in path.read_text()]
        yield [", ".join(named_constants_of(header)), links([ROOT / header]), links(tests), LEFT_OF_OTHERS[name]]


def page(model, records):
    used = [record for record in records if "uses" in record]
    listed = [record for record in records if "uses" not in record]
    constants = {record["constant"] for record in listed}
    signs = {use for record in used for use in record["uses"] if not use.endswith(" kNormal")}  # what is known is no sign
    axioms = ",\n  ".join(f"`{axiom}`" for axiom in coq.AXIOMS)
    return f"""# Claims, and what they rest on

<!-- Written by robust/proofs/claims_page.py --write; a test compares. -->

The filters rest on {len(records)} claims. From {len(used)} of them follow the {len(signs)} signs on which it depends in lanes whether a ball,
at rest or moving, touches a triangle, and those that double-doubles decide. What computes and combines these signs records
itself, as compiled for SSE2 and for AVX2, whose products are fused. The other {len(listed)} claims are about parts of other bounds.
`./check` has Gappa prove all from the record. Its stage `coq` has Coq check all {len(records)}, the rules of the error
calculus, the lemmas of parity and of own frames, and each step of the calculus that the tests carry out. See [the proofs](README.md) for how.

A claim says: for inputs whose magnitudes are at most 1 and whose errors are those that `bounds.h` states, the computed
value differs from the exact one by at most `proved`, if each operation has a relative error of at most one unit. The
unit is 2^-52 for doubles, 2^-103 for double-doubles, 2^-23 for floats; u is 2^-53. The constant exceeds what is proved
by what the rounding of the bound may take. Each file `build/coq/CLAIM.v` that the stage leaves begins with the claim in
full.

## Signs that functions take to be certain

The record holds the value of the constant, the maxima by which it is multiplied, what they bound, and the operations of the
sign. It does not hold the name of the constant: all names with this value are listed.

{table(["signs", "constant", "value", "proved", "arithmetic"], joined(rows_of_uses(model, used, constants)))}

## Parts of other bounds

{table(["expression", "constant", "value", "used in", "proved", "arithmetic"], joined(rows_of_list(model, listed)))}

## How Coq checks them

Gappa finds the proofs and prints them for Coq, assuming its hints. Here Coq proves the hints (`ring`, `field`), and from
Gappa's result the claim as [statement.py](statement.py) writes it. So neither Gappa nor the proof that it prints has to
be trusted.

## What else Coq proves

- [model.v](coq/model.v): the model in which claims are stated.
- [parity.v](coq/parity.v): a chain of edges crosses a line an odd number of times exactly if one of its ends is above
  the line; of several chains, modulo 2, as often as they have ends above. Used in
  [frame_query.h](../filtered/detail/polygon/frame_query.h), where boxes that are not met count by the ends of their chains.
- [own_frame.v](coq/own_frame.v): the inequalities of norms by which [own_frame.h](../scene/detail/own_frame.h) bounds what
  a pose that nearly is a rotation times a number does to lengths, from the sums of rows and columns on.
- [error_free.v](coq/error_free.v): the error-free sums, differences and products of doubles to nearest are exact where nothing
  overflows or underflows: each as recorded, with and without fused products.
- [calculus.v](coq/calculus.v): each rule of [error_bound.h](error_bound.h). A step that Coq finds justified holds for
  all numbers within its bounds and all roundings of the model. All steps that the tests carry out are recorded and
  checked, underflow included.

## Constants that Coq does not prove

{table(["constant", "used in", "tests", "what is left to trust"], rows_left(used, listed))}

The roundings of permanents (`Roundings`) are counted by templates and compared with a calculus of factors in
[permanent_test.cpp](../../tests/robust/proofs/permanent_test.cpp). The errors that `NewellSums` carries along are computed
with the numbers, and compared with rationals; those of `numbers/bounded.h` also by the calculus.

## What is left to trust

Of the claims that Coq checks:
- Coq's kernel, and what its library assumes of real numbers and of logic. The stage fails if a theorem assumes anything
  but
  {axioms}.
- [record.cpp](record.cpp) runs what computes and combines signs over a type in place of doubles. It does so from differences
  and vertices on. [uses.py](uses.py) finds out what each sign rests on. [statement.py](statement.py) and [signs.py](signs.py)
  state it.
- The compiler, and what loads vertices into lanes. Only for some kernels of triangles, compiled by g++ for x86-64, a test
  compares the [object code](README.md#object-code) with the record, from memory on: not for scaled triangles, nor for copies
  in other kernels, polygons, scenes and double-doubles.
- What a maximum bounds is recorded, with exceptions: the maximum of `ahead_out` holds by the triangle inequality, and the
  recorder says what it must be; callers ensure the maxima of double-doubles and the units of scaled triangles.
- For the other bounds, expression and constant are paired by hand in [expressions.h](expressions.h).
- What combines the signs is tested, not proved.
- [Scaling](README.md#what-is-proved) from maxima of 1 to all maxima, the 1/32 of a constant and the addition of `kTiny`,
  which the tests of bounds compare in rationals.
- In double-doubles, `dot` and `cross` round otherwise than the sums and products that are recorded. That the claims hold
  with `kDot` and `kCross` in place of these is shown by the calculus, of which the next paragraph holds.
- The arithmetic: IEEE-754 for doubles and floats; for double-doubles the bounds of [joldes2017]. Inputs are as accurate as
  `bounds.h` states.

Of the calculus and the constants that Coq does not prove, besides the last column:
- Each step of the calculus is checked, but not that the next step takes its result, nor the arithmetic that tests do
  around it: they are C++ over GMP's rationals. The bound `off` of a sum of products is made there, too.
- The geometry: that a foot, a box or a ball that is off by so much is decided as the comments of the tests argue.
"""


def main(recorder, *options):
    text = page(*prove.read(recorder))
    if options == ("--write",):
        PAGE.write_text(text)
    elif not PAGE.exists() or PAGE.read_text() != text:
        print(f"{PAGE} differs from the sources; claims_page.py --write updates it")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
