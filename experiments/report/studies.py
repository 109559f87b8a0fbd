# SPDX-License-Identifier: GPL-3.0-or-later
"""What ./reproduce runs, in its order: the studies, their folders in the results and how each is called."""
import dataclasses
import shlex

CELL = "experiments/thesis/cell/cells/aristo.json"
MESHES = "MESHES"  # stands for all mesh files in cache/meshes
OUTPUT = "OUTPUT"  # stands for the study's folder
DRIVE = "--drive"  # a method drives the robot, perhaps into the vice: exit status 1


@dataclasses.dataclass(frozen=True)
class Study:
    name: str  # of its folder in the results
    about: str
    full: list  # calls of the program, each a list of arguments
    quick: list | None = None  # None: with --full alone, or for the paper
    paper: list | None = None  # what the paper needs of it, if that is more than the quick calls
    resumes: bool = False  # continues after an interruption, with --resume

    @property
    def needs_meshes(self):
        return any(MESHES in call for call in self.full)

    def calls(self, mode):
        return {"quick": self.quick, "paper": self.paper or self.quick, "full": self.full}[mode]


def same(*calls):
    return {"full": list(calls), "quick": list(calls)}


KERNELS = "exact,filtered,fast,fast-float,fast-long-double,fast-double-double,cgal-double,cgal-epick"
THESIS = "thesis,thesis-float,thesis-signed,thesis-newell,thesis-closed"
NEAR_EDGE = ["near-edge", "--methods", "filtered,fast,fast-float,thesis,thesis-signed"]

SEEDS = range(2, 7)  # the others have 1


def of_seed(seed, *samples):
    """The rates of near-edge with another seed. The folder of the first one also has the study's run.json."""
    folder = OUTPUT if seed == SEEDS[0] else f"{OUTPUT}/seed-{seed}"
    return [*NEAR_EDGE, *samples, "--search", "0", "--no-maps", "--no-pictures", "--seed", str(seed), "--output", folder]


QUICK_BENCH = "random-triangles,half-near,lattice-tangent,slivers,far,extreme,nearness,polygons-128"

STUDIES = [
    Study("meshes", "every face of real meshes", resumes=True,
          **same(["meshes", MESHES, "--skip-bad", "--methods", f"{KERNELS},{THESIS}", "--output", OUTPUT])),
    Study("cell", "the manufacturing cell",
          **same(["cell", "run", CELL, "--output", OUTPUT], ["cell", "export", CELL, f"{OUTPUT}/cell.html"],
                 *(["cell", "run", CELL, "--preset", f"case {n}", "--every-face", "--output", f"{OUTPUT}/case-{n}"] for n in (1, 2)),
                 ["cell", "run", CELL, "--preset", "U-part", "--output", f"{OUTPUT}/u-part"],
                 ["cell", "run", CELL, "--preset", "U-part", DRIVE, "thesis", "--output", f"{OUTPUT}/driven"])),
    Study("thesis", "the thesis's figures",
          full=[["thesis", "--output", OUTPUT]], quick=[["thesis", "--quick", "--output", OUTPUT]]),
    Study("regress", "third-party engines", **same(["regress", "--output", OUTPUT])),
    Study("near-edge", "random polygons, double by double", resumes=True,
          full=[[*NEAR_EDGE, "--output", OUTPUT]],
          quick=[[*NEAR_EDGE, "--samples", "60", "--search", "8", "--output", OUTPUT]]),
    Study("stability", "polygons under stress", resumes=True,
          full=[["stability", "--output", OUTPUT]], quick=[["stability", "--samples", "12", "--output", OUTPUT]]),
    Study("tradeoff", "run time against error", resumes=True,
          full=[["tradeoff", "--output", OUTPUT]],
          quick=[["tradeoff", "--samples", "12", "--queries", "300", "--repetitions", "11", "--output", OUTPUT]]),
    Study("soak", "the certified path under attack", resumes=True,
          full=[["soak", "--output", OUTPUT]], quick=[["soak", "--samples", "100000", "--output", OUTPUT]]),
    Study("motions", "moving balls near their thresholds", resumes=True,
          full=[["motions", "--output", OUTPUT]], quick=[["motions", "--samples", "8", "--output", OUTPUT]]),
    Study("tunnelling", "what steps miss", resumes=True,
          full=[["tunnelling", "--output", OUTPUT]], quick=[["tunnelling", "--samples", "2000", "--output", OUTPUT]]),
    Study("soak-moving", "the certified path under attack by moving balls", resumes=True,
          full=[["soak", "--moving", "--output", OUTPUT]], quick=[["soak", "--moving", "--samples", "20000", "--output", OUTPUT]]),
    Study("cell-area", "where the storage of the cell may stand", full=[["cell", "area", CELL, "--output", OUTPUT]]),
    Study("merging", "coplanar faces as polygons", resumes=True, full=[["merging", MESHES, "--skip-bad", "--output", OUTPUT]]),
    Study("seeds", "random polygons, with other seeds", resumes=True, full=[of_seed(seed) for seed in SEEDS],
          paper=[of_seed(seed, "--samples", "60") for seed in SEEDS]),
    Study("recorded", "questions of a third-party simulation", resumes=True,
          full=[["recorded", "--output", OUTPUT]], paper=[["recorded", "--samples", "40", "--output", OUTPUT]]),
    Study("bench", "what certainty costs",
          full=[["bench", "--output", OUTPUT]], quick=[["bench", "--family", QUICK_BENCH, "--output", OUTPUT]],
          paper=[["bench", "--repetitions", "7", "--output", OUTPUT]]),
    Study("bench-scenes", "whole scenes beside five libraries",
          full=[["bench-scenes", "--meshes", "cache/meshes", "--output", OUTPUT]],
          paper=[["bench-scenes", "--max-faces", "100000", "--repetitions", "7", "--output", OUTPUT]]),
]


def by_name(name):
    return next(study for study in STUDIES if study.name == name)


def shown(call, folder):
    """As one would type it."""
    return " ".join(["touchstone", *("$(find cache/meshes -type f | sort)" if word == MESHES else shlex.quote(word.replace(OUTPUT, folder)) for word in call)])
