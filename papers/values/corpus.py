# SPDX-License-Identifier: GPL-3.0-or-later
"""The certified corpus."""
import pathlib

from values.latex import count

CORPUS = pathlib.Path(__file__).resolve().parents[2] / "tests/corpus"


def files():
    return sorted(CORPUS.glob("*.jsonl"))


def values():
    yield "files", str(len(files()))
    yield "cases", count(sum(1 for file in files() for line in file.open() if line.strip()))
