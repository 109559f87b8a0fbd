# SPDX-License-Identifier: GPL-3.0-or-later
"""What x86-64 object code computes in lanes, read from its disassembly by objdump.

Every path of a function is executed over symbols: a lane holds a node of a graph of operations, like
those that robust/proofs records. Inputs are what is loaded through pointers. What an instruction writes that is not known
here is unknown, and what is computed from it equals nothing that is recorded. It is assumed that no store elsewhere than
to the stack changes an input or the stack.
"""

import collections
import re
import subprocess

COMMUTE = ("+", "*", "maximum", "minimum", "both", "either")
ROUNDED = {"add": "+", "sub": "-", "mul": "*", "div": "/", "max": "maximum", "min": "minimum", "fmadd": "fused +",
           "fmsub": "fused -", "fnmadd": "fused, negated +", "fnmsub": "fused, negated -"}
BITS = {"and": "both", "or": "either", "xor": "one of", "andn": "not the first, both"}
COMPARISON = re.compile(r"v?(u?comis|p?test|cmp\w*)[ps]?[sd]$")
WITHOUT_RESULT = re.compile(r"(cmp|test)[bwlq]?$|v?u?comis|nop|prefetch|vzero|v?ldmxcsr|cs$|data16")
FOLLOWED = re.compile("::(signs|lane)::[a-z]")
IMPLIED = re.compile(r"i?mul[lq]?$|i?div[lq]?$|cqto|cltd|cltq|cwtl|rep")  # registers that are not named
GENERAL = {name: full for full, names in {
    **{f"r{x}x": (f"r{x}x", f"e{x}x", f"{x}x", f"{x}l", f"{x}h") for x in "abcd"},
    **{f"r{x}": (f"r{x}", f"e{x}", x, f"{x}l") for x in ("si", "di", "bp", "sp")},
    **{f"r{x}": (f"r{x}", f"r{x}d", f"r{x}w", f"r{x}b") for x in range(8, 16)}}.items() for name in names}

Instruction = collections.namedtuple("Instruction", "at after name operands relocation")
Pointer = collections.namedtuple("Pointer", "base offset")


class Nodes:
    """Operations, each once: those of records and of object code alike. Operands that commute are sorted."""

    def __init__(self):
        self.numbers, self.all = {}, []

    def add(self, operation, *of):
        commuting = 2 if operation in ("fused +", "fused -") else len(of) if operation in COMMUTE else 0
        node = (operation, *sorted(of[:commuting]), *of[commuting:])
        if node not in self.numbers:
            self.numbers[node] = len(self.all)
            self.all.append(node)
        return self.numbers[node]

    def leaves(self, roots):
        """The nodes of which these are logical combinations."""
        found, todo = set(), list(roots)
        while todo:
            operation, *of = self.all[node := todo.pop()]
            if operation in ("both", "either"):
                todo += of
            else:
                found.add(node)
        return found

    def text(self, node, depth=3):
        operation, *of = self.all[node]
        if operation in ("input", "constant", "unknown"):
            return f"{operation} {of}"
        return f"({operation}: {', '.join(self.text(one, depth - 1) for one in of) if depth else '...'})"


