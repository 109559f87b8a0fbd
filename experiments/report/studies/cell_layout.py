# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of `touchstone cell layout`: the family of layouts and the one that is chosen.

Same data, same bytes: nothing here depends on the time or on chance."""
import math

import numpy as np

from looks import BLACK, BLUE, GREEN, ORANGE, PURPLE, RED
from style import on_white, plt, rows_of, save
from thesis.cell import turned

CASES = {"1": (BLUE, "case 1: storage at +1°"), "2": (ORANGE, "case 2: storage at −33°")}
STORAGE_ANGLES = {"1": 1, "2": -33}
COUPLINGS = {"keeps-elevation": "forearm keeps its elevation while the shoulder turns",
             "serial": "forearm turns with the upper arm"}


def number(row, name):
    return float(row[name]) if row[name] else math.nan


def branches(rows):
    """Runs of lines whose leans follow each other, at most six times as steep as the step between their elevations."""
    elevations = sorted({number(row, "elevation_deg") for row in rows})
    step = min((high - low for low, high in zip(elevations, elevations[1:])), default=1)
    runs = []
    for row in rows:
        for run in runs:
            if abs(number(run[-1], "lean_deg") - number(row, "lean_deg")) < 6 * step and \
                    number(row, "elevation_deg") - number(run[-1], "elevation_deg") == step:
                run.append(row)
                break
        else:
            runs.append([row])
    return runs


def family_map(axes, grid, line, coupling, choice):
    """By how much the storage's height must differ between the cases, for every home pose."""
    rows = [row for row in grid if row["coupling"] == coupling and row["hand"] == choice["hand"]]
    leans = sorted({number(row, "lean_deg") for row in rows})
    elevations = sorted({number(row, "elevation_deg") for row in rows})
    values = np.full((len(elevations), len(leans)), math.nan)
    for row in rows:
        if row["captions_come_out"] == "yes":
            values[elevations.index(number(row, "elevation_deg")), leans.index(number(row, "lean_deg"))] = \
                number(row, "storage_height_2_mm") - number(row, "storage_height_1_mm")
    image = axes.pcolormesh(leans, elevations, values, cmap="PuOr", vmin=-200, vmax=200, shading="nearest", rasterized=True)
    come_out = [row for row in line if (row["coupling"], row["hand"], row["captions_come_out"]) == (coupling, choice["hand"], "yes")]
    for i, run in enumerate(branches(come_out)):
        axes.plot([number(row, "lean_deg") for row in run], [number(row, "elevation_deg") for row in run], color=BLACK,
                  linewidth=1.5, label="one height of the storage" if i == 0 else None)
    axes.plot(0, 0, marker="s", color="white", markeredgecolor=BLACK, markersize=6, linestyle="",
              label="home of the arm's table")
    if coupling == choice["coupling"]:
        axes.plot(choice["home lean of the upper arm"], choice["home elevation of the forearm"], marker="*", color=RED,
                  markeredgecolor=BLACK, markersize=12, linestyle="", label="chosen")
    axes.set(facecolor="#dddddd", title=COUPLINGS[coupling], xlabel="home lean of the upper arm (degrees)",
             ylabel="home elevation of the forearm (degrees)", xlim=(-62.5, 62.5), ylim=(-62.5, 62.5))
    axes.legend(loc="lower left", fontsize=7, framealpha=0.9)
    return image


def radii(axes, line, coupling, choice):
    """Where storage and machine stand along the line of one height."""
    rows = [row for row in line if (row["coupling"], row["hand"], row["captions_come_out"]) == (coupling, choice["hand"], "yes")]
    for j, run in enumerate(branches(rows)):
        for name, label, color, style in (("storage_radius_1_mm", "storage, case 1", BLUE, "-"),
                                          ("storage_radius_2_mm", "storage, case 2", ORANGE, "--"),
                                          ("machine_radius_mm", "machine", GREEN, "-.")):
            axes.plot([number(row, "elevation_deg") for row in run], [number(row, name) for row in run], color=color,
                      linestyle=style, label=label if j == 0 else None)
    if coupling == choice["coupling"]:
        axes.axvline(choice["home elevation of the forearm"], color=RED, linewidth=1, label="chosen")
    axes.set(ylim=(0, 750), xlim=(-62.5, 62.5), title="one height of the storage: distances from the base's axis",
             xlabel="home elevation of the forearm (degrees)", ylabel="mm")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7, ncols=2)


