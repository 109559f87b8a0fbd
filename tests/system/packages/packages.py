# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: packages.py SOURCE BUILD SCRATCH

Makes the Debian packages of BUILD, a build of the preset `packages`, and uses what they hold: its shared libraries export
what is touchstone's and nothing else, the consumer's sample builds and runs against them by find_package and by pkg-config,
the program and the module of Python answer. A build without the program or the module is tested without them.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

SOURCE, BUILD, SCRATCH = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
ROOT = SCRATCH / "root"
ASKS_PYTHON = "import touchstone; print(touchstone.filtered.contact([0.5, 0.25, 1, 1], touchstone.Polygon(" \
              "[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])))"


def run(*command, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def expect(holds, message):
    if not holds:
        sys.exit(message)


def unpack():
    """Makes the packages and unpacks them under ROOT. Returns their names."""
    run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", SCRATCH / "packages")
    names = set()
    for package in sorted((SCRATCH / "packages").glob("*.deb")):
        run("dpkg-deb", "-x", package, ROOT)
        fields = dict(line.split(": ", 1) for line in run("dpkg-deb", "-f", package).splitlines() if ": " in line)
        print(f"{fields['Package']} {fields['Version']} needs {fields['Depends']}")
        names.add(fields["Package"])
    return names


def check_exports():
    shared = sorted((ROOT / "usr/lib").rglob("libtouchstone_*.so.?.?.?"))
    expect(len(shared) == 2, f"expected two shared libraries, found {shared}")
    for library in shared:
        symbols = re.findall(r"[TDBRVWu] (\w+)", run("nm", "-D", "--defined-only", library))
        expect(len(symbols) > 20, f"{library.name} exports {len(symbols)} symbols")
        foreign = [symbol for symbol in symbols if not re.match(r"_Z\w*?N?K?10touchstone", symbol)]
        expect(not foreign, f"{library.name} exports what is not touchstone's: {foreign[:5]}")
        print(f"{library.name} exports {len(symbols)} symbols, all of touchstone")


def check_consumer(environment):
    """Builds the README's sample by find_package and by pkg-config."""
    readme = (SOURCE / "README.md").read_text()
    (SCRATCH / "sample.cpp").write_text(re.search(r"```cpp\n(.*?)```", readme, re.DOTALL)[1])
    (SCRATCH / "whole.cpp").write_text("#include <touchstone/touchstone.h>\n" + (SCRATCH / "sample.cpp").read_text())
    promised = re.search(r"prints `([^`]*)`", readme)[1]
    run("cmake", "-S", SOURCE / "tests/system/consumer", "-B", SCRATCH / "consumer", "-G", "Ninja", f"-DSAMPLE={SCRATCH}/sample.cpp",
        f"-DCMAKE_PREFIX_PATH={ROOT}/usr")
    run("cmake", "--build", SCRATCH / "consumer")
    found = run(SCRATCH / "consumer/sample", env=environment).strip()
    expect(found == promised, f"by find_package the sample prints {found}, not {promised}")
    pkg_config = next(ROOT.rglob("touchstone.pc")).parent
    flags = run("pkg-config", "--cflags", "--libs", "touchstone", env={**environment, "PKG_CONFIG_PATH": str(pkg_config)}).split()
    run("c++", "-std=c++20", "-O1", SCRATCH / "whole.cpp", *flags, "-o", SCRATCH / "by_pkg_config")
    found = run(SCRATCH / "by_pkg_config", env=environment).strip()
    expect(found == promised, f"by pkg-config the sample prints {found}, not {promised}")
    print("the sample builds and runs by find_package and by pkg-config")


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    names = unpack()
    expect({"libtouchstone-dev", "libtouchstone0.2"} <= names, f"made are {sorted(names)}")
    libraries = next(ROOT.rglob("libtouchstone_robust.so.*")).parent
    environment = {**os.environ, "LD_LIBRARY_PATH": str(libraries)}
    check_exports()
    check_consumer(environment)
    for document in ("CONTRACT.md", "LICENSE-APACHE"):
        expect(list((ROOT / "usr/share/doc").rglob(document)), f"no package holds {document}")
    if "touchstone" in names:
        expect("usage" in run(ROOT / "usr/bin/touchstone", "--help", env=environment).lower(), "the program has no help")
        print("the program runs")
    if "python3-touchstone" in names:
        modules = {**environment, "PYTHONPATH": f"{ROOT}/usr/lib/python3/dist-packages"}
        expect(run("/usr/bin/python3", "-c", ASKS_PYTHON, env=modules).strip() == "True", "the module gives a wrong answer")
        print("the module of Python answers")


if __name__ == "__main__":
    main()