class ObjectFile:
    """The functions of an object file, by name: their disassembly, or their instructions by address. And its constants."""

    def __init__(self, objdump, path):
        def lines(*options):
            return subprocess.run([objdump, *options, path], check=True, capture_output=True, text=True).stdout.splitlines()
        self.functions, self.starts, self.sections, self.symbols = {}, {}, {}, {}
        for line in lines("-drC", "--no-show-raw-insn"):
            if line.startswith("Disassembly of section "):
                section = line[23:-1]
            elif line.startswith("0"):
                name = line[line.index("<") + 1:-2]
                text = self.functions[name] = []
                self.starts[section, int(line[:16], 16)] = name
            elif line.startswith((" ", "\t")):
                text.append(line)
        for line in lines("-s"):
            if line.startswith("Contents of section "):
                content = self.sections[line[20:-1]] = bytearray()
            elif line.startswith(" ") and len(self.sections) and ".rodata" in next(reversed(self.sections)):
                content += bytes.fromhex(line[line.index(" ", 1):][:37])
        for line in lines("-t"):
            if found := re.match(r"([0-9a-f]{16}) .{7} (\S+)\t[0-9a-f]+ (\.L\w+)$", line):
                self.symbols[found[3]] = found[2], int(found[1], 16)

    def code(self, function):
        if isinstance(self.functions[function], list):
            code = {}
            for line in self.functions[function]:
                if found := re.match(r"\s+([0-9a-f]+):\s+R_\w+\s+(.*?)([-+]0x[0-9a-f]+)?$", line):
                    code[last] = code[last]._replace(relocation=(int(found[1], 16), found[2], int(found[3] or "0", 16)))
                elif found := re.match(r"\s+([0-9a-f]+):\s+(\S+)\s*([^#<]*)", line):
                    at, operands = int(found[1], 16), re.findall(r"(?:[^,()\s]|\([^)]*\))+", found[3])
                    if code:
                        code[last] = code[last]._replace(after=at)
                    code[at], last = Instruction(at, None, found[2], operands, None), at
            self.functions[function] = code
        return self.functions[function]

    def called(self, of):
        """The name of the function that a call with a relocation calls. A local one is named by its place in its section."""
        at, symbol, addend = of.relocation
        return self.starts.get((symbol, addend + of.after - at), symbol)

    def bits(self, symbol, offset, width):
        section, start = self.symbols[symbol]
        return int.from_bytes(self.sections[section][start + offset:][:width], "little")


def is_vector(operand):
    return re.match(r"%[xy]mm", operand) is not None


def is_whole(operand):
    """Whether it is a general register of 64 bits."""
    return GENERAL.get(operand[1:]) == operand[1:]