def family(folder, choice):
    grid, line = rows_of(folder / "family.csv"), rows_of(folder / "one_height.csv")
    figure, axes = plt.subplots(2, 2, figsize=(11, 9), layout="constrained")
    for i, coupling in enumerate(COUPLINGS):
        image = family_map(axes[0, i], grid, line, coupling, choice)
        radii(axes[1, i], line, coupling, choice)
    figure.colorbar(image, ax=axes[0, :], label="storage height, case 2 less case 1 (mm)", extend="both")
    figure.suptitle("Home poses that reproduce the captioned angles of both cases (grey: no such layout), "
                    f"the hand {choice['hand']}\n"
                    "home pose, coupling, storage and machine are chosen: no public source gives them", fontsize=10)
    save(figure, folder, "cell-layout-family")


def side_view(axes, poses, choice):
    """The arm in its plane when the sphere touches, and the material that it touches."""
    side, height = choice["material side"], choice["storage height"]
    stands = [(choice["storage radius in case 1"], height, BLUE), (choice["storage radius in case 2"], height, ORANGE),
              (choice["machine radius"], choice["machine height"], GREEN)]
    for radius, low, color in stands:
        left, right = radius - side / 2, radius + side / 2
        axes.fill((left, right, right, left), (low, low, low + side, low + side), facecolor=color, alpha=0.35, edgecolor=color)
    drawn = [("1", "home", "#999999", ":", "home"), ("1", "storage", BLUE, "-", "case 1 touches in storage"),
             ("2", "storage", ORANGE, "--", "case 2 touches in storage"),
             ("2", "machine", GREEN, "-.", "both touch at the machine")]
    for case, moment, color, style, label in drawn:
        points = [(number(p, "out_mm"), number(p, "up_mm")) for p in poses if p["case"] == case and p["moment"] == moment]
        axes.plot(*zip((0, 0), *points), color=color, linestyle=style, marker="o", markersize=3, label=label)
        axes.add_patch(plt.Circle(points[-1], choice["sphere radius"], color=color))
    axes.set(aspect="equal", xlabel="from the base's axis (mm)", ylabel="above the floor (mm)",
             title="the arm, each pose in its own plane")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7, loc="lower center")


