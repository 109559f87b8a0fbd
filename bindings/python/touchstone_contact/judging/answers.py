# SPDX-License-Identifier: Apache-2.0
"""Answers as dictionaries of the contract's keys: the exact one, what an engine returns, and whether two values agree."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any

from .. import FirstContact, exact
from .question import Question

RELATIONS, FIRSTS = ["separate", "touching", "overlapping"], ["start", "way", "none"]
_WORDS = {"plane": ["in_front", "behind", "intersects"], "foot": ["inside", "boundary", "outside"],
          "relation": RELATIONS, "first": FIRSTS}
_OF_ONE_POLYGON = ("plane", "plane_tangent", "foot", "edges_hit", "off_plane")
KEYS = ("plane", "plane_tangent", "foot", "edges_hit", "touched", "relation", "contact", "first", "time", "momentary", "face",
        "feature", "nearest", "point", "distance", "contact_normal", "depth", "off_plane")


def plain(value: Any) -> Any:
    """Returns a value as JSON has it: NumPy's numbers and arrays become numbers and lists."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {str(key): plain(member) for key, member in value.items()}
    return [plain(member) for member in value] if isinstance(value, (list, tuple)) else value


def text(value: Any) -> str:
    """Returns a value as JSON, for messages; one that JSON does not have as Python writes it."""
    return json.dumps(value, default=repr)


def _index(value: Any) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 <= value < 2**64 or value != int(value):
        raise ValueError
    return int(value)


def _number(value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float, type(None))):
        raise ValueError
    try:
        return float(value) if value is not None and math.isfinite(value) else math.inf  # JSON has null for all that are not finite
    except OverflowError:  # an integer that no double holds
        raise ValueError from None


def read(key: str, value: Any) -> Any:
    """Returns the value of a key, so that equal ones are ==. Raises ValueError if it does not have the contract's form."""
    if key in ("plane_tangent", "contact", "momentary"):
        if isinstance(value, bool):
            return value
    elif key in _WORDS:
        if value in _WORDS[key]:
            return value
    elif key in ("time", "distance", "depth", "off_plane"):
        return _number(value)
    elif key == "face":
        return _index(value)
    elif key in ("edges_hit", "touched"):
        if isinstance(value, list):
            return [_index(member) for member in value]
    elif key in ("point", "contact_normal"):
        if isinstance(value, list) and len(value) == 3:
            return [_number(x) for x in value]
    elif key in ("nearest", "feature") and isinstance(value, dict):
        if value == {"kind": "face"}:
            return value
        if value.keys() == {"kind", "index"} and value["kind"] in ("edge", "vertex"):
            return {"kind": value["kind"], "index": _index(value["index"])}
    raise ValueError(f"{key} cannot be {text(value)}")


def same(key: str, a: Any, b: Any) -> bool:
    """Returns whether two values of a key agree. Ones that do not have the contract's form agree if their texts do."""
    try:
        return bool(read(key, a) == read(key, b))
    except ValueError:
        return text(a) == text(b)


def _of_first_contact(first: FirstContact) -> dict[str, Any]:
    touches = first.contact
    return {"contact": touches, "first": first.kind, "time": first.time if touches else None,
            "momentary": first.momentary if first.kind == "way" else None,
            **{key: plain(getattr(first, key)) if touches else None for key in ("feature", "point", "contact_normal", "depth")}}


def of_polygon(path: Any, question: Question) -> dict[str, Any]:
    """Returns the answer of a path of this module, such as `exact`, about a polygon."""
    at_rest: dict[str, Any] = path.answer([*question.centre, question.radius], question.polygon).verdict()
    if question.to is None:
        return at_rest
    first = path.first_contact(question.row(), question.polygon)
    return _of_first_contact(first) | {"off_plane": at_rest["off_plane"]}


def exact_answer(question: Question) -> dict[str, Any]:
    """Returns the exact answer to a question, with all keys of the contract."""
    if question.faces is None:
        return of_polygon(exact, question)
    scene, row = question.scene, question.row()
    numbers: Any = scene.face_numbers("mesh").tolist()
    if question.to is None:
        pairs: Any = scene.touched(row)
        touched: list[int] = [number for _, number in pairs.tolist()]
        nearest: Any = scene.nearest(row)
    else:
        in_order: Any = scene.touched_in_order(row)
        touched = [first.face for first in in_order]
        nearest = scene.first_contact(row)
    face = numbers[nearest.face] if nearest else None
    about_face = exact_answer(question.about_face(face or 0))
    return {"touched": sorted(numbers[i] for i in touched), "face": face,
            **{key: value for key, value in about_face.items() if key not in _OF_ONE_POLYGON}}
