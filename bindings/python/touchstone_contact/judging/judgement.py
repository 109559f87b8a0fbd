# SPDX-License-Identifier: Apache-2.0
"""What judging finds out: counts, failures, and which of them were known."""

from __future__ import annotations

import dataclasses
import functools
import html
import math
import os
import pathlib
from typing import Any

from .answers import exact_answer, same, text
from .drawing import svg
from .engine import Engine
from .known import NO_ANSWER, Known, known_text
from .margin import within_margin
from .question import Case, Question
from .shrinking import shrunk

_SHOWN = 3  # failures that a message or a page names


@dataclasses.dataclass
class Count:
    """Cases, how many got a wrong value, or none and no wrong one; how many of these are known; and how many are wrong by
    no more than the margin.
    """

    cases: int = 0
    wrong: int = 0
    not_given: int = 0
    known: int = 0
    within: int = 0

    @property
    def upper(self) -> float:
        """The upper 95 % limit, after Clopper and Pearson, of the share of wrong cases among those that were answered."""
        n, wrong = self.cases - self.not_given, self.wrong
        if wrong >= n:
            return 1.0

        def tail(p: float) -> float:  # the probability of no more wrong ones
            logs = (math.lgamma(n + 1) - math.lgamma(k + 1) - math.lgamma(n - k + 1) + k * math.log(p) + (n - k) * math.log1p(-p)
                    for k in range(wrong + 1))
            return math.fsum(map(math.exp, logs))

        low, high = wrong / n, 1.0
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if tail(middle) > 0.025 else (low, middle)
        return (low + high) / 2


@dataclasses.dataclass(frozen=True)
class Difference:
    """An expectation that an answer does not meet."""

    key: str
    expected: Any
    found: Any = None
    given: bool = False
    known: bool = False

    def __str__(self) -> str:
        return f"{self.key}: expected {text(self.expected)}, {'found ' + text(self.found) if self.given else 'not given'}"


@dataclasses.dataclass(frozen=True)
class Failure:
    """A case in which an engine fails. `fault`: what it raised. `known`: whether all differences are known."""

    case: Case
    differences: tuple[Difference, ...]
    fault: str
    known: bool
    judgement: Judgement = dataclasses.field(repr=False, compare=False)

    def __str__(self) -> str:
        news = [str(one) for one in self.differences if not one.known] or [str(one) for one in self.differences]
        return f"case {self.case.id}: " + (self.fault or "; ".join(news))

    @property
    def call(self) -> str:
        """The call that fails, as a line of Python that needs NumPy as np and the engine under its name."""
        return self.judgement.engine.text(self.judgement.name, self.case.question)

    @property
    def line(self) -> str:
        """The case as a line of JSON, for a file of cases."""
        members = {"id": self.case.id, **self.case.question.members(), "expected": self.case.expected}
        return text(members)

    @functools.cached_property
    def small(self) -> Failure:
        """A failure of the same key, and of the same kind, about a question that is as small as was found."""
        first = next((one for one in self.differences if not one.known), self.differences[0])

        def failed(question: Question) -> tuple[Difference, str] | None:
            truth = exact_answer(question).get(first.key)
            if isinstance(truth, (bool, str)) and truth != first.expected:
                return None
            try:
                answer = self.judgement.engine.answer(question)
            except Exception as error:
                raised = f"{type(error).__name__}: {error}"
                return (Difference(first.key, truth), raised) if raised.split(":")[0] == self.fault.split(":")[0] else None
            if self.fault or first.given != (first.key in answer) or same(first.key, truth, answer.get(first.key)):
                return None
            found, margin = answer.get(first.key), self.judgement.margin
            if isinstance(found, (bool, str)) and found != first.found:
                return None
            if first.given and margin and within_margin(question, margin).has(answer, first.key):
                return None
            return Difference(first.key, truth, found, first.given), ""

        question = shrunk(self.case.question, lambda one: failed(one) is not None, self.judgement.engine.numbers)
        difference, fault = failed(question) or (first, self.fault)
        case = Case(self.case.id + "-small", self.case.family, self.case.tags, question, {first.key: difference.expected})
        return Failure(case, (difference,), fault, self.known, self.judgement)

    def _repr_svg_(self) -> str:
        first = next((one for one in self.differences if not one.known), self.differences[0])
        return svg(self.case.question, self.case.id, self.fault or str(first))


