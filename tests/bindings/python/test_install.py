# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_install.py SOURCE COMPILED [unittest's options]

`pip install` of the source works in a fresh environment without a network, and what is published names its authors,
licences and needs. COMPILED is the folder of the compiled package; with `--whole` instead, pip compiles the package with the
libraries of this machine.
"""

import email
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile

import yaml

SOURCE, COMPILED = pathlib.Path(sys.argv.pop(1)).resolve(), sys.argv.pop(1)
CITATION = yaml.safe_load((SOURCE / "CITATION.cff").read_text())
sys.path.insert(0, str(SOURCE / "bindings/python"))
import build_backend  # noqa: E402

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
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def run_command(self, *command):
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True, cwd=self.folder, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_by_pip_gives_a_module_that_answers(self):
        self.run_command(sys.executable, "-m", "venv", "--system-site-packages", self.folder / "venv")
        python = self.folder / "venv" / "bin" / "python"
        setting = "system-libraries=yes" if COMPILED == "--whole" else f"compiled={COMPILED}"
        self.run_command(python, "-m", "pip", "install", "--no-index", "--config-settings", setting, SOURCE)
        where, *answers = self.run_command(python, "-c", SAMPLE).split()
        self.assertTrue(pathlib.Path(where).is_relative_to(self.folder / "venv"), where)
        self.assertEqual(answers, ["True", "True", "False", "False", "True"])
        self.assertIn("Name: touchstone-contact\nVersion: ", self.run_command(python, "-m", "pip", "show", "touchstone-contact"))

        (self.folder / "mine.py").write_text("import touchstone_contact\n\n\ndef contact(centre, radius, vertices):\n"
                                             "    return touchstone_contact.filtered.contact((centre, radius), touchstone_contact.Polygon(vertices))\n")
        judged = self.run_command(python, "-m", "pytest", "--touchstone", "mine:contact", "-k", "sliver or holes", "-q")
        self.assertIn("1 passed, 1 skipped", judged)

    def test_of_a_wheel_brings_licences_contract_and_annotations(self):
        with zipfile.ZipFile(self.folder / build_backend.build_wheel(self.folder, {"compiled": COMPILED})) as wheel:
            names = {name.partition("/")[2]: name for name in wheel.namelist()}
            said = email.message_from_bytes(wheel.read(names["METADATA"]))
            self.assertIn(b"GNU Lesser General Public License", wheel.read(names["licenses/bindings/python/NOTICES"]))
        self.assertFalse(any("real-meshes" in name for name in names))  # under the GPL
        for name in ("CONTRACT.md", "py.typed", "__init__.pyi", "RECORD", "entry_points.txt", "cases/edge.jsonl", "cases/LICENSE.txt", "judging/__init__.py", *(f"licenses/{file}" for file in said.get_all("License-File"))):
            self.assertIn(name, names)
        self.assertEqual((said["Name"], said["Version"]), ("touchstone-contact", CITATION["version"]))
        self.assertNotRegex(said.get_payload(), r"\]\((?!https://|#)")
        self.assertIn("Platforms compares", " ".join(said.get_payload().split()))

    def test_of_a_module_with_libraries_of_this_machine_is_for_this_machine_alone(self):
        module, = pathlib.Path(COMPILED).glob("*.so")
        self.assertRegex(build_backend.platform_tag(module), "^linux_")

    def test_refuses_what_it_does_not_know(self):
        for settings, sentence in (({"build-dri": "x"}, "unknown settings: build-dri"), ({"system-libraries": "1"}, "expected yes or no")):
            with self.assertRaisesRegex(SystemExit, sentence):
                build_backend.build_wheel(self.folder, settings)

    @unittest.skipUnless((SOURCE / ".git").exists(), "an sdist is made of what git tracks")
    def test_of_an_sdist_has_sources_and_nothing_of_the_program(self):
        with tarfile.open(self.folder / build_backend.build_sdist(self.folder)) as archive:
            names = {name.partition("/")[2] for name in archive.getnames()}
            texts = [archive.extractfile(member).read(200) for member in archive]
        self.assertLess({"PKG-INFO", "pyproject.toml", "CMakeLists.txt", "bindings/python/NOTICES", "robust/scene/scene.cpp",
                         "tests/corpus/floats/edge.jsonl"}, names)
        self.assertNotIn("tests/corpus/floats/real-meshes.jsonl", names)
        self.assertFalse([text for text in texts if b"Identifier: GPL-" in text])


class Metadata(unittest.TestCase):
    def test_is_that_of_the_citation(self):
        table = build_backend.project()
        self.assertEqual(table["version"], CITATION["version"])
        self.assertEqual(table["authors"], CITATION["authors"])
        self.assertEqual(table["keywords"], CITATION["keywords"])

    def test_recipes_name_one_repository(self):
        for file in ("docs/engines.md", ".github/actions/judge/action.yml", ".github/workflows/judge-engine.yml", ".gitlab/judge-engine.yml"):
            named = re.findall(r"(?:\w\.(?:com|org)/|uses: |touchstone: |project: )([\w.-]+)/touchstone\b", (SOURCE / file).read_text())
            self.assertEqual(set(named), {"example"}, file)


if __name__ == "__main__":
    unittest.main()
