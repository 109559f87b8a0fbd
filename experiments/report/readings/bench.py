# SPDX-License-Identifier: GPL-3.0-or-later
"""What `touchstone bench` measured: bench.json, contestants by name."""
import json
import re

from results import DataError

TRIANGLES = {  # family of balls and triangles: in words
    "random-triangles": "random triangles, balls anywhere", "half-near": "half of the balls at 2⁻⁵⁰ from contact",
    "lattice-tangent": "exactly tangent, on lattices", "slivers": "slivers of aspect 10⁻⁸",
    "far": "10⁶ sizes from the origin", "extreme": "extreme exponents"}


SETS = {  # of one ball and many triangles, of the family batches: in words
    "one ball, 1024 triangles": "triangles anywhere", "one ball, 1024 triangles, all near its surface": "all near the ball’s surface"}
SET, WITHOUT_FLOATS = "filtered, set", "filtered, no floats"

STAGE_COLOURS = {"double": "#9fd8c4", "permanent": "#4cb391", "double-double": "#00795a", "fixed-integer": "#7a5195", "unlimited": "#ef5675"}


def read(study):
    """Each contest as bench.json has it, but its contestants by name."""
    path = study.folder / "bench.json"
    try:
        return [contest | {"contestants": {c["name"]: c for c in contest["contestants"]}}
                for contest in json.loads(path.read_text(encoding="utf-8"))["contests"]]
    except OSError as error:
        raise DataError(f"{path}: {error.strerror}") from None
    except (ValueError, KeyError, TypeError) as error:
        raise DataError(f"{path}: {type(error).__name__}: {error}") from None


def contests(study):
    """By (family, name): the contestants by name."""
    found = {(contest["family"], contest["name"]): contest["contestants"] for contest in read(study)}
    if missing := [family for family in TRIANGLES if (family, "") not in found]:
        raise DataError(f"{study.folder / 'bench.json'}: no contest {', '.join(missing)}")
    return found


def named(study, family):
    """The contests of a family, by name."""
    return {contest["name"]: contest for contest in read(study) if contest["family"] == family}


def sets(study):
    """Contestants of each kind of set, by its name; without those of a run that left sets out."""
    return {name: contest["contestants"] for name, contest in named(study, "batches").items() if name in SETS}


def polygons(all_contests):
    """By vertices: the contestants over all outlines together."""
    found = {}
    for (family, name), contestants in all_contests.items():
        if (size := re.fullmatch(r"polygons-(\d+)", family)) and name == "all outlines":
            found[int(size[1])] = contestants
    return dict(sorted(found.items()))
