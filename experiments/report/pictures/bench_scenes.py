# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of `touchstone bench-scenes`, of queries.csv and builds.csv.

Same data, same bytes: nothing here depends on the time or on chance."""
import csv

from names import BALLS, QUESTIONS
from looks import LIBRARIES
from pictures.style import plt, save

# The ticks that are drawn as numbers.
BYTES = [20, 50, 100, 200, 500, 1000]
MICROSECONDS = [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10]


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def distinct(rows, name):
    return list(dict.fromkeys(row[name] for row in rows))


def looks(library):
    look = LIBRARIES[library]
    return {"color": look.colour, "linestyle": look.line, "marker": look.marker, "markersize": 4, "linewidth": 1.2, "label": library}


def draw_lines(axes, rows, value):
    """One line a library, from small to large scenes."""
    for library in distinct(rows, "library"):
        spots = sorted((int(row["triangles"]), value(row)) for row in rows if row["library"] == library)
        axes.plot(*zip(*spots), **looks(library))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.minorticks_off()
    axes.grid(color="#dddddd", linewidth=0.5)


def draw_queries(rows, scene, folder):
    balls, questions = distinct(rows, "balls"), distinct(rows, "question")
    figure, grid = plt.subplots(len(balls), len(questions), figsize=(3.1 * len(questions) + 0.5, 2.5 * len(balls) + 0.8),
                                sharex=True, sharey=True, squeeze=False, layout="constrained")
    handles = []
    for i, ball in enumerate(balls):
        for j, question in enumerate(questions):
            axes = grid[i][j]
            chosen = [row for row in rows if row["balls"] == ball and row["question"] == question]
            if not chosen:
                axes.set_axis_off()
                continue
            draw_lines(axes, chosen, lambda row: float(row["nanoseconds"]) / 1000)
            axes.set_title(f"{BALLS[ball]}: {QUESTIONS[question]}")
            lowest = not any(row["question"] == question and balls.index(row["balls"]) > i for row in rows)
            axes.xaxis.set_tick_params(labelbottom=lowest)
            if lowest:
                axes.set_xlabel("triangles")
            if j == 0:
                axes.set_ylabel("a query, microseconds")
            handles = max(handles, axes.get_legend_handles_labels()[0], key=len)
    place = next((axes for axes in grid.flat if not axes.axison), None)
    if place is None:  # a run that was interrupted
        grid[0][0].legend(handles=handles, fontsize=6)
    else:
        place.legend(handles=handles, loc="center", frameon=False)
    figure.suptitle(f"{scene}: time of a query against the size of the scene", fontsize=10)
    save(figure, folder, f"queries-{scene}")


def draw_builds(rows, folder):
    scenes = distinct(rows, "scene")
    figure, grid = plt.subplots(len(scenes), 3, figsize=(9, 2.6 * len(scenes) + 0.3), squeeze=False,
                                layout="constrained", gridspec_kw={"width_ratios": [3, 3, 1.6]})
    for axes, scene in zip(grid, scenes):
        chosen = [row for row in rows if row["scene"] == scene]
        draw_lines(axes[0], chosen, lambda row: 1e6 * float(row["seconds"]) / float(row["triangles"]))
        draw_lines(axes[1], chosen, lambda row: float(row["bytes_a_triangle"]))
        for one, name in zip(axes, ("build, microseconds a triangle", "memory, bytes a triangle")):
            one.set_title(f"{scene}: {name.split(',')[0]}")
            one.set_xlabel("triangles")
            one.set_ylabel(name)
        axes[0].set_yticks(MICROSECONDS, MICROSECONDS)
        axes[1].set_yticks(BYTES, BYTES)
        axes[2].set_axis_off()
    grid[0][2].legend(handles=grid[0][0].get_legend_handles_labels()[0], loc="center left", frameon=False)
    save(figure, folder, "builds")


def main(folder):
    queries, builds = read(folder / "queries.csv"), read(folder / "builds.csv")
    for scene in distinct(queries, "scene"):
        draw_queries([row for row in queries if row["scene"] == scene], scene, folder)
    if builds:
        draw_builds(builds, folder)
