# SPDX-License-Identifier: GPL-3.0-or-later
"""The certified corpus."""
import pathlib

from values.latex import count

CORPUS = pathlib.Path(__file__).resolve().parents[2] / "tests/corpus"


def files():
    return sorted(CORPUS.glob("*.jsonl"))


def values():
    cases = {file.stem: sum(1 for line in file.open() if line.strip()) for file in files()}
    yield "files", str(len(cases))
    yield "cases", count(sum(cases.values()))
    yield "moving", count(cases["moving"])
    yield "at-rest", count(sum(cases.values()) - cases["moving"])