class Judgement:
    """The counts and the failures of an engine. True if every failure is known.

    `families`: the counts by file. `failures`: in the order of the cases. `mended`: known failures that no longer occur.
    `left_out`: how many cases the callable does not take. `engine`, `margin`: what was asked for.
    """

    def __init__(self, name: str, engine: Engine, margin: tuple[float, bool] | None, known: set[Known] | None) -> None:
        self.name, self.engine, self.margin = name, engine, margin
        self.all, self.families, self.failures, self.left_out = Count(), dict[str, Count](), list[Failure](), 0
        self._known, self._judged, self._occurred, self._ids = known, set[Known](), set[Known](), set[str]()

    def add(self, case: Case, keys: list[str], differences: list[Difference], fault: str, excused: bool) -> None:
        if self._known is not None and case.id in self._ids:
            raise ValueError(f"case {case.id}: its id is not unique, so its failures cannot be known")
        self._ids.add(case.id)
        known = self._known or set()
        no_answer = Known(self.name, case.id, NO_ANSWER)
        found = {no_answer} if fault else {Known(self.name, case.id, one.key, not one.given) for one in differences}
        self._judged.add(no_answer)
        if not fault:
            self._judged |= {Known(self.name, case.id, key, omits) for key in keys for omits in (False, True)}
        self._occurred |= found
        differences = [dataclasses.replace(one, known=(no_answer if fault else Known(self.name, case.id, one.key, not one.given)) in known)
                       for one in differences]
        wrong, all_known = any(one.given for one in differences), bool(found) and found <= known
        for count in (self.all, self.families.setdefault(case.family, Count())):
            count.cases += 1
            count.wrong += wrong
            count.not_given += bool(found) and not wrong
            count.known += all_known
            count.within += excused and not found
        if found:
            self.failures.append(Failure(case, tuple(differences), fault, all_known, self))

    @property
    def new(self) -> list[Failure]:
        """The failures that are not known."""
        return [failure for failure in self.failures if not failure.known]

    @property
    def mended(self) -> list[Known]:
        return sorted(one for one in self._known or () if one in self._judged and one not in self._occurred)

    def __bool__(self) -> bool:
        return not self.new

    def raise_on_failure(self) -> None:
        """Raises AssertionError, which names the first failures and makes one small, unless every failure is known."""
        new = self.new
        if not new:
            return
        small = new[0].small
        named = "".join(f"  {failure}\n" for failure in new[:_SHOWN]) + (f"  and {len(new) - _SHOWN} more\n" if len(new) > _SHOWN else "")
        raise AssertionError(f"{self.name} fails in {len(new)} of {self.all.cases} cases:\n{named}"
                             f"made small: {str(small).removeprefix(f'case {small.case.id}: ')}\n  {small.call}")

    def write_known(self, file: str | os.PathLike[str]) -> None:
        """Writes the failures that occurred, and the known ones that were not judged, as `--known FILE --update` does."""
        pathlib.Path(file).write_text(known_text(self._occurred | ((self._known or set()) - self._judged)), encoding="utf-8")

    def _rows(self) -> list[list[str]]:
        counts = [("all cases", self.all), *sorted(self.families.items())]
        return [[name, str(c.wrong), str(c.cases - c.not_given), f"{100 * c.upper:.2f} %", str(c.not_given), str(c.known), str(c.within)]
                for name, c in counts]

    _HEADS = ["", "wrong", "of", "95 % limit", "no answer", "known", "within"]

    def __str__(self) -> str:
        lines = ["".join(f"{cell:>11}" if i else f"{cell:<18}" for i, cell in enumerate(row)) for row in [self._HEADS, *self._rows()]]
        left_out = f"\nleft out, because {self.name} does not take them: {self.left_out}" if self.left_out else ""
        return f"{self.name}\n" + "\n".join(lines) + left_out

    __repr__ = __str__

    def _repr_html_(self) -> str:
        head, *rows = ["<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>" for row in [self._HEADS, *self._rows()]]
        return f"<p>{html.escape(self.name)}</p><table>{head}{''.join(rows)}</table>" + "".join(f._repr_svg_() for f in self.new[:_SHOWN])
