# SPDX-License-Identifier: GPL-3.0-or-later
"""The engines that are compiled for AVX2 define nothing that code for lesser machines could be linked to.

Usage: engines_share_no_code.py LIBRARY
"""

import subprocess
import sys

symbols = subprocess.run(["nm", "--demangle", "--defined-only", sys.argv[1]], capture_output=True, text=True, check=True)
member, engine, shared = None, [], []
for line in symbols.stdout.splitlines():
    if line.endswith(":"):
        member = line[:-1]
    elif member and member.endswith("_avx2.cpp.o") and line.strip():
        kind, name = line.split(None, 2)[1:]
        if kind in "TWVu":
            engine.append(name)
            # The pointer to the personality routine is data.
            if "::avx2::" not in name and not name.endswith("::avx2_engine()") and not name.startswith("DW.ref."):
                shared.append(name)
if not engine:
    sys.exit("no AVX2 engine in " + sys.argv[1])
if shared:
    sys.exit("compiled for AVX2, but visible to all:\n" + "\n".join(shared))
print(f"{len(engine)} symbols, none shared")
