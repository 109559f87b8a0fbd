# SPDX-License-Identifier: Apache-2.0
"""What pip and `python -m build` call to make a wheel or an sdist (PEP 517): CMake compiles the libraries and the module.

No backend of Debian 12 drives CMake. This one needs only Python's own library, so that `pip install .` works without a
network. The wheel needs nothing of the machine that it runs on. `--config-settings NAME=VALUE` changes that:

  system-libraries=yes    CGAL, GMP, MPFR and TBB of this machine: batches of scenes run on all cores
  build-dir=FOLDER        keep the compiled files for the next time
  compiled=FOLDER         take a package that is compiled already, such as build/release/python/touchstone_contact
"""

import base64
import csv
import hashlib
import io
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# What of the repository the module is built of: of the corpus, no cases that are under the GPL.
SOURCES = ("CMakeLists.txt", "LICENSE", "LICENSE-APACHE", "pyproject.toml", "bindings/python", "cmake", "geometry", "robust",
           "tests/corpus/floats", ":!tests/corpus/floats/real-meshes.jsonl")
# What CMake says if it does not find something, what that is, and the package of Debian that has it.
NOT_FOUND = '(Could NOT find|provided by) "?'
NEEDS = (("No CMAKE_CXX_COMPILER could be found", "g++ 12 or clang++ 14", "g++"),
         ("unable to find a build program", "Ninja or Make", "ninja-build"),
         (f"{NOT_FOUND}Eigen3", "the headers of Eigen 3.4", "libeigen3-dev"),
         (f"{NOT_FOUND}Boost", "the headers of Boost 1.74", "libboost-dev"),
         (f"{NOT_FOUND}Python", "the headers of Python", "python3-dev"),
         (f"{NOT_FOUND}pybind11", "pybind11 2.10", "pybind11-dev"),
         (f"{NOT_FOUND}CGAL", "CGAL", "libcgal-dev"),
         (f"{NOT_FOUND}GMP", "GMP", "libgmp-dev"),
         (f"{NOT_FOUND}MPFR", "MPFR", "libmpfr-dev"),
         (f"{NOT_FOUND}TBB", "TBB", "libtbb-dev"))


