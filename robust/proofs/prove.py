# SPDX-License-Identifier: Apache-2.0
"""Usage: python3 prove.py RECORD GAPPA

RECORD prints the constants of bounds.h and the operations of the expressions that they bound (record.cpp). Gappa must
prove every claim, at the units of doubles, double-doubles and floats. It must refuse a constant that inputs and
rounding errors of the model exceed (adversary.py), which shows that the check can fail, and one within a sixteenth of
the claimed one, which shows that this is not loose. For sums of products of double-doubles it must refuse a constant
that is one u^2 smaller, u = 2^-53, and any rest of an error-free transformation that is left out; for quotients and
roots one that is one u^2 smaller. Exit status 1 if a claim is not proved or a smaller one is.
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
import quotients
import signs


def read(program):
    """The model and the records; every number is a Fraction."""
    lines = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
    model, *records = [json.loads(line, parse_float=lambda text: fractions.Fraction(float(text)),
                                  parse_int=fractions.Fraction) for line in lines]
    return model, records


def below(value):
    """The largest sixteenth below the value."""
    return fractions.Fraction(math.ceil(value * 16) - 1, 16)


def name_of(record):
    return " ".join(filter(None, (record["constant"], record["instance"])))


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
    """The faults of the claim about a quotient or a root, and a line that says what is proved."""
    name, proved, unit = name_of(record), record["proved"], quotients.UNIT
    faults = []
    if proved * unit * unit > record["value"] * model["double_double_unit"]:
        faults.append(f"{name}: {float(record['value'])} units are less than {proved} u^2")
    if not gappa.proves(program, quotients.claim(record, proved), unit**2):
        faults.append(f"{name}: {proved} u^2 is not proved")
    if gappa.proves(program, quotients.claim(record, proved - 1), unit**2):
        faults.append(f"{name}: {proved - 1} u^2 is proved too")
    return faults, f"{name}: {float(record['value'])}; proved {proved} u^2; too small {proved - 1} u^2"


def judge(program, model, record):
    """The faults of one claim, and a line that says what is proved."""
    name = name_of(record)
    value, unit = record["value"], model["unit"]
    claimed = value - model["rounding_of_bound"]
    faults = []

    def proves(constant, at):
        return gappa.proves(program, signs.claim(record, at, constant), at)

    for at in (unit, model["double_double_unit"], model["float_unit"]):
        if not proves(claimed, at):
            faults.append(f"{name}: {float(claimed)} is not proved at unit {float(at):.3g}")
    reached = adversary.reached(record, unit)
    if reached > claimed:
        faults.append(f"{name}: the model's errors reach {float(reached)}")
    smaller = sorted({below(reached), max(below(reached), value * fractions.Fraction(15, 16))})
    for constant in smaller:
        if proves(constant, unit):
            faults.append(f"{name}: {float(constant)} is proved too, and the model's errors reach {float(reached)}")
    return faults, (f"{name}: {float(value)}; proved {float(claimed)}; errors reach {float(reached):.3f}; too small "
                    + ", ".join(str(float(constant)) for constant in smaller))


def main(recorder, program):
    start = time.monotonic()
    model, records = read(recorder)
    faults = []
    judges = {"nodes": judge, "words": judge_sum_of_products, "numbers": judge_quotient}
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        for found, line in pool.map(lambda record: judges[next(filter(record.get, judges))](program, model, record), records):
            faults += found
            print(line, flush=True)
    print(*faults, sep="\n")
    print(f"{len(records)} claims in {time.monotonic() - start:.0f} s, {len(faults)} faults")
    return 1 if faults or not records else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
