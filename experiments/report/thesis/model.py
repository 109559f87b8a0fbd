# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the cell's model, its files and its reconfiguration, for `touchstone thesis`.

Same data, same bytes: nothing here depends on the time or on chance."""
import math

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import FancyBboxPatch

from looks import BLACK, BLUE, ORANGE, PURPLE, RED, SKY
from style import GREY, STYLES, on_white, picture, plt
from thesis.cell import COLORS, plan, turned
from thesis.shaded import Camera, Solid, draw

PART_COLORS = ("#f0c878", SKY, "#cfa0b8")


def bounds(solids):
    vertices = np.concatenate([solid.vertices for solid in solids])
    return vertices.min(axis=0), vertices.max(axis=0)


def shaded(axes, solids, azimuth=40, elevation=24, aspect=1.0, pixels=600):
    low, high = bounds(solids)
    camera = Camera((low + high) / 2, azimuth, elevation, np.linalg.norm(high - low))
    # Once more, around what is seen.
    seen = camera.project(np.concatenate([solid.vertices for solid in solids]))[:, :2]
    (left, bottom), (right, top) = seen.min(axis=0), seen.max(axis=0)
    middle = camera.target + (left + right) / 2 * camera.right + (bottom + top) / 2 * camera.up
    draw(axes, solids, Camera(middle, azimuth, elevation, 1.1 * max(right - left, (top - bottom) / aspect)), aspect, pixels)


def solids_of(cell, link, colors=None):
    parts = [part for part in cell.drawing["parts"] if part["name"].split("/")[0] == link]
    return [Solid(part["vertices"], part["triangles"], colors[i % len(colors)] if colors else COLORS[part["moves_with"]])
            for i, part in enumerate(parts)]


def text_panel(axes, text, size=7.5):
    axes.text(0, 1, text, family="monospace", fontsize=size, va="top", ha="left", transform=axes.transAxes)
    axes.axis("off")


def shortened(text, head, tail=0):
    lines = text.splitlines()
    if len(lines) <= head + tail + 1:
        return "\n".join(lines)
    end = lines[len(lines) - tail:] if tail else []
    return "\n".join(lines[:head] + [f"... {len(lines) - head - tail} lines ..."] + end)


def file_and_part(text, solids, size=(8.4, 4.8), azimuth=40, font=7.5, ratios=(1, 1.1)):
    figure, (left, right) = plt.subplots(1, 2, figsize=size, width_ratios=ratios)
    figure.subplots_adjust(0.02, 0.02, 0.99, 0.96, wspace=0.03)
    text_panel(left, text, font)
    shaded(right, solids, azimuth)
    return figure


def bottom_file(cell, text):
    part = next(part for part in cell.drawing["parts"] if part["name"] == "machine/bottom")
    return file_and_part(text.rstrip(), [Solid(part["vertices"], part["triangles"], COLORS["machine"])], azimuth=215)


GRAMMAR = """file    = "Link" name
          "Parts" count part*
part    = "Part" name
          "Vertices" count vertex*
          "Polygons" count polygon*
vertex  = x y z
polygon = loop hole*
hole    = "Hole" loop
loop    = count number*

Each of Link, Parts, Part, Vertices,
Polygons, a vertex and a polygon has
a line of its own. Vertices are
numbered from 0 within their part.
What follows # means nothing."""


@picture(7.6, 4.2, columns=2, margins=(0.03, 0.02, 0.99, 0.9, 0.05))
def structure(both, text):
    left, right = both
    text_panel(left, GRAMMAR, 8.5)
    left.set_title("the grammar (ours: the thesis's is not public)", loc="left")
    text_panel(right, shortened(text, 9, 10), 8.5)
    right.set_title("Gripper1.txt", loc="left")


def three_parts(cell, text):
    lines = []
    for line in text.splitlines():
        if line.split()[0] in ("Link", "Parts", "Part", "Vertices", "Polygons"):
            lines.append(line)
            if line.startswith(("Vertices", "Polygons")):
                lines.append("  ...")
    figure = file_and_part("\n".join(lines), solids_of(cell, "Axis1", PART_COLORS), azimuth=55, font=8.5, ratios=(1, 2))
    names = [part["name"].split("/")[1] for part in cell.drawing["parts"] if part["name"].startswith("Axis1/")]
    for i, (name, color) in enumerate(zip(names, PART_COLORS)):
        figure.text(0.42 + 0.17 * i, 0.04, f"■ {name}", color=color, fontsize=11)
        figure.text(0.42 + 0.17 * i, 0.04, f"    {name}", color=BLACK, fontsize=11)
    return figure


