# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: exported_symbols.py LIBRARY HEADER CALLER VERSION

The shared library LIBRARY exports exactly the functions that HEADER declares, each under the version of the interface, and
its name is that of the interface. CALLER, a program in C, calls each of them. VERSION is the project's, as 0.3.0.
"""

import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).parents[2] / "system"))
from running import expect, run  # noqa: E402


def main(library, header, caller, version):
    interface = version.rpartition(".")[0]
    declared = set(re.findall(r"^\w[\w ]*[ *](touchstone_\w+)\(", pathlib.Path(header).read_text(), re.MULTILINE))
    expect(len(declared) > 20, f"the header declares {len(declared)} functions")
    symbols = [line.split()[-1] for line in run("nm", "-D", "--defined-only", library).stdout.splitlines()]
    node = f"TOUCHSTONE_{interface}"
    wanted = {f"{name}@@{node}" for name in declared}
    exported = {symbol for symbol in symbols if symbol not in (node, f"{node}@@{node}")}
    expect(exported == wanted, f"not exported: {sorted(wanted - exported)}; not declared: {sorted(exported - wanted)}")
    name = re.search(r"SONAME\S*\s.*\[(.*)\]", run("readelf", "-d", library).stdout)[1]
    expect(name == f"libtouchstone_c.so.{interface}", f"the library is called {name}")
    called = set(re.findall(r"\b(touchstone_\w+)\(", pathlib.Path(caller).read_text()))
    expect(declared <= called, f"no call of {sorted(declared - called)}")
    print(f"{len(declared)} functions, all of {node}, in {name}")


if __name__ == "__main__":
    main(*sys.argv[1:])
