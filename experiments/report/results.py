# SPDX-License-Identifier: GPL-3.0-or-later
"""The data that pages are made of: what lies in the folder of a study, read strictly. Whatever is missing or malformed is
an error that names the file, and the line."""
import csv
import json
import math
import re


class DataError(Exception):
    pass


def finite(text):
    value = float(text)
    if not math.isfinite(value):
        raise ValueError
    return value


def number(text):
    """Reads a number. Accepts infinity (an unbounded error), refuses NaN."""
    value = float(text)
    if math.isnan(value):
        raise ValueError
    return value


def share(text):
    value = finite(text)
    if not 0 <= value <= 1:
        raise ValueError
    return value


def natural(text):
    value = int(text)
    if value < 0:
        raise ValueError
    return value


def maybe(kind):
    """Of a column in which cells may be empty: None there."""
    return lambda text: kind(text) if text else None


def read_csv(path, **columns):
    """The rows as dicts of the columns that are named, each by what reads its cells."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            reader = csv.reader(file)
            head = next(reader, [])
            if missing := [name for name in columns if name not in head]:
                raise DataError(f"{path}: no column {', '.join(missing)}")
            places = [(name, head.index(name), kind) for name, kind in columns.items()]
            rows = []
            for cells in reader:
                if len(cells) != len(head):
                    raise DataError(f"{path}: line {reader.line_num}: {len(cells)} cells instead of {len(head)}")
                row = {}
                for name, place, kind in places:
                    try:
                        row[name] = kind(cells[place])
                    except ValueError:
                        raise DataError(f"{path}: line {reader.line_num}: {name} cannot be '{cells[place]}'") from None
                rows.append(row)
            return rows
    except OSError as error:
        raise DataError(f"{path}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise DataError(f"{path}: is not text in UTF-8") from None


def distinct(rows, name, of=None):
    """What rows have in a column, each once: in their order, or `of` some values, in the order of those."""
    found = dict.fromkeys(row[name] for row in rows)
    return list(found) if of is None else [value for value in of if value in found]


# Kinds of what run.json says.
def is_natural(value):
    return type(value) is int and value >= 0


def is_duration(value):
    return type(value) in (int, float) and 0 <= value < math.inf


def is_text(value):
    return type(value) is str


def is_texts(value):
    return type(value) is list and all(map(is_text, value))


def is_date(value):
    return is_text(value) and re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", value) is not None


RUN = {"command": is_text, "seed": is_natural, "samples_asked": is_natural, "samples_done": is_natural,
       "samples_missing": is_natural, "parts": is_natural, "threads": is_natural, "seconds": is_duration, "date": is_date,
       "compiler": is_text, "flags": is_text, "processor": is_text, "cores": is_natural, "machine": is_text}


def read_run(path):
    """What run.json says; `commit` may be null, `interrupted` and `engines` may be left out."""
    try:
        run = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise DataError(f"{path}: {error.strerror}") from None
    except ValueError as error:
        raise DataError(f"{path}: is not JSON: {error}") from None
    if not isinstance(run, dict):
        raise DataError(f"{path}: is not an object")
    for name, kind in RUN.items():
        if name not in run:
            raise DataError(f"{path}: {name} is missing")
        if not kind(run[name]):
            raise DataError(f"{path}: {name} cannot be {json.dumps(run[name])}")
    if not (run.get("commit") is None or is_text(run["commit"])):
        raise DataError(f"{path}: commit cannot be {json.dumps(run['commit'])}")
    if "engines" in run and not is_texts(run["engines"]):
        raise DataError(f"{path}: engines cannot be {json.dumps(run['engines'])}")
    return run


class Study:
    """A study that was run: its folder, and what run.json says of it."""

    def __init__(self, folder):
        self.folder = folder
        self.run = read_run(folder / "run.json")
        self.kept = {}  # what was read; the sentences of a chapter ask for the same again and again

    def rows(self, name, **columns):
        """As of `read_csv`; not to be changed."""
        key = name, *columns.items()
        if key not in self.kept:
            self.kept[key] = read_csv(self.folder / name, **columns)
        return self.kept[key]

    @property
    def complete(self):
        return not self.run.get("interrupted", False)


def study_in(folder):
    """None where none was run: an interrupted or killed one leaves no run.json, or one that says so."""
    return Study(folder) if (folder / "run.json").exists() else None
