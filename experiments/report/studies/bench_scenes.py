# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole scenes beside other libraries."""
from looks import LIBRARIES
from noise import TOO_NOISY, is_steady
from page import count, escaped, multiple, percent, rounded, smaller
from results import distinct, finite, maybe, natural
from studies import OUTPUT, Run
from style import STYLES, plt, rows_of, save

RUN = Run(13, "whole scenes beside five libraries", full=[["bench-scenes", "--meshes", "cache/meshes", "--output", OUTPUT]],
          paper=[["bench-scenes", "--max-faces", "100000", "--repetitions", "7", "--output", OUTPUT]],
          tiny=["bench-scenes", "--max-faces", "1000", "--samples", "10", "--repetitions", "1", "--no-pictures"])
TITLE = "Whole scenes"

QUESTIONS = {"any": "touches any?", "all": "touches which?", "nearest": "nearest?"}
BALLS = {"near": "near the surface", "anywhere": "anywhere", "touching": "just touching"}


OURS = "Scene"


def are_steady(*rows):
    """Whether the times of these may be quoted, and their ratios."""
    return all(is_steady(row["lower_quartile"], row["upper_quartile"]) for row in rows)


class Data:
    def __init__(self, study):
        self.queries = study.rows("queries.csv", scene=str, triangles=natural, balls=str, question=str, library=str, nanoseconds=finite,
                                  lower_quartile=finite, upper_quartile=finite, wrong=natural, checked=natural)
        self.builds = study.rows("builds.csv", scene=str, triangles=natural, library=str, seconds=finite, bytes_a_triangle=finite)
        self.motions = study.rows("motions.csv", scene=str, triangles=natural, motions=str, library=str, nanoseconds=finite, lower_quartile=finite,
                                  upper_quartile=finite, wrong=maybe(natural),
                                  checked=maybe(natural))
        self.libraries = distinct(self.queries, "library")
        self.scenes = distinct(self.queries, "scene")

    def largest(self, scene):
        return max(row["triangles"] for row in self.queries if row["scene"] == scene)

    def wrong(self, library):
        rows = [row for row in [*self.queries, *self.motions] if row["library"] == library]
        return sum(row["wrong"] for row in rows), sum(row["checked"] for row in rows)


LENGTHS = {"short": "ways of one radius", "long": "ways of thirty radii"}


def microseconds(row):
    return f"{rounded(row['nanoseconds'] / 1000)} µs" if are_steady(row) else TOO_NOISY


def motion_rows(data, scene):
    """First contacts of moving balls, beside the same balls at rest at the start of their ways."""
    rows = [row for row in data.motions if row["scene"] == scene]
    ours = {(row["triangles"], row["motions"]): row for row in rows if row["library"] == OURS}
    for row in sorted(rows, key=lambda row: list(ours).index((row["triangles"], row["motions"]))):
        beside = ours[row["triangles"], row["motions"]]
        yield [f"{LENGTHS.get(row['motions'], row['motions'])}, {count(row['triangles'])} triangles", escaped(row["library"]), microseconds(row),
               "" if row is beside or not are_steady(row, beside) else multiple(row["nanoseconds"] / beside["nanoseconds"]),
               "" if row["wrong"] is None else f"{count(row['wrong'])} of {count(row['checked'])}"]


def query_cell(row, ours):
    """Of a library that was asked, beside ours."""
    if row is None:
        return "not asked"
    return (microseconds(row) + (f"<br><small>{multiple(row['nanoseconds'] / ours['nanoseconds'])}</small>" if ours not in (None, row) and are_steady(row, ours) else "")
            + (f"<br><small class=\"no\">{percent(row['wrong'] / row['checked'])} wrong</small>" if row["wrong"] else ""))


def growth(data, scene, small, size):
    """How many times the least time the largest scene takes."""
    for library in data.libraries:
        times = {row["triangles"]: row["nanoseconds"] for row in data.queries if are_steady(row) and
                 (row["scene"], row["library"], row["balls"], row["question"]) == (scene, library, "near", "any")}
        if small in times and size in times and small < size:
            yield f"{escaped(library)} {multiple(times[size] / times[small])}"


def scene_told(study, data, scene):
    size, small = data.largest(scene), min(row["triangles"] for row in data.queries if row["scene"] == scene)
    at = {(row["library"], row["balls"], row["question"]): row for row in data.queries if (row["scene"], row["triangles"]) == (scene, size)}
    questions = list(dict.fromkeys(key[1:] for key in at))
    return {"name": scene, "size": size, "small": small, "path": smaller(study.folder, f"queries-{scene}"), "batches": smaller(study.folder, f"batches-{scene}"),
            "growth": list(growth(data, scene, small, size)),
            "heads": ["library", *(f"{BALLS.get(balls, balls)}: {QUESTIONS.get(question, question)}" for balls, question in questions)],
            "queries": [[escaped(library), *(query_cell(at.get((library, *q)), at.get((OURS, *q))) for q in questions)] for library in data.libraries],
            "motions": list(motion_rows(data, scene))}


def told(study):
    data = Data(study)
    wrong = {library: data.wrong(library) for library in data.libraries if library != OURS}
    return {"ours": OURS, "most": max(data.largest(scene) for scene in data.scenes), "ours_wrong": data.wrong(OURS),
            "wrong": [f"{escaped(library)} {percent(failed / checked)}" for library, (failed, checked) in wrong.items() if failed],
            "scenes": [scene_told(study, data, scene) for scene in data.scenes]}


