# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a function sets the floating-point state, its arithmetic is between that and the state's restoration.

Usage: state_holds_arithmetic.py LIBRARY... [-- SOURCE COMPILER FLAG...]

Reads the disassembly of every function of the libraries that stores MXCSR (FloatingPointState: `stmxcsr`, a comparison
with 0x1f80, `ldmxcsr` if they differ; at the end `stmxcsr`, a comparison with what was found, `ldmxcsr`). On no path
there may be floating-point arithmetic, comparison or conversion of SSE or AVX
  (1) from the function's start to the first state's beginning, except in functions whose first stage is valid in
      every rounding direction (ANY_ROUNDING),
  (2) from `stmxcsr` at a state's beginning to `ldmxcsr`, or to the jump that leaves it out,
  (3) from `stmxcsr` at a state's end to the function's return, the next state or a jump out of the function, unless
      that state lies within another one.
What is reached by exceptions or tables of jumps alone is followed from there for (2) and (3). Functions that are
called are not followed. With a compiler, samples that break each rule are compiled and must be found, others must not.
"""

import collections
import os
import re
import subprocess
import sys
import tempfile

# Before the state is set, doubles are filtered by bounds that hold in every rounding direction.
ANY_ROUNDING = re.compile(r"touchstone::filtered::detail::(avx2|baseline)::ask<")

ARITHMETIC = re.compile(r"v?(add|sub|mul|div|sqrt|rsqrt|rcp|min|max|u?comi|cmp[a-z_]*|round|addsub|hadd|hsub|dp|"
                        r"fn?m(add|sub|addsub|subadd)(132|213|231))[ps][sd]|v?cvt\w+")
BEFORE, ENTERING, INSIDE, AFTER, UNKNOWN = "before", "entering", "inside", "after", "unknown"
MOST_NESTED = 4  # states; paths that never run may begin more of them
HEAD = re.compile(r"^[0-9a-f]+ <(.+)>:$")
LINE = re.compile(r"^\s*([0-9a-f]+):\t(\S+)(?:\s+(.*?))?\s*$")
RELOCATION = re.compile(r"^\s*[0-9a-f]+: R_X86_64_")
Instruction = collections.namedtuple("Instruction", "address mnemonic operands leaves")


def functions(library):
    """(name, instructions) of each function; an instruction `leaves` if a relocation says where it goes."""
    text = subprocess.run(["objdump", "--disassemble", "--demangle", "--reloc", "--no-show-raw-insn", library],
                          capture_output=True, text=True, check=True).stdout
    name, body = None, []
    for line in text.splitlines():
        if match := HEAD.match(line):
            if name:
                yield name, body
            name, body = match.group(1), []
        elif RELOCATION.match(line):
            if body:
                body[-1] = body[-1]._replace(leaves=True)
        elif match := LINE.match(line):
            mnemonic, operands = match.group(2), match.group(3) or ""
            while mnemonic in ("notrack", "bnd", "rep", "repz", "repnz", "lock", "data16", "cs"):
                mnemonic, _, operands = operands.partition(" ")
            body.append(Instruction(int(match.group(1), 16), mnemonic, operands.strip(), False))
    if name:
        yield name, body


def begins(body, i):
    """Is this stmxcsr that of a state's beginning? It is compared with the default soon."""
    for instruction in body[i + 1:i + 16]:
        if "mxcsr" in instruction.mnemonic or instruction.mnemonic.startswith(("call", "ret")):
            return False
        if instruction.mnemonic.startswith("cmp") and "$0x1f80," in instruction.operands:
            return True
    return False


def sets_rounding_alone(body, i):
    """Is this stmxcsr one of CGAL's intervals? They replace the two bits of the rounding mode and keep all others."""
    for instruction in body[i + 1:i + 16]:
        if instruction.mnemonic.startswith(("and", "mov")) and re.match(r"\$0x(9f,%[a-d]h|ffff9fff,)", instruction.operands):
            return True
        if "mxcsr" in instruction.mnemonic or instruction.mnemonic.startswith(("call", "ret")):
            return False
    return False


def is_of_intervals(name, body, stores):
    """Do CGAL's intervals alone store MXCSR there? clang++ keeps their mask in a register, from the first one on."""
    alone = [sets_rounding_alone(body, i) for i in stores]
    return all(alone) or (any(alone) and not name.endswith(".cold]") and not any(begins(body, i) for i in stores))


def sets(body, i):
    """Does the run of instructions from i on, up to a jump or call, set MXCSR?"""
    for instruction in body[i:]:
        if "ldmxcsr" in instruction.mnemonic:
            return True
        if instruction.mnemonic.startswith(("j", "call", "ret")) or "stmxcsr" in instruction.mnemonic:
            return False
    return False


def successors(body, by_address, i):
    """The numbers of the instructions of this function that may follow, but for jumps by a table."""
    instruction = body[i]
    if instruction.mnemonic.startswith("ret") or instruction.mnemonic == "ud2":
        return []
    following = [i + 1] if i + 1 < len(body) and instruction.mnemonic != "jmp" else []
    if not instruction.mnemonic.startswith("j") or instruction.leaves or instruction.operands.startswith("*"):
        return following
    target = by_address.get(int(instruction.operands.split()[0], 16))
    return following if target is None else following + [target]


