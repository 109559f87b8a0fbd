# SPDX-License-Identifier: GPL-3.0-or-later
"""What is compiled for AVX2 defines nothing that code for machines without it could be linked to.

Usage: engines_share_no_code.py LIBRARY
"""

import re
import subprocess
import sys

symbols = subprocess.run(["nm", "--demangle", "--defined-only", sys.argv[1]], capture_output=True, text=True, check=True)
member, compiled, shared = None, [], []
for line in symbols.stdout.splitlines():
    if line.endswith(":"):
        member = line[:-1]
    elif member and member.endswith("_avx2.cpp.o") and line.strip():
        kind, name = line.split(None, 2)[1:]
        if kind in "TWVu":
            compiled.append(name)
            # The pointer to the personality routine is data. nm leaves the longest names mangled.
            if not re.search(r"::avx2::|^_ZZ?N\w*4avx2|::avx2_(kernels|walks)\(\)$|^DW\.ref\.", name):
                shared.append(name)
if not compiled:
    sys.exit("nothing is compiled for AVX2 in " + sys.argv[1])
if shared:
    sys.exit("compiled for AVX2, but visible to all:\n" + "\n".join(shared))
print(f"{len(compiled)} symbols, none shared")
