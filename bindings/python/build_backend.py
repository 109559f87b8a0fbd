# SPDX-License-Identifier: Apache-2.0
"""What pip calls to build a wheel (PEP 517): CMake compiles the libraries and the module, and nothing else.

No backend of Debian 12 drives CMake. This one needs only Python's own library, so that `pip install .` works without a
network. `pip install . --config-settings build-dir=FOLDER` keeps the compiled files for the next time, and `--config-settings
compiled=build/release/python/touchstone_contact` takes a module that is compiled already.
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


def project():
    """Returns the table `project` of pyproject.toml, with the version of CMakeLists.txt."""
    table = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    version = re.search(r"project\(Touchstone VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())
    return {**table, "version": version[1]}


def metadata(table):
    lines = ["Metadata-Version: 2.1", f"Name: {table['name']}", f"Version: {table['version']}",
             f"Summary: {table['description']}", f"License: {table['license']['text']}",
             f"Requires-Python: {table['requires-python']}", *(f"Requires-Dist: {need}" for need in table["dependencies"]),
             "Description-Content-Type: text/markdown"]
    return "\n".join(lines) + "\n\n" + (ROOT / table["readme"]).read_text()


def compile_package(build):
    """Compiles the module in the folder `build`. Returns the package's folder."""
    if shutil.which("cmake") is None:
        raise SystemExit("touchstone needs CMake, a C++20 compiler and the libraries that README.md names: cmake was not found")
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    options = {"CMAKE_BUILD_TYPE": "Release", "TOUCHSTONE_EXPERIMENTS": "OFF", "TOUCHSTONE_TESTS": "OFF",
               "TOUCHSTONE_PYTHON": "ON", "Python_EXECUTABLE": sys.executable}
    subprocess.run(["cmake", "-S", ROOT, "-B", build, *generator, *(f"-D{name}={value}" for name, value in options.items())],
                   check=True)
    subprocess.run(["cmake", "--build", build, "--target", "touchstone_python", "--parallel", str(os.cpu_count() or 1)],
                   check=True)
    return pathlib.Path(build) / "python" / "touchstone_contact"


def write_wheel(directory, package):
    """Writes the wheel of the compiled package. Returns its name."""
    table = project()
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{re.sub(r'[-.]', '_', sysconfig.get_platform())}"
    stem = f"{table['name'].replace('-', '_')}-{table['version']}"
    info = f"{stem}.dist-info"
    files = {f"{package.name}/{file.name}": file.read_bytes() for file in sorted(package.iterdir()) if file.is_file()}
    files["touchstone.py"] = (ROOT / "bindings/python/touchstone.py").read_bytes()
    files |= {f"{info}/METADATA": metadata(table).encode(),
              f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: touchstone\nRoot-Is-Purelib: false\nTag: {tag}\n".encode(),
              f"{info}/LICENSE": (ROOT / "LICENSE-APACHE").read_bytes(),
              f"{info}/CONTRACT.md": (ROOT / "geometry" / "contact" / "CONTRACT.md").read_bytes()}
    record = io.StringIO()
    rows = csv.writer(record, lineterminator="\n")
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        rows.writerow([name, f"sha256={digest}", len(content)])
    rows.writerow([f"{info}/RECORD", "", ""])
    files[f"{info}/RECORD"] = record.getvalue().encode()
    wheel = f"{stem}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    unknown = settings.keys() - {"build-dir", "compiled"}
    if unknown:
        raise SystemExit(f"unknown settings: {', '.join(sorted(unknown))}; there are build-dir and compiled")
    if "compiled" in settings:
        return write_wheel(wheel_directory, pathlib.Path(settings["compiled"]))
    if "build-dir" in settings:
        return write_wheel(wheel_directory, compile_package(pathlib.Path(settings["build-dir"]).resolve()))
    with tempfile.TemporaryDirectory() as build:
        return write_wheel(wheel_directory, compile_package(build))


def build_sdist(sdist_directory, config_settings=None):
    """Packs the files that git tracks."""
    table = project()
    stem = f"{table['name'].replace('-', '_')}-{table['version']}"
    tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    with tarfile.open(pathlib.Path(sdist_directory) / f"{stem}.tar.gz", "w:gz") as archive:
        for name in filter(None, tracked.split("\0")):
            archive.add(ROOT / name, f"{stem}/{name}", recursive=False)
        content = metadata(table).encode()
        entry = tarfile.TarInfo(f"{stem}/PKG-INFO")
        entry.size = len(content)
        archive.addfile(entry, io.BytesIO(content))
    return f"{stem}.tar.gz"
