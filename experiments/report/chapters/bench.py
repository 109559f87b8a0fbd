# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone bench`: times of the certified path beside those of plain doubles and CGAL's kernels."""
from page import code, count, escaped, multiple, percent, power, rounded, table, words
from readings.bench import TRIANGLES, contests, polygons

TITLE = "Certainty, timed"
OTHERS = ("EPICK", "EPECK")


def asked(study):
    return {}


def ratio_of(contestants, name="filtered"):
    return contestants[name]["ratio"]["median"]


def is_noisy(ratio):
    """Whether `touchstone bench` found a ratio too noisy to tell."""
    return ratio.get("too_noisy", False)


def finding(study):
    every = contests(study)
    sizes = polygons(every)
    most = max(sizes)
    if any(is_noisy(c["filtered"]["ratio"]) for c in (every["random-triangles", ""], every["half-near", ""], sizes[most])):
        return "<b>Time.</b> The times of this run are too noisy to tell what certainty costs."
    return (f"<b>Time.</b> Contact of a ball and a triangle took {code('filtered')} {multiple(ratio_of(every['random-triangles', '']), 3)} the time "
            f"of {code('fast')} with balls anywhere and {multiple(ratio_of(every['half-near', '']), 3)} with half of them at "
            f"{power('2', -50)} from contact; of a small ball and a prepared polygon of {count(most)} vertices "
            f"{multiple(ratio_of(sizes[most]))}.")


def is_quoted(contestants, name):
    return "ratio" in contestants.get(name, {}) and not is_noisy(contestants[name]["ratio"])


def line(about, contestants, others=OTHERS):
    ours, fast = contestants["filtered"], contestants["fast"]
    ratio, goal, wrong = ours["ratio"], ours.get("goal"), fast.get("wrong")
    if is_noisy(ratio):
        quoted, aim = "too noisy to tell", ""
    else:
        quoted = (f"{multiple(ratio['median'], 3)}<br><small>{rounded(ratio['lower_quartile'], 3)} to "
                  f"{rounded(ratio['upper_quartile'], 3)}</small>")
        aim = "" if goal is None else (f"at most {goal['at_most']:g}: " + ("met" if goal["met"] else '<b class="no">missed</b>'))
    return [about, *(f"{count(round(c['nanoseconds']['median']))}" for c in (fast, ours)),
            quoted, aim, *(multiple(ratio_of(contestants, other)) if is_quoted(contestants, other) else "" for other in others),
            "" if not wrong else percent(wrong["count"] / wrong["of"]) if wrong["count"] else "none"]


def motions_table(every):
    """Empty where moving balls were not asked about."""
    rows = [line(escaped(name), contestants, ("exact",)) for (family, name), contestants in every.items() if family == "motions"]
    head = ["moving balls", "fast, ns", "filtered, ns", "filtered / fast", "goal", "exact / filtered", "fast is wrong"]
    return table("The same of moving balls: contact, and first contact with time, feature and point. Motions past triangles lead from "
                 "anywhere to anywhere; those of polygons pass near the plane.", head, rows, range(1, len(head))) if rows else ""


def chapter(study):
    every = contests(study)
    rows = [line(escaped(about), every[family, ""]) for family, about in TRIANGLES.items()]
    rows += [line(f"polygons of {count(vertices)} vertices", contestants) for vertices, contestants in polygons(every).items()]
    queries = every["random-triangles", ""]["filtered"]
    head = ["questions", "fast, ns", "filtered, ns", "filtered / fast", "goal", *(f"{other} / filtered" for other in OTHERS), "fast is wrong"]
    return f"""<p>{code('fast')}, {code('filtered')} and two of CGAL's kernels answer contact, yes or no, in turns, in one run on one
core: {count(queries['asked'])} distinct questions of each kind, {count(len(queries['ratio']['repetitions']))} turns, medians. Polygons
are prepared; the balls are small and near their planes. CGAL's {words([code(other) for other in OTHERS])} (inexact and exact constructions) are
asked about triangles where their questions are the same.</p>""" + table(
        "Nanoseconds per question, and ratios within the same run: median, and quartiles below it.", head, rows,
        range(1, len(head))) + motions_table(every)
