# SPDX-License-Identifier: Apache-2.0
"""A callable as an engine: which questions it takes, in which numbers, and what it returns as keys of the contract."""

from __future__ import annotations

import dataclasses
import functools
import inspect
from collections.abc import Callable, Mapping
from typing import Any

from .answers import plain
from .question import Question

OPTIONAL = ("holes", "to", "faces", "pose")


@dataclasses.dataclass(frozen=True)
class Engine:
    """`call(centre, radius, vertices)`, with the optional parameters that it names. `numbers`: np.float32 or np.float64."""

    call: Callable[..., Any]
    numbers: Any

    @functools.cached_property
    def takes(self) -> set[str]:
        try:
            return set(inspect.signature(self.call).parameters).intersection(OPTIONAL)
        except ValueError:  # a function of C without a signature
            return set()

    def asked(self, question: Question) -> dict[str, Any]:
        """Returns the optional arguments that say something about the question."""
        made = self.numbers
        given: dict[str, Any] = {"holes": [made(hole) for hole in question.holes], "to": question.to and made(question.to),
                                 "faces": question.faces and [list(face) for face in question.faces],
                                 "pose": question.pose and made(question.pose)}
        return {name: value for name, value in given.items() if value is not None and len(value) > 0}

    def can(self, question: Question) -> bool:
        """Returns whether it takes all arguments that the question needs."""
        return self.asked(question).keys() <= self.takes

    def arguments(self, question: Question) -> tuple[list[Any], dict[str, Any]]:
        asked, made = self.asked(question), self.numbers
        others = {name: asked.get(name, [] if name == "holes" else None) for name in OPTIONAL if name in self.takes}
        return [made(question.centre), made(question.radius), made(question.vertices)], others

    def answer(self, question: Question) -> dict[str, Any]:
        """Asks. Raises what the callable raises, and TypeError if it returns neither a bool nor keys nor None."""
        arguments, others = self.arguments(question)
        returned = self.call(*arguments, **others)
        if returned is None:
            return {}
        if hasattr(returned, "verdict"):  # an Answer of this module
            returned = returned.verdict()
        returned = plain(returned)
        if isinstance(returned, bool):
            return {"contact": returned}
        if not isinstance(returned, Mapping):
            raise TypeError(f"returned {returned!r}, which is neither a bool nor a dict of keys")
        return dict(returned)

    def text(self, name: str, question: Question) -> str:
        """Returns the call as a line of Python that needs NumPy as np."""
        def array(value: Any) -> str:
            return f"np.{self.numbers.__name__}({_short(value, self.numbers)})"

        texts = [array(x) for x in (question.centre, question.radius, question.vertices)]
        for key in self.arguments(question)[1]:
            value = getattr(question, key)
            if key == "holes":
                texts.append("holes=[" + ", ".join(map(array, value)) + "]")
            else:
                texts.append(f"{key}={value if value is None else list(map(list, value)) if key == 'faces' else array(value)}")
        return f"{name}({', '.join(texts)})"


def _short(value: Any, numbers: Any) -> str:
    """Returns numbers with as few digits as read back the same."""
    if isinstance(value, tuple):
        return "[" + ", ".join(_short(member, numbers) for member in value) + "]"
    return str(int(value)) if value == int(value) and abs(value) < 2**53 else str(numbers(value))