def gripper_file(cell, text):
    part = next(part for part in cell.drawing["parts"] if part["name"] == "gripper/Gripper1")
    return file_and_part(text.rstrip(), [Solid(part["vertices"], part["triangles"], COLORS["gripper"])], azimuth=-60)


@picture(6, 5, frame=False)
def wireframe(axes, cell):
    """Every polygon of Axis1 by its edges, those behind too."""
    parts = [part for part in cell.drawing["parts"] if part["name"].startswith("Axis1/")]
    vertices = np.concatenate([np.array(part["vertices"]) for part in parts])
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    camera = Camera((low + high) / 2, 55, 24, 300)
    for part, color in zip(parts, (BLUE, BLACK, RED)):
        seen = camera.project(np.array(part["vertices"]))[:, :2]
        lines = [seen[loop + loop[:1]] for loop in part["loops"]]
        axes.add_collection(LineCollection(lines, colors=color, linewidths=0.7))
        axes.plot([], [], color=color, label=f"{part['name'].split('/')[1]}: {len(part['loops'])} loops")
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.legend(loc="lower right", fontsize=9)


@picture(9, 5, 2, 4, margins=(0.01, 0.01, 0.99, 0.93, 0.02, 0.14))
def links(grid, cell):
    names = cell.drawing["links"] + ["gripper"]
    for axes, name in zip(grid.flat, names):
        shaded(axes, solids_of(cell, name), 50, 20, pixels=400)
        axes.set_title("Gripper1" if name == "gripper" else name)


def box_text(axes, at, text, color="white", width=1.7, height=0.5, size=8):
    axes.add_patch(FancyBboxPatch((at[0] - width / 2, at[1] - height / 2), width, height, boxstyle="round,pad=0.04",
                                  facecolor=color, edgecolor=BLACK, linewidth=0.8))
    axes.annotate(text, at, ha="center", va="center", fontsize=size)


@picture(9, 5.2, frame=False)
def hierarchy(axes, cell):
    """The cell's elements and the parts of each."""
    groups = [("robot", "link", COLORS["link"]), ("gripper", "gripper", COLORS["gripper"]), ("storage", "storage", SKY),
              ("machine", "machine", COLORS["machine"]), ("material", "material", COLORS["material"])]
    box_text(axes, (4, 10.4), "virtual manufacturing cell", "#eeeeee", 3.4)
    for i, (name, carrier, color) in enumerate(groups):
        x = i * 2
        box_text(axes, (x, 9.1), name, color)
        axes.plot([4, x], [10.1, 9.4], color=BLACK, linewidth=0.8)
        parts = [part["name"] for part in cell.drawing["parts"] if part["moves_with"].replace("finger", "gripper") == carrier]
        for j, part in enumerate(parts):
            y = 8.2 - j * 0.72
            box_text(axes, (x + 0.1, y), part.split("/", 1)[-1] if carrier != "link" else part, width=1.6, height=0.42, size=7.5)
            axes.plot([x - 0.82, x - 0.82, x - 0.72], [8.82, y, y], color=BLACK, linewidth=0.6)
    axes.set(xlim=(-1.1, 9.1), ylim=(1.3, 10.9))


@picture(8.4, 5.6, frame=False)
def chain(axes, cell):
    names, joints = cell.drawing["links"], cell.drawing["joints"]
    for i, name in enumerate(names + ["Gripper1"]):
        box_text(axes, (0, -i), name, COLORS["gripper"] if name == "Gripper1" else COLORS["link"], 2, 0.46, 9)
        if i == 0:
            continue
        axes.annotate("", (0, -i + 0.28), (0, -i + 0.72), arrowprops={"arrowstyle": "-|>"})
        if i <= len(joints):
            joint = joints[i - 1]
            axes.annotate(f"turns: {joint['name'].replace('_', ' ')}, {joint['lower']:g}° to {joint['upper']:g}°, home {joint['home']:g}°"
                          .replace("-", "−"), (1.35, -i + 0.5), va="center", fontsize=9)
        else:
            axes.annotate("fixed", (1.35, -i + 0.5), va="center", fontsize=9)
    axes.annotate("the elbow makes up for\nthe shoulder, so that the\nforearm keeps its elevation", (-1.4, -2.5), ha="right",
                  va="center", fontsize=9)
    axes.annotate("", (-1.1, -2), (-1.1, -3), arrowprops={"arrowstyle": "<->"})
    axes.set(xlim=(-4.2, 5.4), ylim=(-7.5, 0.5))


