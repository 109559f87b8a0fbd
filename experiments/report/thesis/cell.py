# SPDX-License-Identifier: GPL-3.0-or-later
"""Views of the manufacturing cell for `touchstone thesis`: in perspective, from above, from the side, close up.

Same data, same bytes: nothing here depends on the time or on chance."""
import itertools
import math

import numpy as np

from looks import BLACK, BLUE, GREEN, ORANGE, PURPLE, RED, SKY
from style import GREY, on_white, picture, plt
from thesis.shaded import Camera, Solid, draw

COLORS = {"link": "#f0c878", "gripper": RED, "finger": ORANGE, "storage": SKY, "machine": "#b9c4b9", "material": PURPLE}
FLOOR = 1150  # mm: half a side of what is drawn of it
STATION_COLORS = {"storage 1": BLUE, "storage 2": ORANGE, "machine": GREEN}


class Cell:
    """What drawing.json and the tables beside it hold."""

    def __init__(self, drawing, sides, stops, moves):
        self.drawing, self.sides, self.stops, self.moves = drawing, sides, stops, moves
        self.moments = drawing["moments"]
        self.solids = [(part, Solid(part["vertices"], part["triangles"], COLORS[part["moves_with"]]))
                       for part in drawing["parts"]]

    def placed(self, moment, virtual=False):
        """All solids where they stand at a moment."""
        now = self.moments[moment]
        result, fingers = [], iter(now["fingers"])
        for part, solid in self.solids:
            carrier = part["moves_with"]
            pose = {"link": lambda: now["links"][part["link"]], "gripper": lambda: now["links"][-1],
                    "finger": lambda: next(fingers),
                    "storage": lambda: now["storage"], "machine": lambda: now["machine"],
                    "material": lambda: now["material"]}[carrier]()
            result.append(solid.moved(pose))
            if carrier == "material" and virtual:
                copy = Solid(part["vertices"], part["triangles"], BLACK, alpha=0)
                result.append(copy.moved(now["virtual_material"]))
        result.append(ball(now["sphere"], now["sphere_radius"]))
        return result


def ball(center, radius, color=BLUE, sides=16):
    """A solid that looks like one."""
    rings = [[(math.cos(u) * math.sin(v), math.sin(u) * math.sin(v), math.cos(v))
              for u in np.linspace(0, 2 * math.pi, sides, endpoint=False)] for v in np.linspace(0, math.pi, sides // 2 + 1)]
    vertices = np.array(rings).reshape(-1, 3) * radius + np.asarray(center)
    triangles = []
    for ring in range(sides // 2):
        for i in range(sides):
            a, b = ring * sides + i, ring * sides + (i + 1) % sides
            triangles += [(a, a + sides, b), (b, a + sides, b + sides)]
    return Solid(vertices, triangles, color)


def floor():
    return Solid([(x * FLOOR, y * FLOOR, 0) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))], [(0, 1, 2), (0, 2, 3)], "#f3f1ea")


def label(axes, at, text, offset=(0, 0)):
    axes.annotate(text, at, xytext=offset, textcoords="offset points", ha="center", va="center", fontsize=8, bbox=on_white(0.2, 0.8))


@picture(6.4, 4.6, frame=False)
def perspective(axes, cell, moment):
    """The whole cell from beyond the storage."""
    camera = Camera((-60, -330, 430), 128, 24, 2300)
    at = draw(axes, [floor()] + cell.placed(moment), camera, aspect=0.72)
    now = cell.moments[moment]
    label(axes, at((0, 0, 0)), "robot", (0, -26))
    label(axes, at((*now["storage"][9:11], 0)), "storage", (0, -16))
    label(axes, at(np.asarray(now["machine"][9:]) + (0, 0, 300)), "machine", (86, 0))


@picture(5.2, 4.4, frame=False)
def close_up(axes, cell, moment, virtual=False):
    """The gripper and what it has come to."""
    now = cell.moments[moment]
    center = np.asarray(now["sphere"])
    outward = math.degrees(math.atan2(center[1], center[0]))
    azimuth = outward + (62 if not virtual else 118)
    at = draw(axes, [floor()] + cell.placed(moment, virtual), Camera(center + (0, 0, 20), azimuth, 16, 330), aspect=0.85)
    axes.annotate("virtual sphere", at(now["sphere"]), xytext=(-105, -58), textcoords="offset points", fontsize=8,
                  arrowprops={"arrowstyle": "->", "color": BLUE}, color=BLUE, bbox=on_white(0.2, 0.85))
    if virtual:
        top = np.asarray(now["virtual_material"][9:]) + (0, 0, 40)
        axes.annotate("virtual material\n(dashed)", at(top), xytext=(70, 40), textcoords="offset points", fontsize=8,
                      arrowprops={"arrowstyle": "->"}, ha="center", bbox=on_white(0.2, 0.85))


def turned(azimuth, x, y):
    a = math.radians(azimuth)
    return x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a)


