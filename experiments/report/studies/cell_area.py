# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone cell area`: where the cell's storage may stand."""
from looks import BLACK, BLUE, GREEN, ORANGE, PURPLE, RED
from page import count, smaller
from results import finite
from studies import CELL, OUTPUT, Run
from style import GREY, plt, rows_of, save
from thesis.cell import turned

RUN = Run(16, "where the storage of the cell may stand", full=[["cell", "area", CELL, "--output", OUTPUT]],
          tiny=["cell", "area", CELL, "--angle-step", "90", "--length-step", "500", "--no-pictures"])
TITLE = "Where the storage of the cell may stand"
OUTCOMES_TOLD = {"completed": "the whole process runs", "in-the-way": "something is in the way", "no-contact": "the sphere touches nothing",
                 "beyond-limits": "a joint is at its limit", "out-of-reach": "out of reach",
                 "not-held": "the part is not between the fingers", "misplaced": "the part would not arrive in its place"}
MAPS = {"plan": "angles and radii, at the height of the storage", "heights": "heights and radii, at its angle"}


def told(study):
    rows = {name: study.rows(f"{name}.csv", angle_deg=finite, radius=finite, height=finite, outcome=str) for name in MAPS}

    def map_of(name, about):
        outcomes = [row["outcome"] for row in rows[name]]
        return {"path": smaller(study.folder, f"cell-area-{name}"), "about": about, "places": len(outcomes),
                "outcomes": [f"{words}: {count(outcomes.count(outcome))}" for outcome, words in OUTCOMES_TOLD.items() if outcome in outcomes]}

    return {"completed": sum(row["outcome"] == "completed" for row in rows["plan"]), "places": len(rows["plan"]),
            "maps": [each for each in (map_of(*item) for item in MAPS.items()) if each["path"]]}


OUTCOMES = {"completed": ("the whole process runs", GREEN, "o", 14),
            "in-the-way": ("arm, gripper or part come upon something", RED, "s", 5),
            "misplaced": ("the part would not arrive in its place", GREY, "d", 6),
            "not-held": ("the part is not between the fingers", BLACK, "v", 6),
            "no-contact": ("the sphere does not touch the material", PURPLE, "x", 8),
            "beyond-limits": ("a joint is at its limit", ORANGE, "^", 8),
            "out-of-reach": ("out of reach", "#bbbbbb", ".", 3)}


def scatter(axes, rows, place):
    for outcome, (label, color, marker, size) in OUTCOMES.items():
        points = [place(row) for row in rows if row["outcome"] == outcome]
        if points:
            axes.scatter(*zip(*points), s=size, color=color, marker=marker, linewidths=0.8, label=f"{label} ({len(points)})")


def here(axes, storage, machine, place):
    for station, label, marker, color in ((storage, "storage of the cell file", "*", BLUE), (machine, "machine", "D", BLACK)):
        axes.plot(*place(station), marker=marker, color=color, markeredgecolor="white", markersize=11, linestyle="",
                  label=label)


def plan(folder, stations):
    rows = rows_of(folder / "plan.csv")

    def place(row):
        home = float(row["home_deg"] if "home_deg" in row else stations["storage"]["home_deg"])
        return turned(home + float(row["angle_deg"]), float(row["radius"]), 0)

    figure, axes = plt.subplots(figsize=(8.5, 8), layout="constrained")
    scatter(axes, rows, place)
    here(axes, stations["storage"], stations["machine"], place)
    axes.plot(0, 0, marker="+", color=BLACK, markersize=10)
    axes.annotate("base", (0, 0), textcoords="offset points", xytext=(7, 5))
    axes.set(aspect="equal", xlabel="from the base's axis, in the direction of the arm at home (cell's unit of length)",
             ylabel="to its left (cell's unit of length)",
             title=f"Where the storage may stand, at height {float(stations['storage']['height']):g}")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.08), fontsize=8, ncols=3)
    save(figure, folder, "cell-area-plan")


def heights(folder, stations):
    rows = rows_of(folder / "heights.csv")
    figure, axes = plt.subplots(figsize=(7.5, 7), layout="constrained")
    scatter(axes, rows, lambda row: (float(row["radius"]), float(row["height"])))
    storage = stations["storage"]
    axes.plot(float(storage["radius"]), float(storage["height"]), marker="*", color=BLUE, markeredgecolor="white",
              markersize=11, linestyle="", label="storage of the cell file")
    axes.set(aspect="equal", xlabel="from the base's axis (cell's unit of length)",
             ylabel="above the floor (cell's unit of length)",
             title=f"Which heights the storage may have, at {float(storage['angle_deg']):+g} degrees")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), fontsize=8, ncols=2)
    save(figure, folder, "cell-area-heights")


def main(folder):
    stations = {row["station"]: row for row in rows_of(folder / "stations.csv")}
    plan(folder, stations)
    heights(folder, stations)
