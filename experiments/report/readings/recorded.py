# SPDX-License-Identifier: GPL-3.0-or-later
"""What was asked of a pile of balls on a mesh that Bullet steps: its own answers, and those of methods."""
from readings.asked import Asked
from results import finite, natural, share


class Data:
    def __init__(self, study):
        rows = study.rows("recorded.csv", simulation=str, radius=str, method=str, questions=natural, touching=natural, wrong=natural,
                          upper=share, failed_piles=natural, piles=natural, furthest=finite)
        self.rows = rows
        self.simulations = list(dict.fromkeys(row["simulation"] for row in rows))
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
