# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of results, as the program writes its own (experiments/program/output.h)."""
import contextlib
import os


def put_on_disk(path):
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


@contextlib.contextmanager
def replacing(path):
    """A name beside, whose file takes the path's name in the end: readers find the earlier file or the whole new one, also
    after the machine has failed, and a symbolic link is replaced, not followed."""
    beside = path.with_name(f"{path.name}.new-{os.getpid()}")
    beside.unlink(missing_ok=True)
    try:
        yield beside
        put_on_disk(beside)
        os.replace(beside, path)
        put_on_disk(path.parent)
    finally:
        beside.unlink(missing_ok=True)
