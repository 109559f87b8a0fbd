# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: archive_test.py TOUCHSTONE SOURCE SCRATCH

The archive of the corpus has the same bytes each time, its checksums are right, its pages lead to its own files, an
engine can be judged with what it holds, and the citation names its version and the program's."""
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

TOUCHSTONE, SOURCE, SCRATCH = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
ARCHIVE = SOURCE / "experiments/judge/corpus/archive.py"


def packed(source, folder):
    return subprocess.run([sys.executable, "-B", ARCHIVE, source, folder], capture_output=True, text=True)


class Archive(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(dir=SCRATCH))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        done = packed(SOURCE, cls.folder)
        assert done.returncode == 0, done.stderr
        cls.checksum, path = done.stdout.split()
        cls.path = pathlib.Path(path)
        with tarfile.open(path) as tar:
            tar.extractall(cls.folder)
        cls.corpus = cls.folder / cls.path.name.removesuffix(".tar.gz")

    def test_has_the_same_bytes_each_time(self):
        self.assertEqual(packed(SOURCE, self.folder / "again").stdout.split()[0], self.checksum)
        self.assertEqual(hashlib.sha256(self.path.read_bytes()).hexdigest(), self.checksum)

    def test_checksums_cover_every_file(self):
        listed = dict(reversed(line.split("  ")) for line in (self.corpus / "SHA256SUMS").read_text().splitlines())
        self.assertEqual(sorted([*listed, "SHA256SUMS"]),
                         sorted(str(path.relative_to(self.corpus)) for path in self.corpus.rglob("*") if path.is_file()))
        for name, checksum in listed.items():
            self.assertEqual(hashlib.sha256((self.corpus / name).read_bytes()).hexdigest(), checksum, name)

    def test_pages_lead_to_its_own_files(self):
        links = 0
        for page in self.corpus.glob("*.md"):
            for target in re.findall(r"\]\(([^)\s#]+)", page.read_text()):
                if not re.match("[a-z]+:", target):
                    links += 1
                    self.assertTrue((self.corpus / target).is_file(), f"{page.name}: {target}")
        self.assertGreater(links, 3)

    def test_an_engine_can_be_judged_with_it(self):
        cases = sorted(str(path) for path in self.corpus.glob("*.jsonl"))
        done = subprocess.run([TOUCHSTONE, "judge", "--methods", "filtered", "--quiet", *cases], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_missing_file_is_an_error_that_names_it(self):
        done = packed(self.folder, self.folder / "none")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"archive\.py: .*tests/corpus/corpus\.json: No such file")


class Citation(unittest.TestCase):
    def test_names_the_versions_of_the_program_and_of_the_corpus(self):
        citation = (SOURCE / "CITATION.cff").read_text()
        program = re.search(r"project\(Touchstone VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]
        corpus = re.search(r'"version": (\d+)', (SOURCE / "tests/corpus/corpus.json").read_text())[1]
        self.assertEqual(re.findall(r"^version: (\S+)$", citation, re.M), [program])
        self.assertEqual(re.findall(r'^    version: "?(\d+)"?$', citation, re.M), [corpus])
        self.assertIn(f"## {program}", (SOURCE / "CHANGELOG.md").read_text())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
