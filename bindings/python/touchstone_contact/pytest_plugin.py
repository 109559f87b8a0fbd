# SPDX-License-Identifier: Apache-2.0
"""`pytest --touchstone package:function` judges a function: one test for each family of certified cases."""

from __future__ import annotations

import importlib
import operator
import pathlib
import sys
from collections.abc import Callable
from typing import Any

import pytest

_OPTIONS = {
    "engine": ("package:function", "judge this function by the certified cases, as touchstone_contact.judge does"),
    "cases": ("FILE", "judge by the cases of these files instead, separated by commas"),
    "keys": ("KEYS", "compare these keys, separated by commas, or all (default: contact)"),
    "beyond": ("MARGIN", "count an answer as wrong only if it is off by more than this, such as 2^-20 or 1e-6m"),
    "known": ("FILE", "failures that this file names are expected"),
    "pictures": ("FOLDER", "write a picture of the first failure of each family to this folder"),
}


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("touchstone", "engines that decide whether a ball touches a polygon")
    for name, (value, text) in _OPTIONS.items():
        group.addoption("--touchstone" + ("" if name == "engine" else f"-{name}"), dest=f"touchstone_{name}", metavar=value, help=text)
    group.addoption("--touchstone-triangles", action="store_true", help="leave out other polygons")


def pytest_configure(config: pytest.Config) -> None:
    """Refuses wrong values of options, before any test."""
    if config.getoption("touchstone_engine") is None:
        return
    from .judging import keys_of
    from .judging.known import read_known
    from .judging.margin import margin_of
    from .judging.question import read_cases

    folder = config.invocation_params.dir
    readers: dict[str, Callable[[str], object]] = {
        "keys": keys_of, "beyond": margin_of, "known": lambda file: read_known(folder / file),
        "cases": lambda files: [list(read_cases(folder / file)) for file in files.split(",")]}
    for name, read in readers.items():
        value = config.getoption(f"touchstone_{name}")
        try:
            if value is not None:
                read(value)
        except (OSError, ValueError) as error:
            raise pytest.UsageError(f"--touchstone-{name} {value}: {error}") from error


def _engine(name: str, folder: pathlib.Path) -> Callable[..., Any]:
    module, _, function = name.partition(":")
    if not module or not function:
        raise pytest.UsageError(f"--touchstone {name}: write package:function")
    sys.path.insert(0, str(folder))
    try:
        found: Callable[..., Any] = operator.attrgetter(function)(importlib.import_module(module))
    except (ImportError, AttributeError) as error:
        raise pytest.UsageError(f"--touchstone {name}: {error}") from error
    return found


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(session: pytest.Session, config: pytest.Config, items: list[pytest.Item]) -> None:
    """Adds the tests, before options such as -k choose among all."""
    name = config.getoption("touchstone_engine")
    if name is None:
        return
    from .judging import case_files

    cases, folder = config.getoption("touchstone_cases"), config.invocation_params.dir
    engine = _engine(name, folder)
    for file in case_files([folder / file for file in cases.split(",")] if cases else "float"):
        items.append(Family.from_parent(session, name=f"touchstone[{file.stem}]", engine=engine, file=file))


class Family(pytest.Item):
    """Judges the cases of a file."""

    def __init__(self, *, engine: Callable[..., Any], file: pathlib.Path, **others: Any) -> None:
        super().__init__(**others)
        self.engine, self.file = engine, file

    def _option(self, name: str) -> Any:
        return self.config.getoption(f"touchstone_{name}")

    def runtest(self) -> None:
        from .judging import case_files, judge

        folder = self.config.invocation_params.dir
        known = self._option("known") and folder / self._option("known")
        judged = judge(self.engine, [self.file], keys=self._option("keys") or "contact", beyond=self._option("beyond"), known=known,
                       triangles=self._option("triangles"), name=self._function(), floats=self.file in case_files("float"))
        if judged.all.cases == 0:
            pytest.skip(f"{self._function()} takes none of the {judged.left_out} cases")
        for mended in judged.mended:
            self.warn(pytest.PytestWarning(f"{known}: mended: {mended.line()}"))
        if judged.new and self._option("pictures"):
            picture = folder / self._option("pictures") / f"{self.file.stem}.svg"
            picture.parent.mkdir(parents=True, exist_ok=True)
            picture.write_text(judged.new[0]._repr_svg_())
        judged.raise_on_failure()

    def _function(self) -> str:
        return str(self._option("engine").partition(":")[2])

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        if not isinstance(excinfo.value, AssertionError):
            return super().repr_failure(excinfo, style)
        module, _, function = self._option("engine").partition(":")
        return f"{excinfo.value}\nto call it: import numpy as np; from {module} import {function.partition('.')[0]}"

    def reportinfo(self) -> tuple[pathlib.Path, int, str]:
        return self.file, 0, self.name