def box_in(axes, station, box, **style):
    """A box in the frame of a station, seen from above."""
    (x0, y0), (x1, y1) = box["from"], box["to"]
    corners = [turned(station["azimuth"], station["radius"] + x, y) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
    axes.fill(*zip(*corners), **style)


def material_box(cell):
    side, gap = cell.drawing["material"]["side"], cell.drawing["material"]["gap"]
    low = -gap - side
    return {"from": (-side / 2, low), "to": (side / 2, low + side)}


def plan(axes, cell, storages=("storage 1",), moments=(), radius=None):
    """From above. `moments`: (name, colour, line style) of arms to be drawn; `radius` of the storage in place of its own."""
    drawing = cell.drawing
    machine = drawing["stations"]["machine"]
    box_in(axes, machine, drawing["plan"]["machine"], facecolor=COLORS["machine"], alpha=0.5, edgecolor=GREEN)
    box_in(axes, machine, material_box(cell), facecolor="none", edgecolor=BLACK, linestyle="--")
    name_at(axes, turned(machine["azimuth"], machine["radius"] + 150, 0), "machine")
    axes.add_patch(plt.Circle((0, 0), drawing["plan"]["body"], facecolor=COLORS["link"], alpha=0.5, edgecolor=BLACK))
    taken = bool(moments) and cell.moments[moments[-1][0]]["gripped"]
    for name in storages:
        station = dict(drawing["stations"][name])
        if radius:
            station["radius"] = radius
        box_in(axes, station, drawing["plan"]["storage"], facecolor=SKY, alpha=0.45, edgecolor=STATION_COLORS[name])
        box_in(axes, station, material_box(cell), facecolor="none" if taken else PURPLE, edgecolor=BLACK,
               linewidth=0.8)
        angle = round(station["azimuth"] + 150)
        text = f"storage\n{angle}°".replace("-", "−")
        name_at(axes, turned(station["azimuth"], station["radius"] + 150, 0), text)
    for name, color, style in moments:
        arm(axes, cell, name, color, style)
    if taken:
        carried(axes, cell, moments[-1][0])
    axes.plot(0, 0, marker="o", color=BLACK, markersize=3)
    axes.set(aspect="equal", xlim=(-860, 620), ylim=(-1010, 420), xlabel="x (mm), where the arm points at home", ylabel="y (mm)")
    axes.grid(alpha=0.25)


def carried(axes, cell, moment):
    """The material in the hand, from above."""
    part, solid = next((part, solid) for part, solid in cell.solids if part["moves_with"] == "material")
    points = solid.moved(cell.moments[moment]["material"]).vertices[:, :2]
    for loop in part["loops"]:
        axes.fill(*points[loop].T, color=PURPLE, alpha=0.6, linewidth=0, zorder=3)


def name_at(axes, at, text):
    axes.annotate(text, at, ha="center", va="center", fontsize=8)


def arm(axes, cell, moment, color, style="-"):
    """From the base's axis to the sphere, from above."""
    now = cell.moments[moment]
    points = [(0, 0)] + [(link[9], link[10]) for link in now["links"][2:]] + [tuple(now["sphere"][:2])]
    axes.plot(*zip(*points), color=color, linestyle=style, linewidth=3, solid_capstyle="round", alpha=0.85)
    axes.add_patch(plt.Circle(now["sphere"][:2], 14, color=color))


def arc(axes, begin, end, radius, text, color, share=0.5):
    """An arrow round the base, with its angle."""
    angles = np.radians(np.linspace(begin, end, 100))
    x, y = radius * np.cos(angles), radius * np.sin(angles)
    axes.plot(x[:-3], y[:-3], color=color, linewidth=1.2)
    axes.annotate("", (x[-1], y[-1]), (x[-6], y[-6]), arrowprops={"arrowstyle": "-|>", "color": color})
    middle = turned(begin + share * (end - begin), radius, 0)
    axes.annotate(text, middle, ha="center", va="center", color=color, fontsize=9, bbox=on_white(0.15))


def square(axes, radius, low, side, color, text, style="-"):
    axes.add_patch(plt.Rectangle((radius - side / 2, low), side, side, facecolor=color if style == "-" else "none", alpha=0.6,
                                 edgecolor=color, linestyle=style))
    axes.annotate(text, (radius + side / 2 + 8, low + side / 2), va="center", fontsize=7, color=color)


def arm_side(axes, cell, moment, color, style="-", text=None, width=3):
    points = [(0, 0)] + [(row["out"], row["up"]) for row in cell.sides[moment]]
    axes.plot(*zip(*points), color=color, linestyle=style, linewidth=width, marker="o", markersize=3, label=text,
              solid_capstyle="round")
    axes.add_patch(plt.Circle(points[-1], cell.drawing["sphere_radius"], color=color))


def side(axes, cell, case, before, now):
    """The arm in its own plane, before and after a move."""
    drawing, stations = cell.drawing, cell.drawing["stations"]
    length = drawing["material"]["side"]
    storage, machine = stations[f"storage {case}"], stations["machine"]
    taken = cell.moments[before]["gripped"]
    square(axes, storage["radius"], storage["height"], length, STATION_COLORS[f"storage {case}"],
           "place\nin storage" if taken else "material\nin storage", "--" if taken else "-")
    square(axes, machine["radius"], machine["height"], length, GREEN, "virtual material\nat the machine", "--")
    arm_side(axes, cell, before, GREY, "--", "before", 2)
    arm_side(axes, cell, now, BLACK, "-", "after")
    axes.set(aspect="equal", xlim=(-60, 860), ylim=(0, 1010), xlabel="from the base's axis (mm)",
             ylabel="above the floor (mm)", title="from the side, in the arm's plane")
    axes.grid(alpha=0.25)
    axes.legend(loc="lower left", fontsize=8)


@picture(9, 4.9, columns=2, width_ratios=(0.9, 1))
def views(both, cell, case, move):
    """From the side and from above, before and after a move (counted from 1)."""
    before = f"case {case}, move {move - 1}" if move > 1 else f"case {case}, home"
    now = f"case {case}, move {move}"
    left, right = both
    side(left, cell, case, before, now)
    plan(right, cell, (f"storage {case}",), [(before, GREY, "--"), (now, BLACK, "-")])
    right.set_title("from above")
    row = cell.moves[case, move]
    if row["joint"] == "base":
        begin = cell.moments[before]["commanded"][0]
        arc(right, begin, begin + row["degrees"], 250, f"{abs(row['degrees'])}°", RED)


@picture(6, 5.6)
def base_turn(axes, cell, case, move):
    """The turn of the base to the storage, from above."""
    before = f"case {case}, move {move - 1}"
    plan(axes, cell, (f"storage {case}",), [(before, GREY, "--"), (f"case {case}, move {move}", BLACK, "-")])
    degrees = cell.moves[case, move]["degrees"]
    arc(axes, 0, degrees, 250, f"{abs(degrees)}° clockwise", RED)


@picture(6, 5.6)
def configuration(axes, cell, case):
    plan(axes, cell, (f"storage {case}",), [(f"case {case}, home", BLACK, "-")])
    station = cell.drawing["stations"][f"storage {case}"]
    axes.plot(*zip((0, 0), turned(-150, 700, 0)), color=GREY, linewidth=0.8, linestyle=":")
    axes.annotate("storage's angle 0", turned(-150, 800, -20), fontsize=7, color="#555555", ha="center")
    axes.plot(*zip((0, 0), turned(station["azimuth"], station["radius"], 0)), color=BLUE, linewidth=0.8)


@picture(6.6, 6)
def angles_from_above(axes, cell, arcs, moments):
    """`arcs`: (begin, end, radius, text, colour)."""
    plan(axes, cell, ("storage 1", "storage 2"), moments)
    axes.annotate("", (500, 0), (0, 0), arrowprops={"arrowstyle": "->", "color": GREY})
    axes.annotate("home", (520, 0), va="center", fontsize=8)
    for begin, end, radius, text, color in arcs:
        arc(axes, begin, end, radius, text, color, 0.35)


STOPS = (("before", GREY, ":", "a step before"), ("first", BLUE, "--", "at first contact"), ("stop", RED, "-", "at the stop"))


def draw_stops(axes, cell, case, stop, place):
    """The sphere about a stop, where `place` puts its centre."""
    for when, color, style, text in STOPS:
        centre = place(*cell.stops[case, stop, when])
        axes.add_patch(plt.Circle(centre, cell.drawing["sphere_radius"], facecolor="none", edgecolor=color, linestyle=style,
                                  linewidth=1.8, label=text))
        axes.plot(*centre, marker="+", color=color)
    axes.set_aspect("equal")
    axes.legend(loc="center right", fontsize=8, title="the virtual sphere")
    axes.grid(alpha=0.25)


@picture(5.6, 4.2)
def contact_from_above(axes, cell, case, stop):
    """The material and the sphere in the frame of the storage: x away from the base, y counter-clockwise round it."""
    station = cell.drawing["stations"][f"storage {case}"]
    box = material_box(cell)
    (x0, y0), (x1, y1) = box["from"], box["to"]
    axes.fill([x0, x1, x1, x0], [y0, y0, y1, y1], color=PURPLE, alpha=0.45)
    axes.plot([x0, x1], [y1, y1], color=PURPLE, linewidth=2.5)
    axes.annotate("material", (0, -16), ha="center")
    axes.annotate("the side that is touched", (x1 - 1, y1), xytext=(x1 + 3, y1 - 13), fontsize=8, color=BLACK, arrowprops={"arrowstyle": "-", "linewidth": 0.8})

    def place(x, y, _):
        away, round_base = turned(-station["azimuth"], x, y)
        return away - station["radius"], round_base

    draw_stops(axes, cell, case, stop, place)
    axes.set(xlim=(-24, 58), ylim=(-24, 20), xlabel="away from the base's axis, from the storage's axis (mm)",
             ylabel="round the base (mm)")


@picture(5.6, 4.2)
def contact_from_side(axes, cell, case, stop):
    """The virtual material at the machine and the sphere, across the arm's plane."""
    station = cell.drawing["stations"]["machine"]
    length = cell.drawing["material"]["side"]
    low = station["height"] + cell.drawing["material"]["drop"]
    top = low + length
    axes.add_patch(plt.Rectangle((-length / 2, low), length, length, facecolor="#eeeeee", edgecolor=BLACK, linestyle="--"))
    axes.plot([-length / 2, length / 2], [top, top], color=BLACK, linewidth=2)
    axes.annotate("virtual material", (0, low + 14), ha="center")
    axes.annotate("the face that is touched", (-length / 2 + 1, top - 1.5), va="top", fontsize=8)
    draw_stops(axes, cell, case, stop, lambda x, y, z: (turned(-station["azimuth"], x, y)[0] - station["radius"], z))
    axes.set(xlim=(-34, 62), ylim=(top - 34, top + 26), xlabel="away from the base's axis, from the machine's axis (mm)",
             ylabel="above the floor (mm)")


@picture(9, 4.9, columns=2, width_ratios=(1.25, 1))
def heights(both, cell, places, which):
    """The arm touching at the chosen height and at the highest or lowest, and the ranges of both cases."""
    left, right = both
    length = cell.drawing["material"]["side"]
    for case, color, move in ((1, BLUE, 2), (2, ORANGE, 3)):
        station = cell.drawing["stations"][f"storage {case}"]
        square(left, station["radius"], station["height"], length, color, "")
        arm_side(left, cell, f"case {case}, move {move}", color, ":", f"case {case}, chosen height", 1.5)
        name = f"case {case}, {which}"
        if name in cell.sides:
            raised = cell.sides[name][0]["height"] - station["deck"]
            square(left, station["radius"], station["height"] + raised, length, color, which, "-")
            arm_side(left, cell, name, color, "-", f"case {case}, {which}")
    left.set(aspect="equal", xlim=(-60, 800), ylim=(0, 1000), xlabel="from the base's axis (mm)",
             ylabel="above the floor (mm)", title="touching the material in storage")
    left.legend(fontsize=7, loc="lower left")
    left.grid(alpha=0.25)
    for case, color in ((1, BLUE), (2, ORANGE)):
        rows = [row for row in places if row["scan"] == f"heights {case}"]
        runs = [(outcome, [row["height_mm"] for row in run])
                for outcome, run in itertools.groupby(rows, key=lambda row: row["outcome"])]
        completes = {"from the side": 0.85, "from above": 0.4}
        # A bar ends at the last height that completes, but halfway to the next one if that completes, too.
        for i, (outcome, run) in enumerate(runs):
            below, above = runs[max(0, i - 1)], runs[min(len(runs) - 1, i + 1)]
            low = (below[1][-1] + run[0]) / 2 if i > 0 and below[0] in completes else run[0]
            high = (run[-1] + above[1][0]) / 2 if i + 1 < len(runs) and above[0] in completes else run[-1]
            if outcome in completes:
                right.bar(case, high - low, 0.8, bottom=low, linewidth=1 if low == high else 0, edgecolor=color, color=color,
                          alpha=completes[outcome])
            right.plot([case] * len(run), run, linestyle="", marker="." if outcome in completes else "x", markersize=4,
                       color="white" if outcome in completes else BLACK)
        for end, offset, side in (("highest", 8, "bottom"), ("lowest", -8, "top")):
            if f"case {case}, {end}" in cell.sides:
                at = cell.sides[f"case {case}, {end}"][0]["height"]
                right.annotate(f"{at:g} mm", (case + 0.05, at + offset), ha="left", va=side, fontsize=8, bbox=on_white(0.1, 0.8))
    chosen = cell.drawing["stations"]["storage 1"]["deck"]
    right.axhline(chosen, color=BLACK, linewidth=0.8, linestyle=":")
    right.annotate("case studies", (2.55, chosen + 8), ha="right", fontsize=7)
    right.set_xticks([1, 2], ["case 1's place", "case 2's place"])
    right.set(xlim=(0.4, 2.6), ylim=(-50, 920), ylabel="height of the storage's deck (mm)")
    right.set_title("heights that complete (dots) and do not (crosses)\n(dark: touched from the side; light: from above)", fontsize=10)
