# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: test_replacing.py SOURCE

A file of results is replaced whole, or stays as it was."""
import pathlib
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(sys.argv[1]) / "experiments/report"))

from replacing import replacing  # noqa: E402


class Replacing(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.page = self.folder / "report.html"
        self.page.write_text("earlier")

    def test_gives_the_new_file_the_name(self):
        with replacing(self.page) as file:
            file.write_text("new")
            self.assertEqual(self.page.read_text(), "earlier")
        self.assertEqual(self.page.read_text(), "new")
        self.assertEqual(list(self.folder.iterdir()), [self.page])

    def test_keeps_the_earlier_file_where_the_new_one_fails(self):
        with self.assertRaises(OSError), replacing(self.page) as file:
            file.write_text("half")
            raise OSError
        self.assertEqual(self.page.read_text(), "earlier")
        self.assertEqual(list(self.folder.iterdir()), [self.page])

    def test_follows_no_link(self):
        link = self.folder / "index.html"
        link.symlink_to(self.page)
        with replacing(link) as file:
            file.write_text("new")
        self.assertEqual(self.page.read_text(), "earlier")
        self.assertFalse(link.is_symlink())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
