# SPDX-License-Identifier: GPL-3.0-or-later
"""Questions recorded from Bullet."""
from shares import upper_limit
from studies.recorded import Data
from values.latex import count, percent, power, table

KEYS = {"bullet": "doubles", "bullet-float": "floats"}


def cells(row):
    return [count(row["wrong"]), percent(row["wrong"] / row["questions"]) if row["wrong"] else rf"$<$\,{percent(row['upper'])}",
            "" if not row["wrong"] else power(row["furthest"]) if row["furthest"] else "0"]


def values(study):
    data = Data(study)
    if any(row["wrong"] for row in data.rows if row["method"] == "filtered"):
        raise ValueError("filtered differs from exact on recorded questions")
    yield "piles", count(data.piles())
    yield "piles-limit", percent(upper_limit(data.piles()))
    for simulation, key in KEYS.items():
        row = data.of_simulation(simulation)
        yield f"{key}/questions", count(row["questions"])
        yield f"{key}/wrong", percent(row["wrong"] / row["questions"])
        yield f"{key}/threshold-wrong", count(data.of_simulation(simulation, "with threshold")["wrong"])
    yield "doubles/near", percent(data.near["bullet", "own", 50])
    yield "floats/near", percent(data.near["bullet-float", "own", 20])


def tables(study):
    data = Data(study)
    rows = [["Bullet itself", *(cell for name in KEYS for cell in cells(data.of_simulation(name)))], None]
    rows += [[rf"\method{{{method}}}", *(cell for name in KEYS for cell in cells(data.at[name, "own", method]))] for method in data.methods]
    head = ["", *(rf"\multicolumn{{3}}{{c}}{{questions in {key}}}" for key in KEYS.values())]
    names = ["", *("wrong", "share", "furthest") * 2]
    yield "recorded", table("lrrrrrr", head, [names, None, *rows])