def plan_view(axes, choice):
    """From above: home, storage, machine and the base's turns."""
    side, gap = choice["material side"], choice["gap between station axis and material"]

    axes.plot(0, 0, marker="o", color=BLACK)
    axes.annotate("", turned(0, 420, 0), (0, 0), arrowprops={"arrowstyle": "->", "color": "#999999"})
    axes.annotate("home", turned(0, 430, 0), va="center")
    stands = [(-150 + STORAGE_ANGLES[c], choice[f"storage radius in case {c}"], -gap - side / 2, CASES[c][0],
               f"storage, case {c}") for c in CASES]
    stands.append((-83, choice["machine radius"], -gap - side / 2, GREEN, "machine"))
    for azimuth, radius, across, color, label in stands:
        corners = [turned(azimuth, radius + dx * side / 2, across + dy * side / 2) for dx, dy in
                   ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        axes.fill(*zip(*corners), facecolor=color, alpha=0.5, edgecolor=color)
        axes.plot(*zip((0, 0), turned(azimuth, radius, 0)), color=color, linewidth=0.8, linestyle=":")
        axes.annotate(label, turned(azimuth, radius, across - side / 2 - 65), ha="center", va="center", color=color)
    for radius, begin, end, text, color in ((170, 0, -149, "149°", BLUE), (230, -149, -83, "66°", BLUE),
                                            (290, 0, -183, "183°", ORANGE), (350, -183, -83, "100°", ORANGE)):
        degrees = np.linspace(begin, end, 100)
        axes.plot(radius * np.cos(np.radians(degrees)), radius * np.sin(np.radians(degrees)), color=color, linewidth=1)
        axes.annotate("", turned(degrees[-1], radius, 0), turned(degrees[-5], radius, 0), arrowprops={"arrowstyle": "->", "color": color})
        middle = turned(begin + (0.3 if begin == 0 else 0.75) * (end - begin), radius, 0)
        axes.annotate(text, middle, ha="center", va="center", color=color, bbox=on_white(0.1))
    axes.set(aspect="equal", xlim=(-760, 540), ylim=(-720, 220), xlabel="mm", ylabel="mm",
             title="from above: turns of the base")
    axes.grid(alpha=0.3)


def flips(axes, moves):
    """Where the exact angle of each move lies between two whole degrees."""
    rows = [row for row in moves if row["until"] != "facing"]
    places = list(range(len(rows), 0, -1))
    for place, row in zip(places, rows):
        degrees, exact = abs(number(row, "degrees")), abs(number(row, "exact_deg"))
        offset = exact - degrees
        planned = row["until"] == "planned"
        low, high = (-0.5, 0.5) if planned else (-1, 0)
        color = CASES[row["case"]][0]
        axes.plot([low, high], [place, place], color=color, linewidth=5, alpha=0.25, solid_capstyle="butt")
        axes.plot(offset, place, marker="o" if planned else "D", color=color, markersize=5)
    axes.set_yticks(places, [f"case {row['case']}: {row['caption'].split(';')[0].replace('not captioned (11 derived)', 'shoulder up 11 (derived)')}"
                             for row in rows])
    axes.set(xlim=(-1.1, 0.6), xlabel="exact angle less the captioned one (degrees)",
             title="how far from flipping: dots by inverse kinematics (rounded),\ndiamonds by contact or clearance (next whole step)")
    axes.grid(axis="x", alpha=0.3)


def tolerances(axes, choices):
    """How far each chosen value can be changed alone."""
    rows = [row for row in choices if row["lowest"]]
    places = list(range(len(rows), 0, -1))
    for place, row in zip(places, rows):
        value = number(row, "value")
        axes.plot([number(row, "lowest") - value, number(row, "highest") - value], [place, place], color=PURPLE,
                  linewidth=5, alpha=0.6, solid_capstyle="butt")
    axes.axvline(0, color=BLACK, linewidth=0.8)
    axes.set_yticks(places, [f"{row['name']}: {number(row, 'value'):g} {row['unit'].replace('deg', '°')}" for row in rows])
    axes.set(xlabel="change that keeps every caption (mm or degrees)", title="chosen values, each changed alone")
    axes.grid(axis="x", alpha=0.3)


def main(folder):
    choices = rows_of(folder / "choice.csv")
    choice = {row["name"]: number(row, "value") if row["unit"] else row["value"] for row in choices}
    family(folder, choice)
    figure = plt.figure(figsize=(13, 10), layout="constrained")
    views, bars = figure.subfigures(2, 1, height_ratios=(1.3, 1))
    side, plan = views.subplots(1, 2, width_ratios=(1, 1.35))
    side_view(side, rows_of(folder / "poses.csv"), choice)
    plan_view(plan, choice)
    left, right = bars.subplots(1, 2)
    flips(left, rows_of(folder / "moves.csv"))
    tolerances(right, choices)
    figure.suptitle("The chosen layout reproduces both case studies as captioned. Lengths of the arm: a public table; "
                    "everything else is chosen", fontsize=10)
    save(figure, folder, "cell-layout")