@picture(8.6, 3.8, columns=2, width_ratios=(1.5, 1), margins=(0, 0, 1, 0.92, 0))
def union(both, cell, link, name):
    """Primitives apart, and united."""
    primitives = cell.drawing["primitives"][link][name]
    left, right = both
    solids = [Solid(p["vertices"], p["triangles"], color) for p, color in zip(primitives, PART_COLORS)]
    apart = []
    # Primitives along the picture's horizon.
    azimuth = 40
    right_hand = np.array([-math.sin(math.radians(azimuth)), math.cos(math.radians(azimuth)), 0])
    place = 0.0
    for solid in solids:
        across = solid.vertices @ right_hand
        apart.append(solid.moved([1, 0, 0, 0, 1, 0, 0, 0, 1, *((place - across.min()) * right_hand)]))
        place += across.max() - across.min() + 60
    shaded(left, apart, azimuth, aspect=0.66)
    left.set_title(f"{len(primitives)} primitives")
    shaded(right, solids_of(cell, link, ("#f0c878",))[:1], azimuth)
    right.set_title("united")


@picture(6, 5.6, frame=False)
def robot(axes, cell):
    now = cell.moments["case 1, home"]
    solids = [solid.moved(now["links"][part["link"] if part["moves_with"] == "link" else -1])
              for part, solid in cell.solids if part["moves_with"] in ("link", "gripper", "finger")]
    shaded(axes, solids, -58, 20, aspect=0.93, pixels=900)


# ---- Reconfiguration ----

OUTCOMES = {"from the side": (BLUE, "completes, touched from the side"), "from above": (SKY, "completes, touched from above"),
            "out-of-reach": ("#dddddd", "out of reach"), "beyond-limits": (PURPLE, "beyond a joint's limit"),
            "no-contact": (ORANGE, "no contact where one should be"), "not-held": ("#f0c878", "not between the fingers"),
            "misplaced": ("#b9c4b9", "let go too far from its place"), "in-the-way": (RED, "something in the way")}


@picture(7.6, 7)
def area(axes, cell, places):
    rows = [row for row in places if row["scan"] == "area"]
    angles, radii = sorted({row["angle_deg"] for row in rows}), sorted({row["radius_mm"] for row in rows})
    step, thick = angles[1] - angles[0], radii[1] - radii[0]
    patches = {}
    for row in rows:
        a = np.radians(np.linspace(-150 + row["angle_deg"] - step / 2, -150 + row["angle_deg"] + step / 2, 6))
        inner, outer = row["radius_mm"] - thick / 2, row["radius_mm"] + thick / 2
        x, y = np.concatenate([inner * np.cos(a), outer * np.cos(a[::-1])]), np.concatenate([inner * np.sin(a), outer * np.sin(a[::-1])])
        patches.setdefault(row["outcome"], []).append(np.stack([x, y], axis=1))
    for outcome, (color, text) in OUTCOMES.items():
        if outcome in patches:
            axes.add_collection(PolyCollection(patches[outcome], facecolors=color, linewidths=0.3, edgecolors=color,
                                               rasterized=True))
            axes.fill([], [], color=color, label=text)
    machine = cell.drawing["stations"]["machine"]
    (x0, y0), (x1, y1) = cell.drawing["plan"]["machine"]["from"], cell.drawing["plan"]["machine"]["to"]
    corners = [turned(machine["azimuth"], machine["radius"] + x, y) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0))]
    axes.plot(*zip(*corners), color=BLACK, linewidth=1.2)
    axes.annotate("machine", turned(machine["azimuth"], machine["radius"] + 280, 0), ha="center", fontsize=9)
    axes.add_patch(plt.Circle((0, 0), cell.drawing["plan"]["body"], facecolor="white", edgecolor=BLACK))
    axes.annotate("robot", (0, 0), ha="center", va="center", fontsize=8)
    for name, text in (("storage 1", "case 1"), ("storage 2", "case 2")):
        station = cell.drawing["stations"][name]
        at = turned(station["azimuth"], station["radius"], 0)
        axes.plot(*at, marker="*", color="white", markeredgecolor=BLACK, markersize=14)
        axes.annotate(text, at, xytext=(-26, -14), textcoords="offset points", fontsize=8, bbox=on_white(0.15, 0.85))
    for angle in range(-180, 180, 30):
        axes.annotate(f"{angle}°".replace("-", "−"), turned(-150 + angle, 775, 0), ha="center", va="center", fontsize=8)
    axes.set(aspect="equal", xlim=(-900, 900), ylim=(-1000, 830), xlabel="x (mm); round the edge: the storage's angle",
             ylabel="y (mm)")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=2, fontsize=8, frameon=False)


def radii_that_fail(places):
    """The greatest radius that is too close, and the least that is too far."""
    rows = [row for row in places if row["scan"] == "radii"]
    completes = [row["radius_mm"] for row in rows if row["outcome"] in ("from the side", "from above")]
    return (max(row["radius_mm"] for row in rows if row["radius_mm"] < min(completes)),
            min(row["radius_mm"] for row in rows if row["radius_mm"] > max(completes)))


