# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of results, as the program writes its own (experiments/harness/write_file.h)."""
import contextlib
import os


@contextlib.contextmanager
def replacing(path):
    """A name beside, whose file takes the path's name in the end: readers find the earlier file or the whole new one, and a
    symbolic link is replaced, not followed."""
    beside = path.with_name(f"{path.name}.new-{os.getpid()}")
    beside.unlink(missing_ok=True)
    try:
        yield beside
        os.replace(beside, path)
    finally:
        beside.unlink(missing_ok=True)