class Machine:
    """The registers and the stack of one path. A lane is `width` bytes wide: 8 for doubles, 4 for floats."""

    def __init__(self, nodes, file, width):
        self.nodes, self.file, self.width, self.kind, self.half = nodes, file, width, "sd"[width // 8], 16 // width
        self.general = {name: Pointer(name, 0) for name in ("rsp", "rdi", "rsi", "rdx", "rcx", "r8", "r9")}
        self.vectors, self.stack, self.unknown = {}, {}, nodes.add("unknown")

    def copy(self):
        other = Machine(self.nodes, self.file, self.width)
        other.general, other.vectors, other.stack = dict(self.general), dict(self.vectors), dict(self.stack)
        return other

    def state(self):
        return tuple(frozenset(part.items()) for part in (self.general, self.vectors, self.stack))

    def address(self, operand, of):
        """Where an operand in memory is, if that is known."""
        found = re.fullmatch(r"(-?0x[0-9a-f]+)?\(%(\w+)\)", operand)
        if found and found[2] == "rip" and of.relocation:
            at, symbol, addend = of.relocation
            return Pointer(symbol, addend + of.after - at)
        pointer = found and self.general.get(found[2])
        if isinstance(pointer, int):
            pointer = Pointer(pointer, 0) if self.nodes.all[pointer][0] == "input" else None
        return pointer and Pointer(pointer.base, pointer.offset + int(found[1] or "0", 16))

    def in_memory(self, pointer, of, lane=0):
        if not pointer:
            return self.nodes.add("unknown", of.at, lane)
        here = Pointer(pointer.base, pointer.offset + lane * self.width)
        if here in self.stack:
            return self.stack[here]
        if here.base in self.file.symbols:
            return self.nodes.add("constant", self.file.bits(*here, self.width))
        return self.nodes.add("input", *here)

    def count(self, operand):
        return self.half * (2 if operand.startswith("%ymm") else 1)

    def read(self, operand, of, count):
        """The lanes of a register or of memory."""
        if is_vector(operand):
            return self.vectors.get(operand[4:], [self.nodes.add("unknown", operand)] * 2 * self.half)[:count]
        if operand.startswith("%"):
            lanes = [self.general.get(GENERAL[operand[1:]])]
        else:
            pointer = self.address(operand, of)
            lanes = [self.in_memory(pointer, of, lane) for lane in range(count)]
        return [lane if isinstance(lane, int) else self.nodes.add("unknown", of.at, i) for i, lane in enumerate(lanes)]

    def write(self, operand, lanes, of):
        if is_vector(operand):
            self.vectors[operand[4:]] = (*lanes, *[self.nodes.add("constant", 0)] * (2 * self.half - len(lanes)))
        elif operand.startswith("%"):
            self.general[GENERAL[operand[1:]]] = lanes[0]
        elif (pointer := self.address(operand, of)) and pointer.base == "rsp":
            for lane, value in enumerate(lanes):
                self.stack[Pointer(pointer.base, pointer.offset + lane * self.width)] = value

    def bit_operation(self, name, a, b):
        if name == "andn" and self.nodes.all[a] == ("constant", 1 << self.width * 8 - 1):
            return self.nodes.add("magnitude", b)
        return self.nodes.add("constant", 0) if name == "xor" and a == b else self.nodes.add(BITS[name], a, b)

    def vector(self, of):
        """The lanes that an instruction on vectors writes, or None if it is not known here."""
        name, operands, target = of.name.removeprefix("v"), of.operands, of.operands[-1]
        count, immediate = self.count(target), 0
        if operands[0].startswith("$"):
            immediate, operands = int(operands[0][1:], 16), operands[1:]
        a = self.read(operands[-2] if len(operands) > 2 else target, of, count)
        def b(lanes=count):
            return self.read(operands[0], of, lanes)
        if found := re.fullmatch(r"(add|sub|mul|div|max|min|fn?m(?:add|sub))(132|213|231)?([ps])([ds])", name):
            if found[4] != self.kind:
                return None
            lanes = range(count if found[3] == "p" else 1)
            of_number = {"1": self.read(target, of, count), "2": a, "3": b(len(lanes))}
            order, kept = (found[2], of_number["1"]) if found[2] else ("23", a)
            done = [self.nodes.add(ROUNDED[found[1]], *(of_number[i][lane] for i in order)) for lane in lanes]
            return done if found[3] == "p" else [*done, *kept[1:self.half]]
        if name == f"sqrtp{self.kind}":
            return [self.nodes.add("root", lane) for lane in b()]
        if found := re.fullmatch(r"p?(andn|and|or|xor)(p[ds])?", name):
            return [self.bit_operation(found[1], x, y) for x, y in zip(a, b())]
        if re.fullmatch(r"mov([au]p[ds]|dq[au])", name):
            return b(count if is_vector(target) else self.count(operands[0]))
        if name == f"broadcasts{self.kind}" or name == "movddup" and self.width == 8:
            return list(b(1)) * count
        if name in (f"movs{self.kind}", "movq" if self.width == 8 else "movd"):
            if not is_vector(target):
                return b(1)
            zeros = [self.nodes.add("constant", 0)] * (self.half - 1)
            return [*b(1), *(a[1:self.half] if name[3] == "s" and is_vector(operands[0]) else zeros)]
        if name == "shufps" and self.width == 4:
            pick = [immediate >> 2 * i & 3 for i in range(4)]
            return [(a if i < 2 else b())[at + pick[i]] for at in range(0, count, 4) for i in range(4)]
        return self.shuffled(name, a, b, count, immediate, operands) if self.width == 8 else None

    def shuffled(self, name, a, b, count, immediate, operands):
        """The same of doubles that an instruction moves between lanes."""
        if name in ("movhpd", "movhps", "movlpd", "movlps") and is_vector(operands[-1]):
            return [a[0], *b(1)] if name[3] == "h" else [*b(1), a[1]]
        if name in ("movhpd", "movhps"):
            return b(2)[1:]
        if found := re.fullmatch(r"(?:p)?unpck([lh])(pd|qdq)", name):
            return [lanes[at + (found[1] == "h")] for at in range(0, count, 2) for lanes in (a, b())]
        if name == "shufpd":
            return [lanes[at + (immediate >> at + i & 1)] for at in range(0, count, 2) for i, lanes in enumerate((a, b()))]
        if name == "permpd":
            return [b()[immediate >> 2 * i & 3] for i in range(4)]
        if name == "permilpd":
            return [b()[i - i % 2 + (immediate >> i & 1)] for i in range(count)]
        if name == "insertf128":
            return [*a[:2], *b(2)] if immediate else [*b(2), *a[2:]]
        if name == "maskmovpd" and all(self.nodes.all[lane][0] == "constant" for lane in a):
            return [value if self.nodes.all[mask][1] >> 63 else self.nodes.add("constant", 0) for mask, value in zip(a, b())]
        if name == "extractf128":
            return b(4)[2 * immediate:][:2]
        if name == "perm2f128":
            halves = [a[:2], a[2:], b()[:2], b()[2:]]
            return [*halves[immediate & 3], *halves[immediate >> 4 & 3]]
        return None

    def value(self, operand, of):
        """The pointer or node that a general register or eight bytes of memory hold."""
        if is_whole(operand):
            return self.general.get(operand[1:], self.unknown)
        pointer = self.address(operand, of) if "(" in operand else None
        return self.in_memory(pointer, of) if pointer else self.unknown

    def general_result(self, of):
        """What an instruction writes into a general register or memory."""
        name, operands = of.name, of.operands
        if name == "mov" and any(map(is_whole, operands)):
            return self.value(operands[0], of)
        if name == "lea" and is_whole(operands[-1]):
            pointer = self.address(operands[0], of)
            return pointer if pointer and isinstance(pointer.base, str) else self.unknown
        if operands[-1] == "%rsp" and name in ("add", "sub", "and"):
            (base, offset), number = self.general["rsp"], int(operands[0][1:], 16)
            return Pointer(base, {"add": offset + number, "sub": offset - number, "and": offset & number}[name])
        return self.unknown

    def step(self, of):
        """Executes an instruction that neither jumps nor calls."""
        name, operands, stack = of.name, of.operands, self.general["rsp"]
        if name == "push":
            self.general["rsp"] = below = Pointer(stack.base, stack.offset - 8)
            self.stack[below] = self.value(operands[0], of)
        elif name in ("pop", "leave"):
            stack, target = (stack, operands[0][1:]) if name == "pop" else (self.general["rbp"], "rbp")
            self.general[target], self.general["rsp"] = self.in_memory(stack, of), Pointer(stack.base, stack.offset + 8)
        elif name == "xchg" and all(map(is_whole, operands)):
            first, second = operands
            self.general.update({first[1:]: self.value(second, of), second[1:]: self.value(first, of)})
        elif name == "xchg" or IMPLIED.match(name) and len(operands) < 2 or name == "rep":
            for register in ("rax", "rdx", "rcx", "rsi", "rdi", *(GENERAL.get(operand[1:]) for operand in operands)):
                self.general.pop(register, None)
        elif WITHOUT_RESULT.match(name) or not operands:
            pass
        elif any(map(is_vector, operands)):
            unknown = [self.nodes.add("unknown", of.at, lane) for lane in range(self.count(operands[-1]))]
            self.write(operands[-1], self.vector(of) or unknown, of)
        else:
            self.write(operands[-1], [self.general_result(of)], of)


def decisions(nodes, file, function, width):
    """The nodes on whose signs, or on whose comparison, a path of the function depends. Calls of functions of namespaces
    `signs` and `lane` are followed; a path ends where it leaves the function otherwise."""
    found, seen, todo = set(), set(), [(file.code(function), min(file.code(function)), (), Machine(nodes, file, width))]
    while todo:
        code, at, callers, machine = todo.pop()
        while True:
            of = code[at]
            at = of.after
            if re.fullmatch(f"v?movmskp{machine.kind}", of.name):
                found.update(machine.read(of.operands[0], of, machine.count(of.operands[0])))
            elif COMPARISON.match(of.name) and of.name[-1] == machine.kind and any(map(is_vector, of.operands)):
                found.add(nodes.add("comparison", *(machine.read(operand, of, 1)[0] for operand in of.operands[-2:])))
            if of.name == "ret" and callers:
                (code, at), *callers = callers
            elif of.name == "call" and of.relocation and FOLLOWED.search(file.called(of).split("(")[0]):
                callers, code = ((code, at), *callers), file.code(file.called(of))
                at = min(code)
            elif of.name in ("ret", "call"):
                break
            elif of.name.startswith("j"):
                target = None if of.relocation or of.operands[0].startswith("*") else int(of.operands[0], 16)
                key = (id(code), target, tuple(after for _, after in callers), machine.state())
                if key not in seen and target is not None:
                    seen.add(key)
                    todo.append((code, target, tuple(callers), machine.copy()))
                if of.name == "jmp":
                    break
            else:
                machine.step(of)
    return found
