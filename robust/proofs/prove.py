# SPDX-License-Identifier: Apache-2.0
"""Usage: python3 prove.py RECORD GAPPA [--uses]

RECORD prints the constants of bounds.h, the operations of the expressions that they bound, and what functions compute that
take signs to be certain (record.cpp). Every such sign must follow from a claim (uses.py); --uses: nothing but this, up to
the first fault. Gappa must prove every claim, at the unit of its arithmetic. It must refuse a constant that inputs and rounding errors of the
model exceed (adversary.py) or, where that is larger and no operation is fused, a sixteenth less than the claimed one: so
the check can fail, and the constant is not loose. For sums of products of double-doubles it must refuse a constant that is
one u^2 smaller, u = 2^-53, and any rest of an error-free transformation that is left out; for quotients, reciprocals and
roots one that is one u^2 smaller; for a permanent the next smaller double. Exit status 1 if a claim is not proved or a smaller one is.
"""

import concurrent.futures
import fractions
import json
import math
import subprocess
import sys
import time

import adversary
import double_words
import gappa
import permanents
import quotients
import signs
import uses


# The units of the arithmetics: in any rounding direction, except for that of doubles to nearest.
LEAST_UNITS = {"unit": fractions.Fraction(1, 2**52), "double_double_unit": fractions.Fraction(1, 2**103),
               "float_unit": fractions.Fraction(1, 2**23), "nearest_unit": fractions.Fraction(1, 2**53)}


def recorded(program):
    """What the program prints; every number is a Fraction."""
    done = subprocess.run([program], capture_output=True, text=True)
    if done.returncode != 0:
        raise uses.Misuse(f"nothing is recorded: {done.stderr.strip()}")
    return [json.loads(line, parse_float=lambda text: fractions.Fraction(float(text)), parse_int=fractions.Fraction)
            for line in done.stdout.splitlines()]


def read(program):
    """The model and the record of each claim."""
    model, *records = recorded(program)
    for name, least in LEAST_UNITS.items():
        if model[name] < least:
            raise uses.Misuse(f"{name}: operations round by more than {float(model[name]):.3g}")
    functions = [record for record in records if "function" in record]
    listed = [renumbered(record) if "nodes" in record else record
              for record in records if "function" not in record and "transformation" not in record]
    once = [record for i, record in enumerate(listed) if record not in listed[:i]]  # lanes of two targets may do the same
    return model, once + uses.claims(model, functions)


def renumbered(record):
    """The record with its nodes numbered from 0."""
    number = {node["node"]: i for i, node in enumerate(record["nodes"])}
    nodes = [{**node, "node": i, **({"of": [number[of] for of in node["of"]]} if "of" in node else {})}
             for i, node in enumerate(record["nodes"])]
    return {**record, "nodes": nodes}


def is_fused(record):
    return any("fused" in node.get("operation", "") for node in record["nodes"])


def claimed_of(model, record):
    """The constant that is to be proved: a permanent's claim counts the roundings of its bound itself."""
    return record["value"] - (0 if "monomials" in record else model["rounding_of_bound"])


def below(value):
    """The largest sixteenth below the value."""
    return fractions.Fraction(math.ceil(value * 16) - 1, 16)


def name_of(record):
    words = [record["constant"], record["instance"]]
    if "nodes" in record:
        words += ["in", "fused" if is_fused(record) else "", record["arithmetic"]]
    return " ".join(filter(None, words))