def project():
    """Returns the table `project` of pyproject.toml, with the version of CMakeLists.txt."""
    table = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    version = re.search(r"project\(Touchstone VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())
    return {**table, "version": version[1]}


def stem_of(table):
    return f"{table['name'].replace('-', '_')}-{table['version']}"


def needs(module):
    """pybind11 before 2.12, which Debian 12 has, does not know the arrays of NumPy 2, whose core has another name."""
    return "numpy" if b"numpy._core" in module.read_bytes() else "numpy<2"


def metadata(table, need=None):
    fields = [("Metadata-Version", "2.4"), ("Name", table["name"]), ("Version", table["version"]), ("Summary", table["description"]),
              *(("Author", author["name"]) for author in table["authors"]), ("Keywords", ",".join(table["keywords"])),
              ("License-Expression", table["license"]), *(("License-File", file) for file in table["license-files"]),
              *(("Classifier", line) for line in table["classifiers"]),
              ("Requires-Python", table["requires-python"]), ("Requires-Dist", need) if need else ("Dynamic", "Requires-Dist"),
              ("Description-Content-Type", "text/markdown")]
    # There are no other pages of ours beside this one, so of links to them the words stay.
    readme = re.sub(r"!?\[([^]]*)\]\((?!\w+:|#)[^)]*\)", r"\1", (ROOT / table["readme"]).read_text())
    return "".join(f"{name}: {value}\n" for name, value in fields) + "\n" + readme


def entry_points(table):
    return "".join(f"[{group}]\n" + "".join(f"{name} = {place}\n" for name, place in members.items())
                   for group, members in table["entry-points"].items())


def configure(build, system_libraries):
    if shutil.which("cmake") is None:
        raise SystemExit("touchstone-contact needs CMake 3.25, which is not installed. In Debian it is the package cmake.")
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    switch = "ON" if system_libraries else "OFF"
    options = {"CMAKE_BUILD_TYPE": "Release", "TOUCHSTONE_EXPERIMENTS": "OFF", "TOUCHSTONE_TESTS": "OFF", "TOUCHSTONE_C": "OFF",
               "TOUCHSTONE_PYTHON": "ON", "Python_EXECUTABLE": sys.executable,
               "TOUCHSTONE_EXACT": switch, "TOUCHSTONE_TBB": switch}
    done = subprocess.run(["cmake", "-S", ROOT, "-B", build, *generator, *(f"-D{name}={value}" for name, value in options.items())],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(done.stdout, flush=True)
    if done.returncode:
        said = " ".join(done.stdout.split())
        for pattern, need, package in NEEDS:
            if re.search(pattern, said):
                raise SystemExit(f"touchstone-contact needs {need}; CMake found none. In Debian it is the package {package}.")
        raise SystemExit("CMake could not configure touchstone-contact")


def compile_package(build, system_libraries=False):
    """Compiles the module in the folder `build`. Returns the package's folder."""
    configure(build, system_libraries)
    subprocess.run(["cmake", "--build", build, "--target", "touchstone_python", "--parallel", str(os.cpu_count() or 1)],
                   check=True)
    return pathlib.Path(build) / "python" / "touchstone_contact"


def platform_tag(module):
    """The tag of PEP 600 that names the newest symbols of glibc which the module needs, if it needs no other library, and
    so runs on each Linux whose glibc has them. Otherwise the tag of this machine."""
    here = re.sub(r"[-.]", "_", sysconfig.get_platform())
    listing = subprocess.run(["objdump", "-p", module], check=True, capture_output=True, text=True).stdout
    needed = re.findall(r"^ +NEEDED +(\S+)", listing, re.MULTILINE)
    versions = [(int(major), int(minor)) for major, minor in re.findall(r" GLIBC_(\d+)\.(\d+)", listing)]
    if not versions or not all(re.fullmatch(r"(libc|libm|ld-linux-.*)\.so\.\d", name) for name in needed):
        return here
    return "manylinux_{}_{}_{}".format(*max(versions), here.removeprefix("linux_"))


def write_wheel(directory, package):
    """Writes the wheel of the compiled package. Returns its name."""
    table = project()
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    module = next(package.glob("_touchstone.*.so"))
    tag = f"{python}-{python}-{platform_tag(module)}"
    info = f"{stem_of(table)}.dist-info"
    files = {str(file.relative_to(package.parent)): file.read_bytes() for file in sorted(package.rglob("*"))
             if file.is_file() and file.suffix != ".pyc"}
    files["touchstone.py"] = (ROOT / "bindings/python/touchstone.py").read_bytes()
    files |= {f"{info}/METADATA": metadata(table, needs(module)).encode(),
              f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: touchstone\nRoot-Is-Purelib: false\nTag: {tag}\n".encode(),
              f"{info}/entry_points.txt": entry_points(table).encode(),
              **{f"{info}/licenses/{file}": (ROOT / file).read_bytes() for file in table["license-files"]},
              f"{info}/CONTRACT.md": (ROOT / "geometry" / "contact" / "CONTRACT.md").read_bytes()}
    record = io.StringIO()
    rows = csv.writer(record, lineterminator="\n")
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        rows.writerow([name, f"sha256={digest}", len(content)])
    rows.writerow([f"{info}/RECORD", "", ""])
    files[f"{info}/RECORD"] = record.getvalue().encode()
    wheel = f"{stem_of(table)}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    known = ("build-dir", "compiled", "system-libraries")
    unknown = settings.keys() - known
    if unknown:
        raise SystemExit(f"unknown settings: {', '.join(sorted(unknown))}; there are {', '.join(known)}")
    if "compiled" in settings:
        return write_wheel(wheel_directory, pathlib.Path(settings["compiled"]))
    libraries = settings.get("system-libraries", "no")
    if libraries not in ("yes", "no"):
        raise SystemExit(f"system-libraries={libraries}: expected yes or no")
    with tempfile.TemporaryDirectory() as scratch:
        build = pathlib.Path(settings.get("build-dir", scratch)).resolve()
        return write_wheel(wheel_directory, compile_package(build, libraries == "yes"))


def build_sdist(sdist_directory, config_settings=None):
    """Packs what the module is built of: the files that git tracks, without those of the program, which are under the GPL."""
    if not (ROOT / ".git").exists():
        raise SystemExit("an sdist is made of the files that git tracks, in a clone of the repository")
    table = project()
    stem = stem_of(table)
    tracked = subprocess.run(["git", "ls-files", "-z", *SOURCES], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    files = {name: (ROOT / name).read_bytes() for name in tracked.split("\0") if name}
    files = {name: content for name, content in files.items() if b"SPDX-License-Identifier: GPL-" not in content[:200]}
    files["PKG-INFO"] = metadata(table).encode()
    with tarfile.open(pathlib.Path(sdist_directory) / f"{stem}.tar.gz", "w:gz") as archive:
        for name, content in files.items():
            entry = tarfile.TarInfo(f"{stem}/{name}")
            entry.size = len(content)
            archive.addfile(entry, io.BytesIO(content))
    return f"{stem}.tar.gz"
