# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_install.py SOURCE COMPILED [unittest's options]

`pip install` of the source works in a fresh environment without a network, by hand or from a wheel or archive. COMPILED is the
folder of the compiled package; without it, `--whole` compiles the package as a user's pip does.
"""

import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile

SAMPLE = """
import touchstone_contact as touchstone
square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
scene = touchstone.Scene()
scene.add("square", touchstone.Mesh(square, [[0, 1, 2], [0, 2, 3]]))
ball, moved = [0.5, 0.25, 1, 1], [0.5, 0.25, 6, 1]
before = scene.touches(ball), scene.touches(moved)
scene.set_pose("square", [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]])
after = scene.touches(ball), scene.touches(moved)
print(touchstone.__file__, touchstone.filtered.contact(ball, touchstone.Polygon(square)), *before, *after)
"""


class Install(unittest.TestCase):
    source, compiled = None, None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.settings = [] if self.compiled == "--whole" else ["--config-settings", f"compiled={self.compiled}"]

    def run_command(self, *command):
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True, cwd=self.folder, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_by_pip_gives_a_module_that_answers(self):
        self.run_command(sys.executable, "-m", "venv", "--system-site-packages", self.folder / "venv")
        python = self.folder / "venv" / "bin" / "python"
        self.run_command(python, "-m", "pip", "install", "--no-index", *self.settings, self.source)
        where, *answers = self.run_command(python, "-c", SAMPLE).split()
        self.assertTrue(pathlib.Path(where).is_relative_to(self.folder / "venv"), where)
        self.assertEqual(answers, ["True", "True", "False", "False", "True"])
        self.assertIn("Name: touchstone-contact\nVersion: ", self.run_command(python, "-m", "pip", "show", "touchstone-contact"))

    def test_of_a_wheel_brings_licence_contract_and_annotations(self):
        sys.path.insert(0, str(self.source / "bindings/python"))
        import build_backend

        wheel = build_backend.write_wheel(self.folder, self.package())
        names = zipfile.ZipFile(self.folder / wheel).namelist()
        for name in ("LICENSE", "CONTRACT.md", "py.typed", "__init__.pyi", "METADATA", "RECORD"):
            self.assertTrue(any(found.endswith("/" + name) for found in names), name)
        with self.assertRaisesRegex(SystemExit, "unknown settings: build-dri"):
            build_backend.build_wheel(self.folder, {"build-dri": "x"})
        if (self.source / ".git").exists():
            with tarfile.open(self.folder / build_backend.build_sdist(self.folder)) as archive:
                packed = archive.getnames()
            for name in ("PKG-INFO", "pyproject.toml", "CMakeLists.txt", "bindings/python/build_backend.py", "robust/scene/scene.cpp"):
                self.assertTrue(any(found.endswith("/" + name) for found in packed), name)

    def package(self):
        if self.compiled != "--whole":
            return pathlib.Path(self.compiled)
        import build_backend

        return build_backend.compile_package(self.folder / "build")


if __name__ == "__main__":
    Install.compiled = sys.argv.pop(2)
    Install.source = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
