# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: wheel.py SOURCE SCRATCH

Makes an sdist of SOURCE. In a new, minimal Debian pip builds a wheel of it, after the packages are installed that the
build names when it refuses: those of the module's page and no others. The wheel needs no library but glibc, exports
nothing but the module, and its tag names the newest glibc whose symbols it needs. In another new Debian, without compiler
and headers, pip installs the wheel, and the module passes its tests there on the corpus, with the cases in floats, in 60 s.
"""

import pathlib
import re
import shutil
import sys
import zipfile

sys.path.append(str(pathlib.Path(__file__).parents[1]))
from clean_root import run_in_clean_root  # noqa: E402
from running import expect, run  # noqa: E402

SOURCE, SCRATCH = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
HERE = pathlib.Path(__file__).parent
PAGE = pathlib.Path("bindings/python/README.md")
TESTS = pathlib.Path("tests/bindings/python/test_touchstone.py")


def build_in_clean_root(sdist):
    """Returns the wheel."""
    given = SCRATCH / "build"
    given.mkdir()
    for file in (sdist, HERE / "build_wheel.sh"):
        shutil.copy(file, given)
    named = run_in_clean_root(["python3-venv"], given, "build_wheel.sh", SCRATCH / "named", made=SCRATCH).split()
    listed = re.search(r"apt-get install (.*)", (SOURCE / PAGE).read_text())[1].split()
    expect(sorted(named) == sorted(listed), f"the build asks for {named}, {PAGE} names {listed}")
    print("in a clean root, pip builds the wheel after", *named)
    wheel, = (SCRATCH / "made").glob("*.whl")
    return wheel


def check_needs_glibc_alone(wheel):
    zipfile.ZipFile(wheel).extractall(SCRATCH / "unpacked")
    module, = (SCRATCH / "unpacked/touchstone_contact").glob("*.so")
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", run("readelf", "--dynamic", "--wide", module).stdout)
    others = [name for name in needed if not re.match(r"(libc|libm|ld-linux-.*)\.so\.", name)]
    expect(needed and not others, f"{module.name} needs {others}")
    exported = re.findall(r" [A-Za-z] (.*)", run("nm", "-D", "--defined-only", module).stdout)
    expect(exported == ["PyInit__touchstone"], f"{module.name} exports {exported[:5]}")
    newest = max((int(major), int(minor)) for major, minor in re.findall(r"\bGLIBC_(\d+)\.(\d+)", run("objdump", "-T", module).stdout))
    expect("-manylinux_{}_{}_".format(*newest) in wheel.name, f"{module.name} needs glibc {newest}, its wheel is {wheel.name}")
    expect(wheel.name in (SOURCE / PAGE).read_text(), f"{PAGE} does not name {wheel.name}")
    print(f"{wheel.name}, {wheel.stat().st_size} bytes, needs {' '.join(needed)}")


def use_in_clean_root(wheel):
    given = SCRATCH / "use"
    (given / "tests/corpus").mkdir(parents=True)
    for file in (PAGE, TESTS):
        (given / file.parent).mkdir(parents=True)
        shutil.copy(SOURCE / file, given / file)
    corpus = SOURCE / "tests/corpus"
    for file in (*corpus.glob("*.jsonl"), *corpus.glob("floats/*.jsonl")):
        shutil.copy(file, given / "tests/corpus" / "-".join(file.relative_to(corpus).parts))
    for file in (wheel, HERE / "use_wheel.sh"):
        shutil.copy(file, given)
    print(run_in_clean_root(["python3-venv", "python3-numpy"], given, "use_wheel.sh", SCRATCH / "answers"), end="")


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    run(sys.executable, "-m", "build", "--sdist", "--no-isolation", "--outdir", SCRATCH, SOURCE)
    sdist, = SCRATCH.glob("*.tar.gz")
    wheel = build_in_clean_root(sdist)
    check_needs_glibc_alone(wheel)
    use_in_clean_root(wheel)


if __name__ == "__main__":
    main()