# The ticks that are drawn as numbers.
BYTES = [20, 50, 100, 200, 500, 1000]
MICROSECONDS = [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10]


def looks(library):
    look = LIBRARIES[library]
    return {"color": look.colour, "linestyle": look.line, "marker": look.marker, "markersize": 4, "linewidth": 1.2, "label": library}


def draw_lines(axes, rows, value):
    """One line a library, from small to large scenes."""
    for library in distinct(rows, "library"):
        spots = sorted((int(row["triangles"]), value(row)) for row in rows if row["library"] == library)
        axes.plot(*zip(*spots), **looks(library))
    axes.set(xscale="log", yscale="log")
    axes.minorticks_off()
    axes.grid(color="#dddddd", linewidth=0.5)


def draw_panels(rows, draw, labels, title, handle):
    """A panel for each kind of ball and question, where draw(axes, rows) draws; a legend of what is drawn and of `handle`."""
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
            draw(axes, chosen)
            axes.set_title(f"{BALLS[ball]}: {QUESTIONS[question]}")
            lowest = not any(row["question"] == question and balls.index(row["balls"]) > i for row in rows)
            axes.xaxis.set_tick_params(labelbottom=lowest)
            if lowest:
                axes.set_xlabel(labels[0])
            if j == 0:
                axes.set_ylabel(labels[1])
            handles = max(handles, axes.get_legend_handles_labels()[0], key=len)
    handles = [*handles, *handle]
    place = next((axes for axes in grid.flat if not axes.axison), None)
    if place is None:  # a run that was interrupted
        grid[0][0].legend(handles=handles, fontsize=6)
    else:
        place.legend(handles=handles, loc="center", frameon=False)
    figure.suptitle(title, fontsize=10)
    return figure


def microseconds_of(row):
    return float(row["nanoseconds"]) / 1000


def draw_queries(rows, scene, folder):
    rows = [row for row in rows if row["library"] in LIBRARIES]  # of balls together, only all on one core
    figure = draw_panels(rows, lambda axes, chosen: draw_lines(axes, chosen, microseconds_of), ("triangles", "a query, microseconds"),
                         f"{scene}: time of a query against the size of the scene", [])
    save(figure, folder, f"queries-{scene}")


# By the library that asks about so many balls in one call.
TOGETHER = {OURS: "1", "Scene, 64 together": "64", "Scene, 1024 together": "1024", "Scene, all together": "all"}


def draw_batches(rows, scene, folder):
    """The time of a ball by the number of balls in a call, a line a size of the scene, over that of Embree 3, which takes one."""
    rows = [row for row in rows if row["library"] in (*TOGETHER, "Embree 3")]
    sizes = sorted({int(row["triangles"]) for row in rows})

    def draw(axes, chosen):
        times = {(row["library"], int(row["triangles"])): microseconds_of(row) for row in chosen}
        for size, (colour, _, marker) in zip(sizes, STYLES):
            spots = [(together, times[library, size]) for library, together in TOGETHER.items() if (library, size) in times]
            if spots:
                axes.plot(*zip(*spots), color=colour, marker=marker, markersize=4, linewidth=1.2, label=f"{count(size)} triangles")
            if ("Embree 3", size) in times:
                axes.axhline(times["Embree 3", size], color=colour, linestyle="--", linewidth=0.9)
        axes.set(yscale="log")
        axes.set_yticks(MICROSECONDS, MICROSECONDS)
        axes.minorticks_off()
        axes.grid(color="#dddddd", linewidth=0.5)

    one_by_one = plt.Line2D([], [], color="#555555", linestyle="--", label="Embree 3, one by one")
    save(draw_panels(rows, draw, ("balls in one call", "a ball, microseconds"),
                     f"{scene}: time of a ball against the number of balls in one call, on one core", [one_by_one]), folder, f"batches-{scene}")


def draw_builds(rows, folder):
    scenes = distinct(rows, "scene")
    figure, grid = plt.subplots(len(scenes), 3, figsize=(9, 2.6 * len(scenes) + 0.3), squeeze=False,
                                layout="constrained", gridspec_kw={"width_ratios": [3, 3, 1.6]})
    for axes, scene in zip(grid, scenes):
        chosen = [row for row in rows if row["scene"] == scene]
        draw_lines(axes[0], chosen, lambda row: 1e6 * float(row["seconds"]) / float(row["triangles"]))
        draw_lines(axes[1], chosen, lambda row: float(row["bytes_a_triangle"]))
        for one, name in zip(axes, ("build, microseconds a triangle", "memory, bytes a triangle")):
            one.set(title=f"{scene}: {name.split(',')[0]}", xlabel="triangles", ylabel=name)
        axes[0].set_yticks(MICROSECONDS, MICROSECONDS)
        axes[1].set_yticks(BYTES, BYTES)
        axes[2].set_axis_off()
    grid[0][2].legend(handles=grid[0][0].get_legend_handles_labels()[0], loc="center left", frameon=False)
    save(figure, folder, "builds")


def main(folder):
    queries, builds = rows_of(folder / "queries.csv"), rows_of(folder / "builds.csv")
    for scene in distinct(queries, "scene"):
        rows = [row for row in queries if row["scene"] == scene]
        draw_queries(rows, scene, folder)
        draw_batches(rows, scene, folder)
    if builds:
        draw_builds(builds, folder)
