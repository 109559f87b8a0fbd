# SPDX-License-Identifier: GPL-3.0-or-later
"""Every face of real meshes: how often methods are wrong about it."""
from readings.asked import by_method
from results import natural


class Data:
    def __init__(self, study):
        self.rows = study.rows("meshes.csv", mesh=str, faces=natural, rejected=natural, method=str, place=str, test=str,
                               trials=natural, wrong=natural)
        self.faces = {row["mesh"]: row["faces"] - row["rejected"] for row in self.rows}
        self.methods = list(dict.fromkeys(row["method"] for row in self.rows))

    def counts(self, method, test="contact", mesh="", place=""):
        """Wrong answers and all, in the meshes whose name begins so; at a place of the ball, or at all where the answer is hard:
        balls of ample radius over a foot near an edge say nothing about the final answer."""
        rows = [row for row in self.rows if row["method"] == method and row["test"] == test and row["mesh"].startswith(mesh)
                and (row["place"] == place if place else (test, row["place"]) != ("contact", "foot"))]
        return sum(row["wrong"] for row in rows), sum(row["trials"] for row in rows)

    @property
    def folders(self):
        return list(dict.fromkeys(mesh.split("/")[0] for mesh in self.faces))


def asked(study):
    """The final answers, but those about balls of ample radius over a foot near an edge: there only the foot is hard to tell."""
    data = Data(study)
    faces = sum(data.faces.values())
    return by_method([dict(row, answers=row["trials"]) for row in data.rows if row["test"] == "contact" and row["place"] != "foot"],
                     dict.fromkeys(data.methods, faces), "faces")
