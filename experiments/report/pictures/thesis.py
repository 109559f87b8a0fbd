# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures and page of `touchstone thesis`: every figure that has one, as SVG and PNG, and index.html.

Same data, same bytes: nothing here depends on the time or on chance."""
import csv
import json
import pathlib
import shutil
import sys

from pictures import thesis_cell as views
from pictures import thesis_method as method
from pictures import thesis_model as model
from pictures.style import STYLES, draw, plt, save
from thesis_page import write_page

BLUE, ORANGE, RED, BLACK = (STYLES[i][0] for i in range(4))


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def numeric(rows):
    """Whatever is a number becomes one."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    return [{name: value(text) for name, text in row.items()} for row in rows]


class Data:
    """All files of a folder that pictures are drawn from."""

    def __init__(self, folder):
        self.entries, self.numbers = read(folder / "entries.csv"), read(folder / "numbers.csv")
        for name in ("branches", "map", "views", "areas", "reach", "touching", "far", "missed", "places"):
            setattr(self, name, numeric(read(folder / f"{name}.csv")))
        sides = {}
        for row in numeric(read(folder / "sides.csv")):
            sides.setdefault(row["moment"], []).append({"out": row["out_mm"], "up": row["up_mm"], "height": row["height_mm"]})
        stops = {(int(row["case"]), int(row["stop"]), row["when"]): (row["x_mm"], row["y_mm"], row["z_mm"])
                 for row in numeric(read(folder / "stops.csv"))}
        moves = {(int(row["case"]), int(row["move"])): row | {"degrees": int(row["degrees"])}
                 for row in numeric(read(folder / "moves.csv"))}
        self.drawing = json.loads((folder / "drawing.json").read_text(encoding="utf-8"))
        self.cell = views.Cell(self.drawing, sides, stops, moves)
        self.models = {path.stem: path.read_text(encoding="utf-8") for path in (folder / "models").glob("*.txt")}

    def of(self, entry):
        return [row for row in self.numbers if row["id"] == entry]


def cell_page():
    """The stored picture of the page, which cell_page.py takes."""
    picture = plt.imread(pathlib.Path(__file__).parents[3] / "docs/cell-page.png")
    height, width = picture.shape[:2]
    figure = plt.figure(figsize=(9, 9 * height / width))
    axes = figure.add_axes((0, 0, 1, 1))
    axes.imshow(picture, interpolation="none")
    axes.axis("off")
    return figure


