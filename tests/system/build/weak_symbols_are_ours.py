# SPDX-License-Identifier: GPL-3.0-or-later
"""No weak symbol of the libraries is one of another library's headers: a program with another version of those would
get one of the two at random.

Usage: weak_symbols_are_ours.py LIBRARY...
"""

import re
import subprocess
import sys

# As mangled, since a demangled template begins with what it returns. What tables, guards and functions belong to.
OWN = re.compile(r"_Z(T[VTISC]|GV|GR|Th[n\d]*_|Tv[n\d_]*_)?Z*(N[KVRO]*)?"
                 r"(10touchstone|S[tabsiod](?!.*(4CGAL|5boost|5Eigen|3tbb|10__gmp_expr)))")


def weak_symbols(library):
    symbols = subprocess.run(["nm", "--defined-only", "--format=posix", library],
                             capture_output=True, text=True, check=True)
    return [line.split()[0] for line in symbols.stdout.splitlines() if re.search(r" [WVu] ", line)]


def main(libraries):
    weak = {symbol for library in libraries for symbol in weak_symbols(library)}
    foreign = sorted(symbol for symbol in weak if not OWN.match(symbol))
    if not weak:
        return "no weak symbol at all in " + " ".join(libraries)
    if foreign:
        names = subprocess.run(["c++filt"], input="\n".join(foreign), capture_output=True, text=True, check=True).stdout
        return f"weak symbols of others, {len(foreign)} of {len(weak)}:\n{names}"
    print(f"{len(weak)} weak symbols, all touchstone's or the standard library's")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
