# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: packages.py SOURCE BUILD SCRATCH

Makes the Debian packages of BUILD, a build of the preset `packages`. Their shared libraries export what is touchstone's and
nothing else. In a new, minimal Debian, which mmdebstrap makes from this machine's sources, they install, the consumer's
sample builds and runs against them by find_package and by pkg-config, and the program and the module of Python answer. A
build without the program or the module is tested without them.
"""

import pathlib
import re
import shutil
import sys

sys.path.append(str(pathlib.Path(__file__).parents[1]))
from clean_root import run_in_clean_root  # noqa: E402
from running import expect, run  # noqa: E402

SOURCE, BUILD, SCRATCH = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
TOOLS = ["g++", "cmake", "ninja-build", "pkg-config"]
HERE = pathlib.Path(__file__).parent


def make_packages(folder):
    """Returns their names."""
    run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", folder)
    shutil.rmtree(folder / "_CPack_Packages", ignore_errors=True)
    names, files = set(), {}
    for package in sorted(folder.glob("*.deb")):
        fields = dict(line.split(": ", 1) for line in run("dpkg-deb", "-f", package).stdout.splitlines() if ": " in line)
        print(f"{fields['Package']} {fields['Version']} needs {fields['Depends']}")
        contents = [line.split()[5] for line in run("dpkg-deb", "-c", package).stdout.splitlines() if not line.endswith("/")]
        for document in ("CONTRACT.md", "LICENSE-APACHE"):
            expect(any(path.endswith(document) for path in contents), f"{package.name} does not hold {document}")
        for path in contents:
            other = files.setdefault(path, package.name)
            expect(other == package.name, f"{other} and {package.name} hold {path}")
        names.add(fields["Package"])
    return names


def check_exports(package):
    run("dpkg-deb", "-x", package, SCRATCH / "library")
    shared = sorted((SCRATCH / "library/usr/lib").rglob("libtouchstone_*.so.?.?.?"))
    expect(len(shared) == 3, f"expected three shared libraries, found {shared}")
    for library in shared:
        symbols = re.findall(r"[TDBRVWu] (\w+)", run("nm", "-D", "--defined-only", library).stdout)
        expect(len(symbols) > 20, f"{library.name} exports {len(symbols)} symbols")
        foreign = [symbol for symbol in symbols if not re.match(r"_Z\w*?N?K?10touchstone|touchstone_", symbol)]
        expect(not foreign, f"{library.name} exports what is not touchstone's: {foreign[:5]}")
        print(f"{library.name} exports {len(symbols)} symbols, all of touchstone")


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    given = SCRATCH / "input"
    given.mkdir(parents=True)
    names = make_packages(given / "packages")
    library = next(iter((given / "packages").glob("libtouchstone0*.deb")), None)
    expect("libtouchstone-dev" in names and library, f"made are {sorted(names)}")
    check_exports(library)

    readme = (SOURCE / "README.md").read_text()
    (given / "sample.cpp").write_text(re.search(r"```cpp\n(.*?)```", readme, re.DOTALL)[1])
    in_c = re.search(r"```c\n(.*?)```.*?```text\n(.*?)\n", (SOURCE / "bindings/c/README.md").read_text(), re.DOTALL)
    (given / "sample.c").write_text(in_c[1])
    shutil.copytree(SOURCE / "tests/system/consumer", given / "consumer")
    shutil.copy(SOURCE / "tests/corpus/vertex.jsonl", given / "cases.jsonl")
    shutil.copy(HERE / "in_clean_root.sh", given)
    promised = re.search(r"prints `([^`]*)`", readme)[1]
    wanted = {"by find_package": promised, "by pkg-config": promised, "in C": in_c[2]}
    if "touchstone" in names:
        wanted |= {"program": "agrees with the corpus", "data": "found"}
    if "python3-touchstone" in names:
        wanted["module"] = "True"
    answers = dict(line.split(": ", 1) for line in run_in_clean_root(TOOLS, given, "in_clean_root.sh", SCRATCH / "answers").splitlines())
    for what, answer in wanted.items():
        expect(answers.get(what) == answer, f"in a clean root, {what} answers {answers.get(what)}, not {answer}")
        print(f"in a clean root, {what}: {answer}")


if __name__ == "__main__":
    main()
