# SPDX-License-Identifier: GPL-3.0-or-later
"""The studies, one file each: RUN, how ./reproduce runs it; `Data`, what is read of its folder; TITLE, `asked` and `told`, the
chapter that templates/ has in words; `main`, which draws its pictures. A file of pictures alone has neither RUN nor TITLE; a
study whose numbers only the paper tells has no TITLE."""
import dataclasses
import functools
import importlib
import pathlib
import shlex

CELL = "experiments/thesis/cell/cells/aristo.json"
MESHES = "MESHES"  # stands for all mesh files in cache/meshes
OUTPUT = "OUTPUT"  # stands for the study's folder
DRIVE = "--drive"  # a method drives the robot, perhaps into the vice: exit status 1
NEAR_EDGE = ["near-edge", "--methods", "filtered,fast,fast-float,thesis,thesis-signed"]  # also with other seeds


@dataclasses.dataclass(frozen=True)
class Run:
    place: int  # among the studies, in the order of which they are run and told
    about: str
    full: list  # calls of the program, each a list of arguments
    quick: list | None = None  # None: with --full alone, or for the paper
    paper: list | None = None  # what the paper needs of it, if that is more than the quick calls
    first: bool = False  # ./reproduce builds the program first_study for it, and runs it first
    tiny: list | None = None  # a call that takes a moment, without --output, by which tests see what the program writes

    @property
    def needs_meshes(self):
        return any(MESHES in call for call in self.full)

    def calls(self, mode):
        return {"quick": self.quick, "paper": self.paper or self.quick, "full": self.full}[mode]


def same(*calls):
    return {"full": list(calls), "quick": list(calls)}


@functools.cache
def modules():
    """By the names of the studies, which are those of their folders in the results: the files here that have a RUN, in its order."""
    stems = sorted(path.stem for path in pathlib.Path(__file__).parent.glob("[!_]*.py"))
    found = {stem.replace("_", "-"): importlib.import_module(f"studies.{stem}") for stem in stems}
    return dict(sorted(((name, module) for name, module in found.items() if hasattr(module, "RUN")), key=lambda item: item[1].RUN.place))


def chapters():
    """Those that the report tells."""
    return {name: module for name, module in modules().items() if hasattr(module, "TITLE")}


def shown(call, folder):
    """As one would type it."""
    return " ".join(["touchstone", *("$(find cache/meshes -type f | sort)" if word == MESHES else shlex.quote(word.replace(OUTPUT, folder)) for word in call)])
