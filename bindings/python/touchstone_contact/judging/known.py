# SPDX-License-Identifier: Apache-2.0
"""Failures that a user knows of, in the file that `touchstone judge --known` reads and writes."""

from __future__ import annotations

import json
import pathlib
from typing import NamedTuple

from .answers import KEYS

NO_ANSWER = "no answer"  # in place of the key


class Known(NamedTuple):
    """A key of a case of which a method gives a wrong value, or none if it `omits` the key."""

    method: str
    case: str
    key: str
    omits: bool = False

    def line(self) -> str:
        members = {"method": self.method, "case": self.case, "key": self.key} | ({"given": False} if self.omits else {})
        return json.dumps(members, separators=(",", ":"), ensure_ascii=False)


def read_known(file: pathlib.Path) -> set[Known]:
    """Raises ValueError, which names the file and the line, if a line is not a known failure."""
    known = set()
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        try:
            members = json.loads(line)
            omits = "given" in members
            words = [members.pop(name) for name in ("method", "case", "key")]
            if members.pop("given", False) is not False or members or not all(isinstance(word, str) for word in words):
                raise ValueError("it needs the words method, case and key, and may have \"given\":false")
            if words[2] not in (*KEYS, NO_ANSWER):
                raise ValueError(f"no answer has a key {words[2]!r}")
        except (AttributeError, LookupError, TypeError, ValueError) as fault:
            raise ValueError(f"{file}: line {number}: is not a known failure: {fault}") from fault
        known.add(Known(words[0], words[1], words[2], omits))
    return known


def known_text(known: set[Known]) -> str:
    return "".join(one.line() + "\n" for one in sorted(known))
