# SPDX-License-Identifier: GPL-3.0-or-later
"""What the captions imply where the layout was not fitted: whether it is found, and how far chosen values may be moved."""
from page import count, escaped, number, rendered, words

IMPLIED = {"base_to_storage": ("base clockwise to the storage, 150 − angle", -1), "base_to_machine": ("base back to the machine, 67 − angle", 1),
           "elbow_at_machine": ("elbow up at the machine, 35", 1), "shoulder_at_machine": ("shoulder down there, 28", 1)}  # and the sign of what is shown
UNITS = {"mm": " mm", "deg": "°"}
FILES = {"predictions.csv": ["line", "angle_deg", "radius_mm", "basis", "elbow_at_storage_deg", "shoulder_at_storage_deg", "failure",
                             *(f"{name}_{which}" for name in IMPLIED for which in ("deg", "implied_deg"))],
         "sensitivity.csv": ["parameter", "unit", "value", "lowest", "highest", "below", "above"]}


def spoken(names):
    """Of implied angles."""
    return escaped(names.replace("_to_", " to the ").replace("_at_", " at the "))


def wrong(row):
    """The implied angles that a place has not; of a place where the process fails, all."""
    return [name for name in IMPLIED if row[f"{name}_deg"] != row[f"{name}_implied_deg"]]


def outcome(rows):
    """One sentence of all places that were not fitted, and one of each kind of those that fail."""
    predicted = [row for row in rows if row["basis"] == "predicted"]
    right = sum(not wrong(row) for row in predicted)
    failing = [row["failure"] for row in predicted if row["failure"]]
    reasons = "; ".join(f"{count(failing.count(reason))}: {escaped(reason)}" for reason in dict.fromkeys(failing))
    differing = len(predicted) - right - len(failing)
    return (f"At {count(right)} of {count(len(predicted))} places of the storage for which the layout was not fitted, the base's two turns, and elbow and "
            "shoulder at the machine, are what the captions imply."
            + (f" At {count(len(failing))} the process fails ({reasons})." if failing else "")
            + (f" At {count(differing)} an angle differs." if differing else ""))


def tightest(sensitivities):
    """For lengths and for angles, the value that may be moved least until an implied angle changes."""
    def room(row):
        """How far, and what then changes; without end where nothing does."""
        return min((abs(float(row[end]) - float(row["value"])) if row[end] else float("inf"), row[what])
                   for end, what in (("lowest", "below"), ("highest", "above")))

    least = {unit: min((row for row in sensitivities if row["unit"] == unit), key=room, default=None) for unit in UNITS}
    told = [f"the {escaped(row['parameter'])} by {number(room(row)[0], 2)}{UNITS[unit]} ({spoken(room(row)[1])})" for unit, row in least.items() if row]
    return f"The chosen values that can be moved least until one of these angles changes by a step: {words(told)}." if told else ""


def changes(row):
    """What changes beyond the range of a chosen value."""
    below, above = (spoken(row[end]) or "nothing" for end in ("below", "above"))
    return below if below == above else f"below: {below}; above: {above}"


def section(study):
    """HTML: the outcome, the places between the cases, and every chosen value; empty without places."""
    rows, sensitivities = (study.rows(file, **dict.fromkeys(columns, str)) for file, columns in FILES.items())
    cells = lambda row: [f"<span class='{'no' if name in wrong(row) else ''}'>{number(sign * float(row[f'{name}_deg'] or 'nan'))}</span>"
                         for name, (_, sign) in IMPLIED.items()]
    shown = sorted((row for row in rows if row["line"] == "between" or row["basis"] == "fitted"), key=lambda row: -float(row["angle_deg"]))
    return rendered("thesis_predictions.html", outcome=outcome(rows), tightest=tightest(sensitivities), heads=[head for head, _ in IMPLIED.values()],
                    places=[[f"{number(row['angle_deg'])}°", number(row["radius_mm"], 4), number(row["elbow_at_storage_deg"] or "nan"),
                             number(row["shoulder_at_storage_deg"] or "nan"), *cells(row), row["basis"]] for row in shown],
                    values=[[escaped(row["parameter"]), changes(row), number(row["value"]) + UNITS[row["unit"]], number(row["lowest"] or "nan"),
                             number(row["highest"] or "nan")] for row in sensitivities]) if rows else ""