def judge_sum_of_products(program, model, record):
    """The faults of one claim about double-doubles, and a line that says what is proved."""
    name, proved, unit = name_of(record), record["proved"], double_words.UNIT
    faults = []

    def proves(constant, of=record):
        return gappa.proves(program, double_words.claim(of, constant), unit)

    if proved * unit * unit > record["value"] * model["double_double_unit"]:
        faults.append(f"{name}: {float(record['value'])} units are less than {proved} u^2")
    if not proves(proved):
        faults.append(f"{name}: {proved} u^2 is not proved")
    if proves(proved - 1):
        faults.append(f"{name}: {proved - 1} u^2 is proved too")
    without_a_rest = list(double_words.faulty(record))
    for i, without in enumerate(without_a_rest):
        if proves(proved, without):
            faults.append(f"{name}: {proved} u^2 is proved without rest {i}")
    return faults, (f"{name}: {float(record['value'])}; proved {proved} u^2; too small {proved - 1} u^2; refused without "
                    f"any of {len(without_a_rest)} rests")


def judge_quotient(program, model, record):
    """The faults of the claim about a quotient, a reciprocal or a root, and a line that says what is proved."""
    name, proved, unit = name_of(record), record["proved"], quotients.UNIT
    faults = []
    if proved * unit * unit > record["value"] * model["double_double_unit"]:
        faults.append(f"{name}: {float(record['value'])} units are less than {proved} u^2")
    if not gappa.proves(program, quotients.claim(record, proved), unit**2):
        faults.append(f"{name}: {proved} u^2 is not proved")
    if gappa.proves(program, quotients.claim(record, proved - 1), unit**2):
        faults.append(f"{name}: {proved - 1} u^2 is proved too")
    return faults, f"{name}: {float(record['value'])}; proved {proved} u^2; too small {proved - 1} u^2"


def unproved(program, model, record):
    """The fault of a claim that Gappa does not prove, if any."""
    unit, claimed = model[uses.UNITS[record["arithmetic"]]], claimed_of(model, record)
    if not gappa.proves(program, signs.claim(record, unit, claimed), unit):
        yield f"{name_of(record)}: {float(claimed)} is not proved"


def judge(program, model, record):
    """The faults of one claim, and a line that says what is proved."""
    name = name_of(record)
    value, unit = record["value"], model[uses.UNITS[record["arithmetic"]]]

    def proves(constant):
        return gappa.proves(program, signs.claim(record, unit, constant), unit)

    claimed = claimed_of(model, record)
    faults = list(unproved(program, model, record))
    proved = f"{name}: {float(value)}; {'not ' if faults else ''}proved {float(claimed)}"
    if "monomials" in record:
        least = permanents.least(record, unit)
        below_least = math.nextafter(least, 0)
        if not proves(fractions.Fraction(least)) or proves(fractions.Fraction(below_least)):
            faults.append(f"{name}: {least} is not the least double that is proved")
        return faults, f"{proved}; least double that is proved {least}; too small {below_least}"
    reached = adversary.reached(record, unit)
    if reached > claimed:
        faults.append(f"{name}: the model's errors reach {float(reached)}")
    smaller = below(reached)
    if not is_fused(record):  # what is fused rounds less than the constant allows for
        smaller = max(smaller, value * fractions.Fraction(15, 16))
    if proves(smaller):
        faults.append(f"{name}: {float(smaller)} is proved too, and the model's errors reach {float(reached)}")
    return faults, f"{proved}; errors reach {float(reached):.3f}; too small {float(smaller)}"


def main(recorder, program, *options):
    start = time.monotonic()
    try:
        model, records = read(recorder)
    except uses.Misuse as misuse:
        print(misuse)
        return 1
    if options:
        fault = next((fault for record in records if "uses" in record for fault in unproved(program, model, record)), None)
        print(fault or "every sign that is taken to be certain is proved to be")
        return 1 if fault else 0
    faults = []
    judges = {"nodes": judge, "monomials": judge, "words": judge_sum_of_products, "numbers": judge_quotient}
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        for found, line in pool.map(lambda record: judges[next(filter(record.get, judges))](program, model, record), records):
            faults += found
            print(line, flush=True)
    print(*faults, sep="\n")
    print(f"{len(records)} claims in {time.monotonic() - start:.0f} s, {len(faults)} faults")
    return 1 if faults or not records else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
