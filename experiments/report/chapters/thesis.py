# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone thesis`: the figures of the thesis of 2008, with their status."""
import pathlib
import re

from page import code, count, escaped, folded, number, percent, picture, smaller, table, words
from results import maybe, natural
from results import number as any_number
from thesis_page import bases, fit, name_of

TITLE = "The figures of the thesis of 2008"
SHOWN = ("E.1",)  # in this page; all are on the thesis's own


class Data:
    def __init__(self, study):
        self.entries = study.rows("entries.csv", id=str, caption=str, page=str, status=str, text=str, picture=str, shows=str)
        self.numbers = study.rows("numbers.csv", id=str, what=str, unit=str, ours=any_or_none, stated=str, label=str, basis=str, agrees=str)
        self.areas = study.rows("areas.csv", outline=str, share=maybe(any_number), right=natural, wrong=natural,
                                hull=any_number, parts=natural)
        self.stated = [row for row in self.numbers if row["stated"]]
        self.differing = [row for row in self.stated if row["agrees"] == "no"]

    @property
    def statuses(self):
        counts = {}
        for entry in self.entries:
            counts[entry["status"]] = counts.get(entry["status"], 0) + 1
        return dict(sorted(counts.items(), key=lambda item: -item[1]))


def any_or_none(text):
    """Accepts any number; NaN stands for a missing one."""
    float(text)
    return text


def asked(study):
    return {}


def differing(data):
    return words(f"{escaped(row['id'])}, {escaped(row['what'])}: {number(row['ours'])} {escaped(row['unit'])}, stated "
                 f"{number(row['stated'])}"
                 for row in data.differing)


def finding(study):
    data = Data(study)
    return (f"Of {len(data.entries)} figures, tables and known errors, "
            f"numbers agree as follows: {words(bases(data.stated))}"
            + (f" (not: {differing(data)})." if data.differing else ".") + fit_of(data))


def named_systems():
    """The table of docs/named.md."""
    page = pathlib.Path(__file__).parents[3] / "docs/named.md"
    rows = [[plain(cell) for cell in line.strip("|\n ").split(" | ")] for line in page.read_text(encoding="utf-8").splitlines()
            if line.startswith("| ")]
    return table("What each was, what stands for it here, and what has become of it",
                                                             rows[0], rows[1:], ())


def plain(cell):
    """Of Markdown: code as code, the text of links, no keys of the bibliography."""
    cell = re.sub(r" ?\[[a-z]+\d{4}\]", "", re.sub(r"\[([^]]+)\]\([^)]+\)", r"\1", cell))
    return re.sub(r"`([^`]+)`", lambda match: code(match.group(1)), escaped(cell))


def fit_of(data):
    """How easily the layout fits, in a sentence; nothing if it was not measured."""
    own = {}
    for row in data.numbers:
        own.setdefault(row["id"], []).append(row)
    return fit(own).replace("<p>", " ").replace("</p>", "")


def shown_picture(study, data, entry):
    path = smaller(study.folder, entry["picture"]) if entry["picture"] else None
    if path is None:
        return ""
    return picture(path, entry["shows"], f"{escaped(name_of(entry))}, {escaped(entry['caption'])}: {escaped(entry['shows'])} "
                   f"{escaped(entry['text'])} <b>Status:</b> {escaped(entry['status'])}; stated numbers reproduced: "
                   f"{agreement(data, entry)}.")


def chapter(study):
    data = Data(study)
    worst = max((row for row in data.areas if row["share"] is not None), key=lambda row: row["share"], default=None)
    text = f"""<p>H. Arshad, <cite>A Collision Detection Algorithm for Virtual Robot-Centered Flexible Manufacturing
Cell</cite>, PhD thesis, Universiti Putra Malaysia, 2008, decides contact as this project's {code('thesis')} does: it adds
the angles at which the polygon's edges are seen from the foot and calls the foot inside if they reach 0.99 of a full turn.
Without signs, that is wrong for non-convex outlines"""
    if worst:
        text += f": for the outline “{escaped(worst['outline'])}” the area wrongly called inside is {percent(worst['share'], 3)} of the outline's own"
    text += ". The thesis wants to avoid convex hulls, which fill notches, and decompositions into convex parts, which it finds costly."
    if data.areas:
        text += "</p>"
        areas = table("Area outside an outline that is taken for inside, relative to the outline's own",
                      ["outline", "thesis's angle sum", "convex hull", "convex parts", "number of these"],
                      [[escaped(row["outline"]), "" if row["share"] is None else percent(row["share"], 3), percent(row["hull"], 3),
                        "0", count(row["parts"])] for row in data.areas], (1, 2, 3, 4))
        beaten = [row for row in data.areas if row["hull"] > 0 and row["share"] is not None]
        if beaten and all(row["share"] > row["hull"] for row in beaten):
            text += "<p>On every outline that is not convex, its test is wrong over more area than the hull that it is to avoid. "
        else:
            text += "<p>"
    else:
        text += " "
    text += "Every figure and table of the thesis that has a number gets that number; "
    text += "all of them, with pictures, are on <a href=\"thesis/index.html\">a page of their own</a>, beside this one.</p>"
    if data.areas:
        text += folded("The areas of every outline", areas)
    text += folded("Systems that the thesis names", named_systems())
    text += f"<p>By status: {words(f'{count(n)} {escaped(status)}' for status, n in data.statuses.items())}.</p>"
    by_id = {entry["id"]: entry for entry in data.entries}
    shown = "".join(shown_picture(study, data, by_id[name]) for name in SHOWN if name in by_id)
    return text + (folded("Why: the angle sum about a gripper's gap", f'<div class="narrow">{shown}</div>') if shown else "")


def agreement(data, entry):
    own = [row for row in data.stated if row["id"] == entry["id"]]
    return f"{sum(row['agrees'] != 'no' for row in own)} of {len(own)}" if own else "none stated"
