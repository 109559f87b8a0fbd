# SPDX-License-Identifier: Apache-2.0
"""What a function of the module says about arguments that it does not take."""

from __future__ import annotations

import re


def told(text: str, given: tuple[object, ...], keywords: dict[str, object]) -> str | None:
    """Returns what to say instead of pybind11's text, which shows all values, however long; None for other texts."""
    signatures = re.findall(r"^    \d+\. ([\w.]*)\((self: [\w.]+(?:, )?)?(.*)\)(?: -> .*)?$", text.partition("\n\nInvoked with")[0], re.MULTILINE)
    if not signatures:
        return None
    constructed, self, _ = signatures[0]
    function = constructed.rpartition(".")[2] or text.partition("()")[0]
    takes = " or ".join(f"({arguments})" for *_, arguments in signatures).replace("touchstone_contact._touchstone.", "")
    unknown = ", ".join(repr(name) for name in keywords if f"({name}: " not in takes and f", {name}: " not in takes)
    values = [type(value).__name__ for value in given[bool(constructed or self):]]
    values += [f"{name}: {type(value).__name__}" for name, value in keywords.items()]
    begins = f"{function}() has no argument {unknown}. It" if unknown else f"{function}()"
    return f"{begins} takes {takes}, and was given ({', '.join(values)})"
