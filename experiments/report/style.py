# SPDX-License-Identifier: GPL-3.0-or-later
"""How all pictures look, and what is common to those of several studies. Same data, same bytes: nothing here depends on the time or on chance."""
import csv
import functools
import multiprocessing
import os

import matplotlib

from replacing import replacing

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from looks import BLACK, BLUE, GREEN, ORANGE, PURPLE, RED, SKY, look_of

plt.rcParams.update({"svg.hashsalt": "touchstone", "font.size": 9, "axes.titlesize": 9, "axes.spines.top": False,
                     "axes.spines.right": False})

GREY = "#999999"  # of what is no method's
# Of curves that are no methods'; line and marker tell them apart without colour.
STYLES = [(BLUE, "-", "o"), (ORANGE, "--", "s"), (RED, "-", "^"), (BLACK, ":", "v"), (GREEN, "-.", "D"), (PURPLE, "--", "P"), (SKY, "-", "X"), (GREY, "-.", "*")]


def rows_of(path):
    """Of a CSV file; cells are text."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def curve(axes, method, x, y, low=None, high=None, shade=0.15, marker=True, **more):
    """A method's line, with a band from `low` to `high`."""
    look = look_of(method)
    if low is not None:
        axes.fill_between(x, low, high, color=look.colour, alpha=shade, linewidth=0)
    return axes.plot(x, y, color=look.colour, linestyle=look.line, marker=look.marker if marker else None, **{"label": method, "linewidth": 1.2} | more)


def whiskers(axes, x, y, low, high, **more):
    """A line with a bar from `low` to `high` at each point."""
    axes.errorbar(x, y, yerr=[[b - a for a, b in zip(low, y)], [b - a for a, b in zip(y, high)]], markersize=4, capsize=2, **more)


def on_white(pad, alpha=None):
    """The box of words that stand before lines."""
    return {"boxstyle": f"round,pad={pad}", "facecolor": "white", "edgecolor": "none", "alpha": alpha}


def picture(width, height, rows=1, columns=1, frame=True, margins=None, **more):
    """Of a function that draws on axes, its first argument, one that returns the figure. Without a `frame` the drawing fills it.
    `margins`: as of `subplots_adjust`; None: as wide as labels need."""
    def of(draw_on):
        @functools.wraps(draw_on)
        def drawn(*arguments, **options):
            figure, axes = plt.subplots(rows, columns, figsize=(width, height), **more)
            draw_on(axes, *arguments, **options)
            if not frame:
                axes.axis("off")
                figure.subplots_adjust(0, 0, 1, 1)
            elif margins:
                figure.subplots_adjust(*margins)
            else:
                figure.tight_layout()
            return figure

        return drawn

    return of


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
