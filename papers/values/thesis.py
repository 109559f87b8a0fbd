# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis's figures, and the area that its method takes for inside."""
from results import finite, natural, number
from values.latex import count, percent, table

KNOWN_ERRORS = "E."  # entries that are ours, about what is wrong with the method
STATUSES = ("reproduced with chosen values", "derived", "self-check", "photograph: not computable", "not computable", "differs")
DIFFERS = ["table 5.1"]  # as the text says: two other sources of the arm's lengths and reach

LAYOUT = {  # numbers of table 6.1 about how easily the layout fits
    "free-values": "values of the layout that are chosen freely", "captioned-moves": "captioned moves of both cases that it must reproduce",
    "home-poses": "home poses that were tried", "home-poses-share": "of these with a layout in which all captions hold"}


def layout(study):
    found = {row["what"]: row["ours"] for row in study.rows("numbers.csv", id=str, what=str, ours=number) if row["id"] == "table 6.1"}
    for key, what in LAYOUT.items():
        yield key, percent(found[what] / 100) if key.endswith("share") else count(round(found[what]))
    if found[LAYOUT["free-values"]] <= found[LAYOUT["captioned-moves"]]:
        raise ValueError("no more values of the layout are free than captions state, against the text")


def predicted(study):
    """The number of places that were not fitted, at all of which what the captions imply is found."""
    angles = ("base_to_storage", "base_to_machine", "elbow_at_machine", "shoulder_at_machine")
    rows = study.rows("predictions.csv", basis=str, **{f"{name}_{which}": str for name in angles for which in ("deg", "implied_deg")})
    places = [row for row in rows if row["basis"] == "predicted"]
    if any(row[f"{name}_deg"] != row[f"{name}_implied_deg"] for row in places for name in angles):
        raise ValueError("what the captions imply is not found at some place, against the text")
    return count(len(places))


def values(study):
    yield from layout(study)
    entries = [row for row in study.rows("entries.csv", id=str, status=str) if not row["id"].startswith(KNOWN_ERRORS)]
    if unknown := {row["status"] for row in entries} - set(STATUSES):
        raise ValueError(f"unknown status: {', '.join(sorted(unknown))}")
    counted = lambda *statuses: str(sum(row["status"] in statuses for row in entries))
    if (differing := [row["id"] for row in entries if row["status"] == "differs"]) != DIFFERS:
        raise ValueError(f"other figures differ than the text says: {', '.join(differing)}")
    yield "entries", str(len(entries))
    yield "chosen", counted("reproduced with chosen values")
    yield "self-checks", counted("self-check")
    yield "derived", counted("derived")
    yield "not-computable", counted("photograph: not computable", "not computable")
    turns = [row["degrees"] for row in study.rows("moves.csv", phase=str, joint=str, degrees=finite)
             if row["joint"] == "base" and row["phase"] in ("to-storage", "to-machine")]
    captioned = [abs(turn) for turn in turns]
    yield "base-turns", ", ".join(rf"{turn:g}\textdegree{{}}" for turn in captioned[:-1]) + rf" and {captioned[-1]:g}\textdegree{{}}"
    yield "predicted", predicted(study)
    areas = study.rows("areas.csv", outline=str, points=natural, share=finite, hull=finite)
    yield "points", count(min(row["points"] for row in areas))
    yield "worst-area-share", percent(max(row["share"] for row in areas))
    notched = [row for row in areas if row["hull"] > 0]
    if any(row["share"] <= row["hull"] for row in notched):
        raise ValueError("the hull takes no less for inside than the thesis's method somewhere, which the text does not say")
    yield "least-hull-share", percent(min(row["hull"] for row in notched))
    yield "worst-hull-share", percent(max(row["hull"] for row in notched))
    touching = study.rows("touching.csv", balls=natural, missed=natural)
    yield "touching-balls", count(sum(row["balls"] for row in touching))
    yield "touching-missed", count(sum(row["missed"] for row in touching))


def tables(study):
    rows = [[row["outline"], percent(row["share"]), f"{percent(row['lower'])} to {percent(row['upper'])}",
             percent(row["hull"]), str(row["parts"])]
            for row in study.rows("areas.csv", outline=str, share=finite, lower=finite, upper=finite, hull=finite, parts=natural)]
    yield "areas", table("lrrrr", ["outline", "wrongly inside", "limits", "in the hull", "convex parts"], rows)
