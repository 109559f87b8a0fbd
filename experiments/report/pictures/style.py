# SPDX-License-Identifier: GPL-3.0-or-later
"""How all pictures look. Same data, same bytes: nothing here depends on the time or on chance."""
import multiprocessing
import os

import matplotlib

from replacing import replacing

matplotlib.use("Agg")
import matplotlib.pyplot as plt

plt.rcParams.update({"svg.hashsalt": "touchstone", "font.size": 9, "axes.titlesize": 9, "axes.spines.top": False,
                     "axes.spines.right": False})

# Okabe and Ito's colours, told apart by all eyes; line and marker tell them apart without colour.
STYLES = [("#0072B2", "-", "o"), ("#E69F00", "--", "s"), ("#D55E00", "-", "^"), ("#000000", ":", "v"),
          ("#009E73", "-.", "D"), ("#CC79A7", "--", "P"), ("#56B4E9", "-", "X"), ("#999999", "-.", "*")]


UNTOLD = {"png": {"Software": None}, "svg": {"Date": None}, "pdf": {"CreationDate": None, "Producer": None}}


def save(figure, folder, name, kinds=("png", "svg")):
    """FOLDER/name.png and .svg (or .pdf), without dates and versions."""
    for kind in kinds:
        with replacing(folder / f"{name}.{kind}") as file:
            figure.savefig(file, format=kind, dpi=150, metadata=UNTOLD[kind])
    plt.close(figure)


_jobs = []  # what the processes of `draw` share


def _draw(i):
    function, *arguments = _jobs[i]
    function(*arguments)


def draw(jobs):
    """Calls each function with its arguments, in as many processes as there are processors; the slow ones should come first."""
    _jobs[:] = jobs
    with multiprocessing.get_context("fork").Pool(min(len(os.sched_getaffinity(0)), 8)) as pool:
        pool.map(_draw, range(len(_jobs)), chunksize=1)