@picture(6, 5.6)
def too_close(axes, cell, places):
    radius, _ = radii_that_fail(places)
    plan(axes, cell, ("storage 1",), radius=radius)
    axes.set_title(f"radius {radius:g} mm: too close")


@picture(6, 5.6)
def too_far(axes, cell, places):
    _, radius = radii_that_fail(places)
    plan(axes, cell, ("storage 1",), radius=radius)
    reach = cell.drawing["reach"]
    length = reach["first"] + reach["second"]
    up = cell.drawing["stations"]["storage 1"]["height"] + cell.drawing["material"]["side"] + reach["down"] - reach["shoulder"]
    axes.add_patch(plt.Circle((0, 0), math.sqrt(length ** 2 - up ** 2), facecolor="none", edgecolor=BLUE, linestyle="--"))
    axes.annotate("as far as the sphere reaches\nat the material's height", turned(25, 560, 0), fontsize=8, color=BLUE, ha="center",
                  bbox=on_white(0.15, 0.85))
    axes.set(xlim=(-1000, 760), ylim=(-1010, 740), title=f"radius {radius:g} mm: too far")


@picture(8.4, 6.4, frame=False)
def process(axes, cell):
    words = {("elbow", -1): "elbow down", ("elbow", 1): "elbow up", ("base", -1): "base clockwise", ("base", 1): "base counter-clockwise",
             ("shoulder", 1): "shoulder down", ("shoulder", -1): "shoulder up"}
    boxes = [("home", "#eeeeee")]
    ends = {"to-storage": [("grip the material", "#f7d9c4")], "to-machine": [("let it go in the machine", "#f7d9c4")],
            "withdraw": [("the machine mills", "#d5e8d8")], "to-piece": [("grip it again", "#f7d9c4")],
            "back-to-storage": [("let it go in the storage", "#f7d9c4")], "to-home": [("home", "#eeeeee")]}
    moves = [cell.moves[key] for key in sorted(key for key in cell.moves if key[0] == 1)]
    for move, after in zip(moves, moves[1:] + [None]):
        text = f"{words[move['joint'], 1 if move['degrees'] > 0 else -1]} {abs(move['degrees'])}°"
        boxes.append((text + (", until the\nsphere touches" if move["until"] == "contact" else ""), "white"))
        if after is None or after["phase"] != move["phase"]:
            boxes += ends[move["phase"]]
    columns, places = 4, []
    for i in range(len(boxes)):
        row, column = divmod(i, columns)
        places.append(((column if row % 2 == 0 else columns - 1 - column) * 2.5, -row * 1.3))
    for (text, color), at in zip(boxes, places):
        box_text(axes, at, text, color, 2.0, 0.72, 8)
    for (x0, y0), (x1, y1) in zip(places, places[1:]):
        begin = (x0 + math.copysign(1.05, x1 - x0), y0) if y0 == y1 else (x0, y0 - 0.41)
        end = (x1 - math.copysign(1.05, x1 - x0), y1) if y0 == y1 else (x1, y1 + 0.41)
        axes.annotate("", end, begin, arrowprops={"arrowstyle": "-|>", "shrinkA": 0, "shrinkB": 0})
    axes.set(xlim=(-1.3, 8.8), ylim=(min(y for _, y in places) - 0.6, 0.6))


@picture(8, 6, rows=2, sharex=True)
def joint_angles(both, cell):
    for case, axes in zip((1, 2), both):
        now, step, numbers = {"base": 0, "shoulder": 0, "elbow": 0}, 0, sorted(n for c, n in cell.moves if c == case)
        lines = {joint: [(0, 0)] for joint in now}
        for number in numbers:
            move = cell.moves[case, number]
            step += abs(move["degrees"])
            now[move["joint"]] += move["degrees"]
            for joint in now:
                lines[joint].append((step, now[joint]))
            axes.axvline(step, color=RED if move["until"] == "contact" else GREY, linewidth=1.2 if move["until"] == "contact" else 0.6,
                         linestyle="-" if move["until"] == "contact" else ":")
            if move["until"] == "contact":
                axes.annotate("contact", (step, 45), rotation=90, fontsize=8, color=RED, ha="right", va="bottom")
        for (color, style, _), joint in zip(STYLES, lines):
            axes.plot(*zip(*lines[joint]), color=color, linestyle=style, linewidth=1.8, label=joint)
        axes.set(ylabel="commanded, from home (degrees)", ylim=(-200, 110),
                 title=f"case {case}: storage at {'1' if case == 1 else '−33'}°")
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8, loc="lower right")
    both[-1].set_xlabel("steps of 1 degree")
