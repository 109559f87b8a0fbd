# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: out_of_memory.py TOUCHSTONE

Whatever memory there is, the program ends by itself: with status 2 it says that memory was short, and for what if it
can. Exit status 1 otherwise.
"""

import json
import math
import os
import resource
import subprocess
import sys
import tempfile

from running import expect

SAYS_SO = "there is not enough memory to read", "touchstone: out of memory", "cannot be read to its end"
MIB = 1 << 20


def run(command, limit):
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))


def outcome(command, limit):
    """Exit status and sentence; nothing where the program cannot even be loaded: where it cannot print its help, because
    a shared library that it needs is not loaded, or initialises itself in vain before the program begins."""
    if run([command[0], "--help"], limit).returncode != 0:
        return None
    done = run(command, limit)
    return done.returncode, done.stderr


def check(command):
    refusals = 0
    for limit in range(24 * MIB, 400 * MIB, 8 * MIB):
        ended = outcome(command, limit)
        if ended is None:
            continue
        status, said = ended
        if status == 0:
            break
        expect(status == 2 and any(sentence in said for sentence in SAYS_SO), f"{command} with {limit // MIB} MiB: exit status {status}: {said}")
        refusals += 1
    expect(refusals > 0 and status == 0, f"{command}: it was refused {refusals} times, and ended with {status}")


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        circle = [[math.cos(2 * math.pi * i / 50_000), math.sin(2 * math.pi * i / 50_000), 0] for i in range(50_000)]
        cases, mesh = os.path.join(folder, "cases.jsonl"), os.path.join(folder, "mesh.off")
        with open(cases, "w") as file:
            json.dump({"id": "a", "ball": {"center": [0, 0, 1], "radius": 1}, "polygon": {"outer": circle}}, file)
        with open(mesh, "w") as file:
            file.write("OFF\n400000 1 0\n0 0 0\n1 0 0\n" + "0.12345678901 1 0\n" * 399_998 + "3 0 1 2\n")
        check([program, "judge", "--methods", "fast", cases])
        check([program, "ask", "--mesh", mesh, "--ball", "0,0,0,1"])


if __name__ == "__main__":
    main(*sys.argv[1:])
