# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone thesis`: the figures of the thesis of 2008, with their status."""
import json
import pathlib
import re
import shutil
import sys

from looks import BLACK, BLUE, ORANGE
from page import code, count, escaped, inlined, number, percent, rendered, smaller
from replacing import replacing
from results import Study, maybe, natural
from results import number as any_number
from studies import OUTPUT, Run
from style import draw, plt, rows_of, save
from thesis import cell as views
from thesis import method, model, predictions

RUN = Run(17, "the thesis's figures", full=[["thesis", "--output", OUTPUT]], quick=[["thesis", "--quick", "--output", OUTPUT]],
          tiny=["thesis", "--quick", "--samples", "100", "--no-pictures"])
TITLE = "The figures of the thesis of 2008"
SHOWN = ("E.1",)  # in the chapter; all are on the thesis's own page
CHAPTERS = {"2": "Chapter 2: literature", "3": "Chapter 3: methodology", "4": "Chapter 4: the collision detection algorithm",
            "5": "Chapter 5: the virtual environment", "6": "Chapter 6: the case studies", "E": "Known errors of the method"}
TONES = {"differs": "no", "reproduced with chosen values": "chosen"}
MEANINGS = {"derived": "its numbers are compared with what this project derived or another source states, not with the thesis",
            "self-check": "compared with what holds by construction, such as a file that is written and read again"}
BASES = {"fitted": "angles that captions state, for which the layout was solved", "input": "numbers of captions that the cell was built with",
         "predicted": "counts of places that were not fitted, at which what the captions imply is found",
         "other source": "numbers of other sources", "own check": "tests of this project: arithmetic, and the exact answer"}


class Data:
    def __init__(self, study):
        self.entries = study.rows("entries.csv", id=str, caption=str, page=str, status=str, text=str, picture=str, shows=str)
        self.numbers = study.rows("numbers.csv", id=str, what=str, unit=str, ours=any_or_none, stated=str, label=str, basis=str, agrees=str)
        self.areas = study.rows("areas.csv", outline=str, share=maybe(any_number), right=natural, wrong=natural,
                                hull=any_number, parts=natural)


def any_or_none(text):
    """Accepts any number; NaN stands for a missing one."""
    float(text)
    return text


def name_of(entry):
    return "Table" + entry["id"][5:] if entry["id"].startswith("table") else "Figure " + entry["id"]


def stated_in(numbers):
    return [row for row in numbers if row["stated"]]


def bases(numbers):
    """How many stated numbers agree, by what that means; those of the known errors apart."""
    stated = stated_in(numbers)
    own = [row for row in stated if row["id"].startswith("E.")]
    groups = [(text, [row for row in stated if row["basis"] == basis and row not in own]) for basis, text in BASES.items()]
    return [f"{sum(row['agrees'] == 'yes' for row in rows)} of {len(rows)}{distinct_of(rows)}: {text}"
            for text, rows in groups + [("known errors of the thesis's method: numbers of this project's own fact sheet, not of the thesis", own)] if rows]


def distinct_of(rows):
    """Captions repeat themselves: how many different numbers there are, if fewer than rows."""
    values = {(row["stated"], row["unit"]) for row in rows}
    return f" ({len(values)} different numbers)" if 1 < len(values) < len(rows) else ""


def fit(numbers):
    """How easily the layout fits, beside how many captions it does; empty if it was not measured."""
    values = {row["what"]: row["ours"] for row in numbers if row["id"] == "table 6.1"}
    names = {"free": "values of the layout that are chosen freely", "captions": "captioned moves of both cases that it must reproduce",
             "homes": "home poses that were tried", "share": "of these with a layout in which all captions hold"}
    return rendered("thesis_fit.html", **{key: values[name] for key, name in names.items()}) if set(names.values()) <= values.keys() else ""


def counts_of(statuses):
    """The most frequent first."""
    return dict(sorted(((status, statuses.count(status)) for status in dict.fromkeys(statuses)), key=lambda item: -item[1]))


def named_systems():
    """The table of docs/named.md: of Markdown, code as code, the text of links, no keys of the bibliography."""
    def plain(cell):
        cell = re.sub(r" ?\[[a-z]+\d{4}\]", "", re.sub(r"\[([^]]+)\]\([^)]+\)", r"\1", cell))
        return re.sub(r"`([^`]+)`", lambda match: code(match.group(1)), escaped(cell))

    page = pathlib.Path(__file__).parents[3] / "docs/named.md"
    return [[plain(cell) for cell in line.strip("|\n ").split(" | ")] for line in page.read_text(encoding="utf-8").splitlines() if line.startswith("| ")]


