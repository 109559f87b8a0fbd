# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: installed.py SOURCE BUILD SCRATCH C_COMPILER CXX_COMPILER [FLAG...]

The sample of bindings/c/README.md compiles against an installation of BUILD, and prints what the page says: by the page's
command of pkg-config, and without its rpath where LD_LIBRARY_PATH names the folder, and there alone; by find_package in a
project of C alone, where Eigen, TBB, GMP and MPFR are not found; and with the static library. FLAGs are those of BUILD.
"""

import os
import pathlib
import re
import shlex
import shutil
import sys

sys.path.append(str(pathlib.Path(__file__).parents[2] / "system"))
from running import expect, run  # noqa: E402

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
HIDDEN = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in ("Eigen3", "TBB", "GMP", "MPFR")]


def project(scratch, name, languages, use):
    folder = scratch / name
    folder.mkdir()
    shutil.copy(scratch / "sample.c", folder)
    (folder / "CMakeLists.txt").write_text(f"cmake_minimum_required(VERSION 3.25)\nproject(Reader LANGUAGES {languages})\n"
                                           f"add_executable(sample sample.c)\n{use}\n")
    return folder


def built_by_cmake(scratch, name, languages, use, options):
    folder = project(scratch, name, languages, use)
    run("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={scratch}/prefix", *options)
    run("cmake", "--build", folder / "build")
    return folder / "build" / "sample"


def main():
    source, build, scratch = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    cc, cxx, *flags = sys.argv[4:]
    page = (source / "bindings/c/README.md").read_text()
    sample, promised = re.search(r"```c\n(.*?)```\n\nIt prints\n\n```text\n(.*?)```", page, re.DOTALL).groups()
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    (scratch / "sample.c").write_text(sample)
    for component in "library", "development":
        run("cmake", "--install", build, "--prefix", scratch / "prefix", "--component", component)

    [description] = scratch.glob("prefix/**/touchstone-c.pc")
    script = re.search(r"```sh\n(export PKG_CONFIG_PATH=DIR\n.*?)```", page, re.DOTALL)[1].replace("DIR", str(description.parent))
    script = script.replace("cc -std=c11", shlex.join([cc, "-std=c11", *WARNINGS, *flags]))
    run("bash", "-euc", script, cwd=scratch)
    programs = {"pkg-config": scratch / "sample"}
    run("bash", "-euc", re.sub(r"-Wl,-rpath,\$\(.*?\)", "", script).replace("-o sample", "-o without_rpath"), cwd=scratch)
    environment = dict(os.environ, PKG_CONFIG_PATH=str(description.parent))
    version = run("pkg-config", "--modversion", "touchstone-c", env=environment).stdout.strip()
    library, = scratch.glob(f"prefix/**/libtouchstone_c.so.{version}")
    run(scratch / "without_rpath", expected=127)
    printed = run(scratch / "without_rpath", env=dict(os.environ, LD_LIBRARY_PATH=str(library.parent))).stdout
    expect(printed == promised, f"with LD_LIBRARY_PATH the sample prints {printed!r}; README.md promises {promised!r}")

    compilers = [f"-DCMAKE_C_COMPILER={cc}", f"-DCMAKE_CXX_COMPILER={cxx}", f"-DCMAKE_C_FLAGS={' '.join([*WARNINGS, *flags])}",
                 f"-DCMAKE_CXX_FLAGS={' '.join(flags)}"]
    shared = "find_package(Touchstone {} REQUIRED COMPONENTS c)\ntarget_link_libraries(sample PRIVATE touchstone::c)"
    static = "find_package(Touchstone REQUIRED)\ntarget_link_libraries(sample PRIVATE touchstone::c_static)"
    programs["find_package"] = built_by_cmake(scratch, "shared", "C", shared.format(version),
                                              [word for word in compilers if "CXX" not in word] + HIDDEN)
    programs["the static library"] = built_by_cmake(scratch, "static", "C CXX", static, compilers)
    needs = run("ldd", programs["the static library"]).stdout
    expect("libtouchstone" not in needs, f"the static library needs a shared one: {needs}")
    for name, program in programs.items():
        printed = run(program).stdout
        expect(printed == promised, f"by {name} the sample prints {printed!r}; README.md promises {promised!r}")
        print(f"by {name}: as the page says")


if __name__ == "__main__":
    main()
