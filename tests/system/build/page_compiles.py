# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: python3 page_compiles.py PAGE COMPILER FLAG...

What stands in a page as a file of C++ compiles. A file engines/NAME.cpp defines the function that CMake calls for NAME.
"""

import re
import subprocess
import sys


def main(page, compiler, *flags):
    with open(page) as text:
        content = text.read()
    blocks = re.findall(r"```cpp\n(.*?)```", content, re.DOTALL)
    engines = re.findall(r"engines/(\w+)\.cpp`:\n\n```cpp\n(.*?)```", content, re.DOTALL)
    failed = sum(subprocess.run([compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", *flags,
                                 "-x", "c++", "-"], input=block, text=True).returncode != 0 for block in blocks)
    failed += sum(f"\nvoid add_{name}(MethodList& list) {{" not in block for name, block in engines)
    print(f"{len(blocks)} blocks, {failed} fail")
    return 1 if failed or not blocks or not engines else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