def told(study):
    data = Data(study)
    notched = [row for row in data.areas if row["hull"] > 0 and row["share"] is not None]

    def shown(entry):
        own = [row for row in stated_in(data.numbers) if row["id"] == entry["id"]]
        return entry | {"name": name_of(entry), "path": smaller(study.folder, entry["picture"]) if entry["picture"] else None,
                        "agreement": f"{sum(row['agrees'] != 'no' for row in own)} of {len(own)}" if own else "none stated"}

    return {
        "data": data, "bases": bases(data.numbers), "fit": fit(data.numbers),
        "differing": [f"{escaped(row['id'])}, {escaped(row['what'])}: {number(row['ours'])} {escaped(row['unit'])}, stated {number(row['stated'])}"
                      for row in stated_in(data.numbers) if row["agrees"] == "no"],
        "worst": max((row for row in data.areas if row["share"] is not None), key=lambda row: row["share"], default=None),
        "worse_than_hulls": notched and all(row["share"] > row["hull"] for row in notched),
        "areas": [[escaped(row["outline"]), "" if row["share"] is None else percent(row["share"], 3), percent(row["hull"], 3), "0", count(row["parts"])]
                  for row in data.areas],
        "predicted": predictions.section(study), "systems": named_systems(), "statuses": [f"{count(n)} {escaped(status)}" for status, n in counts_of([entry["status"] for entry in data.entries]).items()],
        "shown": [each for entry in data.entries if entry["id"] in SHOWN and (each := shown(entry))["path"]]}


def entry_told(folder, entry, rows, shown):
    """`shown`: entries by the bytes of their pictures; one that an earlier entry showed is named."""
    told = entry | {"name": name_of(entry), "anchor": entry["id"].replace(" ", "-"), "its_status": entry["status"], "earlier": None,
                    "rows": [row | {"unit_shown": escaped(row["unit"] if row["unit"] in ("", "°") else " " + row["unit"])} for row in rows]}
    if entry["status"].startswith("photograph") and stated_in(rows):  # what it shows cannot be computed
        told["status"] = "photograph: its caption's numbers alone are computed"
    if entry["picture"]:
        path = smaller(folder, entry["picture"])
        earlier = shown.setdefault(path.read_bytes(), told)
        told |= {"address": inlined(path)} if earlier is told else {"earlier": earlier}
    return told


def write_page(folder, entries, numbers, run):
    """index.html: every figure and table with its status, numbers and picture, in one file."""
    shown = {}
    told = [entry_told(folder, entry, [row for row in numbers if row["id"] == entry["id"]], shown) for entry in entries]
    by_chapter = {key: [entry for entry in told if entry["id"].removeprefix("table ").split(".")[0] == key] for key in CHAPTERS}
    text = rendered("thesis_page.html", entries=entries, known_errors=len(by_chapter["E"]), statuses=counts_of([entry["status"] for entry in told]),
                    bases=bases(numbers), fit=fit(numbers), differing=[row for row in stated_in(numbers) if row["agrees"] == "no"], run=run, tones=TONES,
                    meanings=MEANINGS, predicted=predictions.section(Study(folder)),
                    chapters=[{"key": key, "title": title, "entries": by_chapter[key]} for key, title in CHAPTERS.items()])
    with replacing(folder / "index.html") as file:
        file.write_text(text, encoding="utf-8")




def numeric(rows):
    """Whatever is a number becomes one."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    return [{name: value(text) for name, text in row.items()} for row in rows]


class Drawn:
    """All files of a folder that pictures are drawn from."""

    def __init__(self, folder):
        self.entries, self.numbers = rows_of(folder / "entries.csv"), rows_of(folder / "numbers.csv")
        for name in ("branches", "map", "views", "areas", "reach", "touching", "far", "missed", "places"):
            setattr(self, name, numeric(rows_of(folder / f"{name}.csv")))
        sides = {}
        for row in numeric(rows_of(folder / "sides.csv")):
            sides.setdefault(row["moment"], []).append({"out": row["out_mm"], "up": row["up_mm"], "height": row["height_mm"]})
        stops = {(int(row["case"]), int(row["stop"]), row["when"]): (row["x_mm"], row["y_mm"], row["z_mm"])
                 for row in numeric(rows_of(folder / "stops.csv"))}
        moves = {(int(row["case"]), int(row["move"])): row | {"degrees": int(row["degrees"])}
                 for row in numeric(rows_of(folder / "moves.csv"))}
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
    data = Drawn(folder)
    wanted = [entry["picture"] for entry in data.entries if entry["picture"]]
    drawn = pictures(data)
    if missing := sorted(set(wanted) ^ set(drawn) ^ set(SAME)):
        sys.exit(f"thesis.py: entries and pictures differ: {', '.join(missing)}")
    draw((lambda stem=stem, make=make: save(make(), folder, stem),) for stem, make in drawn.items())
    for stem, original in SAME.items():
        for kind in ("svg", "png"):
            shutil.copyfile(folder / f"{original}.{kind}", folder / f"{stem}.{kind}")
    write_page(folder, data.entries, data.numbers, json.loads((folder / "run.json").read_text(encoding="utf-8")))
