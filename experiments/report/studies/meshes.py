# SPDX-License-Identifier: GPL-3.0-or-later
"""Every face of real meshes: how often methods are wrong about it."""
from names import NAMED, of_method
from page import bar, code, count, escaped, percent
from asked import by_method
from results import distinct, natural
from studies import MESHES, OUTPUT, Run, same

RUN = Run(1, "every face of real meshes", **same([
    "near-edge", MESHES, "--skip-bad", "--methods", "exact,filtered,fast,fast-float,fast-long-double,fast-double-double,cgal-double,cgal-epick,"
    "thesis,thesis-float,thesis-signed,thesis-newell,thesis-closed", "--output", OUTPUT]),
          tiny=["near-edge", MESHES, "--methods", "exact,filtered,fast,cgal-double,thesis"])
TITLE = "Real input: every face of a robot cell"
TRUTH = "exact"  # with which all are compared, itself included
TESTS = ("plane", "foot", "edges", "contact")


class Data:
    def __init__(self, study):
        self.rows = study.rows("meshes.csv", mesh=str, faces=natural, rejected=natural, method=str, place=str, test=str,
                               trials=natural, wrong=natural)
        self.faces = {row["mesh"]: row["faces"] - row["rejected"] for row in self.rows}
        self.methods = distinct(self.rows, "method")

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


def rate(wrong, trials):
    return bar(wrong / trials, percent(wrong / trials)) if wrong else "0"


def told(study):
    data, all_asked = Data(study), asked(study)
    methods = data.methods
    by_machine = [[escaped(folder), str(sum(mesh.startswith(folder + "/") for mesh in data.faces)),
                   count(sum(n for mesh, n in data.faces.items() if mesh.startswith(folder + "/"))),
                   *(percent(wrong / trials) if wrong else "0" for wrong, trials in (data.counts(m, mesh=folder + "/") for m in methods))]
                  for folder in data.folders]
    ordered = sorted(({"rate": data.counts(m)[0] / data.counts(m)[1], "method": m} for m in methods), key=lambda each: (each["rate"], each["method"]))
    return {
        "faces": sum(data.faces.values()), "meshes": len(data.faces), "machines": len(data.folders),
        "final_answers": max(a.answers for a in all_asked.values()),
        "failing": [f"{of_method(m)} {percent(a.wrong / a.answers)}" for m, a in all_asked.items() if a.wrong and m in NAMED],
        "never": [code(m) for m, a in all_asked.items() if not a.wrong and m != TRUTH],
        "rejected": sum(row["rejected"] for row in {row["mesh"]: row for row in data.rows}.values()),
        "least": next((each for each in ordered if each["rate"]), None), "most": ordered[-1], "methods": [code(m) for m in methods],
        "by_test": [[code(m), *(rate(*data.counts(m, test)) for test in TESTS)] for m in methods], "by_machine": by_machine,
        "plane_answers": data.counts(methods[0], "plane")[1], "contact_answers": data.counts(methods[0])[1]}
