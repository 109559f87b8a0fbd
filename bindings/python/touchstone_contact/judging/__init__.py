# SPDX-License-Identifier: Apache-2.0
"""Judges a callable by the certified cases, as the program `touchstone judge` judges an engine behind a pipe.

A test compares the verdicts of both, key by key, with margins and known failures, on all cases that this package has.
"""

from __future__ import annotations

import os
import pathlib
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from .answers import KEYS, same
from .engine import Engine
from .judgement import Count, Difference, Failure, Judgement
from .known import read_known
from .margin import margin_of, within_margin
from .question import Case, Question, read_cases

__all__ = ["Case", "Count", "Difference", "Failure", "Judgement", "Question", "case_files", "judge"]

Cases = str | os.PathLike[str] | Iterable[str | os.PathLike[str]]


def case_files(cases: Cases = "float") -> list[pathlib.Path]:
    """Returns the files of `cases`: "float" stands for those of this package, a file for itself."""
    if cases == "float":
        return sorted((pathlib.Path(__file__).parents[1] / "cases").glob("*.jsonl"))
    return [pathlib.Path(one) for one in ([cases] if isinstance(cases, (str, os.PathLike)) else cases)]


def keys_of(keys: str | Sequence[str]) -> set[str]:
    """Returns the keys that are compared. Raises ValueError if no answer has one of them."""
    names = KEYS if keys == "all" else keys.split(",") if isinstance(keys, str) else list(keys)
    for name in names:
        if name not in KEYS:
            raise ValueError(f"no answer has a key {name!r}")
    return set(names)


def _outcome(engine: Engine, case: Case, keys: list[str], margin: tuple[float, bool] | None) -> tuple[list[Difference], str, bool]:
    """Asks. Returns the expectations that are not met, what was raised, and whether a margin excused a difference."""
    try:
        answer = engine.answer(case.question)
    except Exception as error:  # the other cases are judged all the same
        return [Difference(key, case.expected[key]) for key in keys], f"{type(error).__name__}: {error}", False
    differences, answers = [], None
    excused = False
    for key in keys:
        if key not in answer:
            differences.append(Difference(key, case.expected[key]))
        elif not same(key, case.expected[key], answer[key]):
            answers = answers or (margin and within_margin(case.question, margin))
            if answers and answers.is_exact(key, case.expected[key]) and answers.has(answer, key):
                excused = True
            else:
                differences.append(Difference(key, case.expected[key], answer[key], given=True))
    return differences, "", excused


def judge(engine: Callable[..., Any], cases: Cases = "float", *, keys: str | Sequence[str] = "contact",
          beyond: str | float | None = None, known: str | os.PathLike[str] | None = None, triangles: bool = False,
          floats: bool | None = None, name: str | None = None) -> Judgement:
    """Asks `engine(centre, radius, vertices)` about each case and compares what it returns with the certified answer.

    `engine` gets arrays of shapes (3,) and (n, 3) and a number: of float32 if `floats`, as for the cases "float", which are
    exact in them; else of float64. Cases with holes, of moving balls, of meshes and of posed ones are asked only if it has a
    parameter `holes`, `to`, `faces` or `pose`. It returns whether the ball touches, or a dict of keys of the contract.

    `cases`: "float", or files of cases. `keys`: the keys that are compared, or "all". `beyond`: a margin such as "2^-20" (of
    the largest coordinate) or "1e-6m" (a length). `known`: a file of known failures. `triangles`: leaves out other polygons.
    `name`: that of the engine in the file of known failures; that of the callable otherwise.

    Guarantees
     (1) verdicts are those of `touchstone judge` with the same choices, and so are counts and files of known failures;
     (2) a callable that raises fails in that case, and the others are still judged.

    Raises ValueError for wrong choices and for a line that is not a valid case, and OSError for a file that cannot be read.
    Cost: that of the engine, about a fifth of a millisecond for each case, and three exact answers for each that needs a margin.
    """
    asked = Engine(engine, np.float32 if (cases == "float" if floats is None else floats) else np.float64)
    method = name or str(getattr(engine, "__name__", type(engine).__name__))
    names, margin = keys_of(keys), None if beyond is None else margin_of(beyond)
    judgement = Judgement(method, asked, margin, None if known is None else read_known(pathlib.Path(known)))
    for file in case_files(cases):
        for case in read_cases(file):
            compared = sorted(case.expected.keys() & names)
            if not asked.can(case.question) or (triangles and not case.question.is_of_triangles):
                judgement.left_out += 1
            elif compared:
                judgement.add(case, compared, *_outcome(asked, case, compared, margin))
    return judgement


