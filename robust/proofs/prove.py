# SPDX-License-Identifier: Apache-2.0
"""Usage: python3 prove.py RECORD GAPPA

RECORD prints the constants of bounds.h and the operations of the expressions that they bound (record.cpp). Gappa must
prove every claim, at the unit of doubles and at that of double-doubles. It must refuse a constant that inputs and
rounding errors of the model exceed (adversary.py), which shows that the check can fail, and one within a sixteenth of
the claimed one, which shows that this is not loose. Exit status 1 if a claim is not proved or a smaller one is.
"""

import concurrent.futures
import fractions
import json
import math
import subprocess
import sys
import time

import adversary
import gappa


def read(program):
    """The model and the records; every number is a Fraction."""
    lines = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
    model, *records = [json.loads(line, parse_float=lambda text: fractions.Fraction(float(text)),
                                  parse_int=fractions.Fraction) for line in lines]
    return model, records


def below(value):
    """The largest sixteenth below the value."""
    return fractions.Fraction(math.ceil(value * 16) - 1, 16)


def judge(program, model, record):
    """The faults of one claim, and a line that says what is proved."""
    name = " ".join(filter(None, (record["constant"], record["instance"])))
    value, unit = record["value"], model["unit"]
    claimed = value - model["rounding_of_bound"]
    faults = []

    def proves(constant, at):
        return gappa.proves(program, gappa.script(record, at, constant), at)

    for at in (unit, model["double_double_unit"]):
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
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        for found, line in pool.map(lambda record: judge(program, model, record), records):
            faults += found
            print(line, flush=True)
    print(*faults, sep="\n")
    print(f"{len(records)} claims in {time.monotonic() - start:.0f} s, {len(faults)} faults")
    return 1 if faults or not records else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
