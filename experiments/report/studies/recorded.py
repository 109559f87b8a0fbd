# SPDX-License-Identifier: GPL-3.0-or-later
"""What was asked of a pile of balls on a mesh that Bullet steps: its own answers, and those of methods."""
from asked import Asked
from page import code, count, percent, power, share_of_size
from results import distinct, finite, natural, share
from studies import OUTPUT, Run

RUN = Run(8, "questions of a third-party simulation",
          full=[["recorded", "--output", OUTPUT]], paper=[["recorded", "--samples", "40", "--output", OUTPUT]],
          tiny=["recorded", "--methods", "fast,filtered", "--samples", "1", "--balls", "6", "--steps", "90"])
TITLE = "Questions recorded from a simulation"
BUILDS = {"bullet": "doubles", "bullet-float": "floats"}


class Data:
    def __init__(self, study):
        rows = study.rows("recorded.csv", simulation=str, radius=str, method=str, questions=natural, touching=natural, wrong=natural,
                          upper=share, failed_piles=natural, piles=natural, furthest=finite)
        self.rows = rows
        self.simulations = distinct(rows, "simulation")
        self.methods = list(dict.fromkeys(row["method"] for row in rows if row["method"] not in self.simulations))
        self.at = {(row["simulation"], row["radius"], row["method"]): row for row in rows}
        self.near = {(row["simulation"], row["radius"], row["exponent"]): row["near"] / row["questions"]
                     for row in study.rows("near.csv", simulation=str, radius=str, exponent=natural, near=natural, questions=natural) if row["questions"]}

    def of_simulation(self, simulation, radius="own"):
        """The answers that it got itself."""
        return self.at[simulation, radius, simulation]

    def piles(self):
        return self.rows[0]["piles"]


def asked(study):
    """About the balls as they are. Both builds step the same piles."""
    data = Data(study)
    found = {}
    for (_, radius, method), row in data.at.items():
        if radius == "own":
            answers, wrong = found.get(method, (0, 0))
            found[method] = answers + row["questions"], wrong + row["wrong"]
    return {method: Asked(answers, wrong, data.piles(), "piles") for method, (answers, wrong) in found.items()}


def wrong_of(row):
    if row is None:
        return ["", ""]
    if not row["wrong"]:
        return [f"none (&lt; {percent(row['upper'])})", ""]
    return [percent(row["wrong"] / row["questions"]), share_of_size(row["furthest"]) if row["furthest"] else "0"]


def told(study):
    data = Data(study)
    own = {name: data.of_simulation(name) for name in data.simulations}
    return {
        "data": data, "ours": sum(row["wrong"] for row in data.rows if row["method"] == "filtered"),
        "wrong": [f"{percent(row['wrong'] / row['questions'])} of {count(row['questions'])} questions in {BUILDS[name]}"
                  for name, row in own.items() if row["questions"]],
        "near": [f"{percent(data.near[name, 'own', k])} within {power('2', -k)} in {BUILDS[name]}"
                 for name, k in (("bullet", 50), ("bullet-float", 20)) if (name, "own", k) in data.near],
        "heads": ["method", *(title for name in own for title in (f"wrong, questions in {BUILDS[name]}", "furthest"))],
        "rows": [["the simulation itself", *(cell for row in own.values() for cell in wrong_of(row))],
                 *([code(method), *(cell for name in own for cell in wrong_of(data.at.get((name, "own", method))))] for method in data.methods)]}
