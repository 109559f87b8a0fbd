# SPDX-License-Identifier: GPL-3.0-or-later
"""The library of the preset library-minimal needs Boost and Eigen alone, and answers the same.

Usage: without_exact.py SOURCE SCRATCH COMPILER BUILD

Configures where CMake may not find CGAL, GMP, MPFR and TBB, and builds: no compiled file includes a header of theirs, and
no object needs a symbol of theirs. tests/system/matrix/answers.cpp prints the same hash of 2,000 questions as with the
libraries of the full build in the folder BUILD. Then the consumer of tests/system/consumer uses the installed package.
What cannot be built without them is refused with a sentence.
"""

import os
import pathlib
import re
import shutil
import sys

sys.path.append(str(pathlib.Path(__file__).parents[1]))
from running import expect, run  # noqa: E402

FORBIDDEN = ["CGAL", "GMP", "MPFR", "TBB"]
HEADERS = re.compile(r"/CGAL/|/(gmp|gmpxx|mpfr)[^/]*\.h$|/tbb/|/oneapi/")
SYMBOLS = re.compile(r"__gmp|mpfr_|CGAL|\btbb::")


def configuration(source, folder, compiler, *options):
    return ["cmake", "--preset", "library-minimal", "-S", source, "-B", folder, f"-DCMAKE_CXX_COMPILER={compiler}",
            *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in FORBIDDEN), *options]


def answers(source, scratch, compiler, name, *libraries):
    program = scratch / f"answers_{name}"
    run(compiler, "-std=c++20", "-O1", "-ffp-contract=off", "-I", source, "-isystem", "/usr/include/eigen3",
        source / "tests/system/matrix/answers.cpp", *libraries, "-lpthread", "-o", program)
    return run(program).stdout


def main():
    source, scratch = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    compiler, full = sys.argv[3], [f"{sys.argv[4]}/{name}/libtouchstone_{name}.a" for name in ("robust", "geometry")]
    build = scratch / "build"
    shutil.rmtree(scratch, ignore_errors=True)
    run(*configuration(source, build, compiler))
    run("cmake", "--build", build, "-j", os.cpu_count())

    headers = {line.strip() for line in run("ninja", "-C", build, "-t", "deps").stdout.splitlines()}
    included = sorted(header for header in headers if HEADERS.search(header))
    expect(not included, f"the library includes {included[:1]}")
    expect(any("/boost/multiprecision/" in header for header in headers), "no file includes Boost.Multiprecision, so the headers were not read")
    libraries = [build / "robust/libtouchstone_robust.a", build / "geometry/libtouchstone_geometry.a"]
    needed = [line for line in run("nm", "-C", *libraries, build / "bindings/c/libtouchstone_c.a").stdout.splitlines() if SYMBOLS.search(line)]
    expect(not needed, f"the library has the symbols {needed[:1]}")

    alone, both = (answers(source, scratch, compiler, "alone", *libraries),
                   answers(source, scratch, compiler, "full", *full, "-ltbb", "-lmpfr", "-lgmp"))
    print("without exact:", alone, "with it:      ", both, sep="\n")
    expect(alone == both, "the answers differ")

    run("cmake", f"-DBUILD={build}", f"-DSOURCE={source}", f"-DSCRATCH={scratch}/consumer", f"-DCOMPILER={compiler}",
        "-DFLAGS=", f"-DFORBIDDEN={';'.join(FORBIDDEN)}", "-P",
        source / "tests/system/consumer/run.cmake")
    flags = next((scratch / "consumer/prefix").rglob("touchstone.pc")).read_text()
    expect(not re.search(r"-l(gmp|mpfr|tbb)", flags), f"touchstone.pc says\n{flags}")

    for part in ("EXPERIMENTS", "TESTS"):
        refused = run(*configuration(source, scratch / part, compiler, f"-DTOUCHSTONE_{part}=ON"), expected=1)
        expect(f"TOUCHSTONE_{part}=ON needs TOUCHSTONE_EXACT=ON" in refused.stderr, f"TOUCHSTONE_{part}=ON is refused otherwise: {refused.stderr}")


main()