def faults(name, body):
    """Sentences about arithmetic on the wrong side, one for each side."""
    by_address = {instruction.address: i for i, instruction in enumerate(body)}
    states = [set() for _ in body]  # each with the number of states that are held

    def entered(held):
        return INSIDE, min(held + 1, MOST_NESTED)

    def follow(start, state):
        work = [(start, (state, 0))]
        while work:
            i, (state, held) = work.pop()
            if (state, held) in states[i]:
                continue
            states[i].add((state, held))
            mnemonic = body[i].mnemonic
            if "stmxcsr" in mnemonic and begins(body, i):
                state = ENTERING
            elif "stmxcsr" in mnemonic:
                state, held = (INSIDE, held - 1) if held > 1 else (AFTER, 0)
            elif state == ENTERING and "ldmxcsr" in mnemonic:
                state, held = entered(held)
            decided = state == ENTERING and mnemonic.startswith("j")
            work += [(j, entered(held) if decided and not sets(body, j) else (state, held)) for j in successors(body, by_address, i)]

    follow(0, BEFORE)
    for i in range(len(body)):
        if not states[i] and body[i].mnemonic not in ("nop", "nopw", "nopl", "xchg", "int3"):
            follow(i, UNKNOWN)

    wrong = collections.defaultdict(list)
    for i, instruction in enumerate(body):
        if ARITHMETIC.fullmatch(instruction.mnemonic):
            for state in {state for state, _ in states[i]} - ({BEFORE, INSIDE, UNKNOWN} if ANY_ROUNDING.search(name) else {INSIDE, UNKNOWN}):
                wrong[state].append(f"{instruction.mnemonic} at +{instruction.address - body[0].address:#x}")
    return [f"{name}: {state} the state: " + ", ".join(wrong[state][:5]) + (", ..." if len(wrong[state]) > 5 else "")
            for state in wrong]


def examine(libraries):
    """(how many functions store MXCSR, sentences), but for those where CGAL's intervals alone do so, in their own way."""
    checked, found = 0, []
    for library in libraries:
        for name, body in functions(library):
            stores = [i for i, instruction in enumerate(body) if "stmxcsr" in instruction.mnemonic]
            if not is_of_intervals(name, body, stores):
                checked += 1
                found += faults(name, body)
    return checked, found


SAMPLES = """
#include "geometry/detail/floating_point_state.h"
using namespace touchstone;
double good(const double* p, double q) { const FloatingPointState nearest; return pinned(p[0] / p[1] + pinned(q)); }
void good_in_memory(double* p) { const FloatingPointState nearest; if (p[0] < p[1]) p[2] = p[0] * p[1]; }
double bad_before(double* p, double q) {
  const double r = p[0] * q;
  const FloatingPointState nearest;
  p[2] = 0;
  return r;
}
double bad_after(const double* p) {
  double r;
  { const FloatingPointState nearest; r = pinned(p[0] + p[1]); }
  return r * p[2];
}
void bad_entering(double* p) {
  const double r = p[0];
  const unsigned found = _mm_getcsr();
  p[1] = r / p[3];
  __asm__ volatile("" : : : "memory");
  if ((found & ~0x3fU) != 0x1f80U) _mm_setcsr(0x1f80);
  __asm__ volatile("" : : : "memory");
  p[2] = p[1] + 1;
  _mm_setcsr(found);
}
double good_within_another(const double* p) {
  const FloatingPointState outer;
  double r;
  { const FloatingPointState inner; r = pinned(p[0] + p[1]); }
  return pinned(r * p[2]);
}
double bad_after_another(const double* p) {
  double r;
  {
    const FloatingPointState outer;
    { const FloatingPointState inner; r = pinned(p[0] + p[1]); }
    r = pinned(r * p[2]);
  }
  return r * p[3];
}
double good_without_state(const double* p) {
  const double r = p[0] * p[1];
  _MM_SET_ROUNDING_MODE(_MM_ROUND_UP);
  return r + p[2];
}
double bad_rounding_before(double* p, double q) {
  _MM_SET_ROUNDING_MODE(_MM_ROUND_UP);
  const double r = p[0] * q;
  const FloatingPointState nearest;
  p[2] = 0;
  return r;
}
"""


def find_planted(source, compiler, flags):
    """A sentence where samples are not told apart."""
    with tempfile.TemporaryDirectory() as folder:
        sample, compiled = os.path.join(folder, "sample.cpp"), os.path.join(folder, "sample.o")
        with open(sample, "w", encoding="utf-8") as file:
            file.write(SAMPLES)
        subprocess.run([compiler, "-std=c++20", "-O2", *flags, "-I", source, "-c", sample, "-o", compiled], check=True)
        named = {fault.split("(")[0] for fault in examine([compiled])[1]}
    expected = set(re.findall(r"\b(bad_\w+)\(", SAMPLES))
    return None if named == expected else f"planted {sorted(expected)}, found {sorted(named)}"


def main(arguments):
    libraries, _, planted = ("\0".join(arguments)).partition("\0--\0")
    if planted and (complaint := find_planted(*planted.split("\0")[:2], planted.split("\0")[2:])):
        return complaint
    checked, found = examine(libraries.split("\0"))
    if not checked:
        return f"no function of {libraries} sets the state"
    if found:
        return "\n".join(found)
    print(f"{checked} functions, none has arithmetic on the wrong side")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