def pictures(data):
    """By file stem, what draws it."""
    cell, gripper = data.cell, data.drawing["outlines"]["gripper"]
    at_machine = [("case 1, move 2", BLUE, "--"), ("case 2, move 3", ORANGE, "--"), ("case 1, move 5", BLACK, "-")]
    to_storage = [("case 1, home", BLACK, "-"), ("case 1, move 2", BLUE, "--"), ("case 2, move 3", ORANGE, "--")]
    return {
        "3-2": lambda: model.bottom_file(cell, data.models["machine-bottom"]),
        "4-1": lambda: views.contact_from_above(cell, 1, 1),
        "4-2": lambda: views.contact_from_side(cell, 1, 2),
        "4-3": lambda: method.flowchart(data.branches),
        "4-4": lambda: method.plane_side(1.6, "INFRONT: s ≥ r"),
        "4-5": lambda: method.plane_side(-1.6, "BEHIND: neither"),
        "4-6": lambda: method.plane_side(0.6, "INTERSECTS: |s| < r"),
        "4-7": method.intersection_point,
        "4-8": lambda: method.angle_views(gripper, data.views),
        "4-9": lambda: method.edge_places(data.numbers),
        "4-10": lambda: method.edge_hit(gripper),
        "4-11": lambda: views.angles_from_above(cell, [(0, -149, 190, "149°", BLUE), (0, -183, 290, "183°", ORANGE)], to_storage),
        "4-12": lambda: views.angles_from_above(cell, [(-149, -83, 230, "66°", BLUE), (-183, -83, 330, "100°", ORANGE)], at_machine),
        "5-2": lambda: model.process(cell),
        "5-5": lambda: model.joint_angles(cell),
        "5-6": lambda: model.hierarchy(cell),
        "5-7": lambda: model.links(cell),
        "5-8": lambda: model.chain(cell),
        "5-9": lambda: model.union(cell, "Base", "pedestal"),
        "5-10": lambda: model.union(cell, "Axis1", "body"),
        "5-11": lambda: model.robot(cell),
        "5-12": lambda: model.structure(data.models["Gripper1"]),
        "5-13": lambda: model.three_parts(cell, data.models["Axis1"]),
        "5-14": lambda: model.gripper_file(cell, data.models["Gripper1"]),
        "5-15": lambda: model.wireframe(cell),
        "5-16": cell_page,
        "5-17": lambda: views.configuration(cell, 1),
        "5-18": lambda: model.too_close(cell, data.places),
        "5-19": lambda: model.too_far(cell, data.places),
        "5-20": lambda: views.perspective(cell, "case 1, home"),
        "5-21": lambda: views.perspective(cell, "case 2, home"),
        "5-22": lambda: model.area(cell, data.places),
        "5-24": lambda: views.perspective(cell, "case 1, move 2"),
        "5-25": lambda: views.perspective(cell, "case 1, move 5"),
        "5-26": lambda: views.perspective(cell, "case 1, move 8"),
        "6-4": lambda: views.views(cell, 1, 1),
        "6-6": lambda: views.base_turn(cell, 1, 2),
        "6-10": lambda: views.close_up(cell, "case 1, move 2"),
        "6-11": lambda: views.views(cell, 1, 3),
        "6-13": lambda: views.views(cell, 1, 4),
        "6-14": lambda: views.views(cell, 1, 5),
        "6-17": lambda: views.close_up(cell, "case 1, move 5", virtual=True),
        "6-18": lambda: views.configuration(cell, 2),
        "6-20": lambda: views.views(cell, 2, 1),
        "6-22": lambda: views.base_turn(cell, 2, 2),
        "6-23": lambda: views.views(cell, 2, 3),
        "6-25": lambda: views.views(cell, 2, 5),
        "6-27": lambda: views.views(cell, 2, 6),
        "6-28": lambda: views.views(cell, 2, 7),
        "6-30": lambda: views.heights(cell, data.places, "highest"),
        "6-31": lambda: views.heights(cell, data.places, "lowest"),
        "E-1": lambda: method.angle_map(gripper, data.map),
        "E-2": lambda: method.false_areas(data.drawing["outlines"], data.areas),
        "E-3": lambda: method.false_hits(data.of("E.3")),
        "E-4": lambda: method.factor_reach(data.reach),
        "E-5": lambda: method.not_numbers(data.of("E.5")),
        "E-6": lambda: method.touching(data.touching),
        "E-7": lambda: method.collinear(gripper, data.of("E.7")),
        "E-8": lambda: method.far_away(data.far),
        "E-9": lambda: method.missed(data.missed),
    }


# What is seen in two figures is drawn once.
SAME = {"5-23": "5-20", "6-1": "5-17", "6-2": "5-20", "6-7": "5-24", "6-9": "4-1", "6-16": "4-2", "6-19": "5-21"}

def main(folder):
    data = Data(folder)
    wanted = [entry["picture"] for entry in data.entries if entry["picture"]]
    drawn = pictures(data)
    if missing := sorted(set(wanted) ^ set(drawn) ^ set(SAME)):
        sys.exit(f"thesis.py: entries and pictures differ: {', '.join(missing)}")
    draw((lambda stem=stem, make=make: save(make(), folder, stem),) for stem, make in drawn.items())
    for stem, original in SAME.items():
        for kind in ("svg", "png"):
            shutil.copyfile(folder / f"{original}.{kind}", folder / f"{stem}.{kind}")
    write_page(folder, data.entries, data.numbers, json.loads((folder / "run.json").read_text(encoding="utf-8")))
