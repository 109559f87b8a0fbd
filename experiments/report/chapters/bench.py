# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone bench`: times of the certified path beside those of plain doubles and CGAL's kernels."""
import math
import re

import chart
from looks import look_of
from noise import TOO_NOISY, of_contestant
from page import code, count, counted, escaped, folded, multiple, percent, power, rounded, table, words
from readings.bench import STAGE_COLOURS as STAGES
from readings.bench import SET, SETS, TRIANGLES, WITHOUT_FLOATS, contests, named, polygons, sets

TITLE = "Certainty, timed"
OTHERS = ("EPICK", "EPECK")


def asked(study):
    return {}


def ratio_of(contestants, name="filtered"):
    return contestants[name]["ratio"]["median"]


def is_noisy(ratio):
    """Whether `touchstone bench` found a ratio too noisy to tell."""
    return ratio.get("too_noisy", False)


def price(study):
    """One number in words, of questions for which neither side has a hierarchy; empty if the times of this run are too noisy to tell."""
    ratio = contests(study)["random-triangles", ""]["filtered"]["ratio"]
    if is_noisy(ratio):
        return ""
    return (f"contact of a triangle and a ball anywhere took {code('filtered')} {multiple(ratio['median'], 3)} the time of {code('fast')} (quartiles of "
            f"{counted(len(ratio['repetitions']), 'repetitions')} in turns: {rounded(ratio['lower_quartile'], 3)} to {rounded(ratio['upper_quartile'], 3)}); near contact and about "
            'polygons: <a href="#bench">certainty, timed</a>.')


def finding(study):
    every = contests(study)
    noisy = sum(is_noisy(c["filtered"]["ratio"]) for c in every.values() if "ratio" in c.get("filtered", {}))
    told = sum("ratio" in c.get("filtered", {}) for c in every.values()) - noisy
    return f"{count(told)} ratios of {code('filtered')} to {code('fast')} were measured" + (
        f"; {count(noisy)} more are too noisy to tell." if noisy else ".")


def is_quoted(contestants, name):
    return "ratio" in contestants.get(name, {}) and not is_noisy(contestants[name]["ratio"])


def line(about, contestants, others=OTHERS):
    ours, fast = contestants["filtered"], contestants["fast"]
    ratio, goal, wrong = ours["ratio"], ours.get("goal"), fast.get("wrong")
    if is_noisy(ratio):
        quoted, aim = TOO_NOISY, ""
    else:
        quoted = (f"{multiple(ratio['median'], 3)}<br><small>{rounded(ratio['lower_quartile'], 3)} to "
                  f"{rounded(ratio['upper_quartile'], 3)}</small>")
        aim = "" if goal is None else (f"at most {goal['at_most']:g}: " + ("met" if goal["met"] else '<b class="no">missed</b>'))
    return [about, *(f"{count(round(c['nanoseconds']['median']))}" if of_contestant(c) else TOO_NOISY for c in (fast, ours)),
            quoted, aim, *(multiple(ratio_of(contestants, other)) if is_quoted(contestants, other) else "" for other in others),
            "" if not wrong else percent(wrong["count"] / wrong["of"]) if wrong["count"] else "none"]


CURVES = {"fast": ("fast", "-"), "filtered": ("filtered", "-"), "EPICK": ("cgal-epick", "--"), "EPECK": ("cgal-epeck", ":")}


def spread(nanoseconds):
    return nanoseconds["median"], nanoseconds["lower_quartile"], nanoseconds["upper_quartile"]


def ticks_of(low, high):
    """Powers of ten, and where there are few, their doubles and fives."""
    steps = (1,) if high > 300 * low else (1, 2, 5)
    return [(m * 10.0**k, f"{m * 10**k:,}") for k in range(math.floor(math.log10(low)), math.floor(math.log10(high)) + 1) for m in steps if low <= m * 10**k <= high]


def nearness_picture(study):
    """Cost against the distance of the radius from contact, and which stage decided."""
    measured = {int(name.removeprefix("2^-")): c for name, c in named(study, "nearness").items()}
    if not measured:
        return ""
    exponents = sorted(measured, reverse=True)
    curves = [chart.Curve(name, look_of(look).colour, line, [(2.0**-k, *spread(measured[k]["contestants"][name]["nanoseconds"])) for k in exponents])
              for name, (look, line) in CURVES.items() if all(name in measured[k]["contestants"] for k in exponents)]
    values = [value for curve in curves for point in curve.points for value in point[1:]]
    panel = chart.Panel(chart.LEFT, 46, 640, 230, [2.0**-k for k in exponents], [min(values) / 1.2, max(values) * 1.2])
    ticks = [(2.0**-k, power("2", -k)) for k in exponents if k not in (50, 46)]
    foot = panel.top + panel.height + 62
    drawn = panel.frame([], ticks_of(min(values) / 1.2, max(values) * 1.2), "", "") + "".join(map(panel.curve, curves)) + chart.key(curves, chart.LEFT, 22, 150)
    drawn += chart.text(14, panel.top + panel.height / 2, "nanoseconds a question", more=f'transform="rotate(-90 14 {panel.top + panel.height / 2})"')
    shares = [[measured[k]["shares"][stage] for stage in STAGES] for k in exponents]
    drawn += chart.columns(panel, [2.0**-k for k in exponents], shares, STAGES.values(), foot - 50, 70)
    drawn += "".join(chart.text(panel.at(x, 1)[0], foot + 36, words) for x, words in ticks)
    drawn += chart.text(chart.LEFT + 320, foot + 54, "how far the radius is from the exact distance, as a share of it")
    drawn += "".join(f'<rect x="{chart.LEFT + 128 * i}" y="{foot + 66}" width="12" height="12" fill="{colour}" stroke="none"/>'
                     + chart.text(chart.LEFT + 128 * i + 18, foot + 76, stage, "start") for i, (stage, colour) in enumerate(STAGES.items()))
    drawn += chart.text(chart.LEFT - 12, foot - 10, "decided by", "end", 'font-size="10"')
    near, far = (measured[k]["contestants"]["filtered"] for k in (exponents[0], exponents[-1]))
    follows = (f"{code('filtered')} takes {rounded(far['nanoseconds']['median'], 3)} ns far from contact and {rounded(near['nanoseconds']['median'], 3)} ns at it."
               if of_contestant(near) and of_contestant(far) else f"in this run the times are {TOO_NOISY}.")
    return chart.figure(chart.LEFT + 670, foot + 84, "Nanoseconds a question against the distance of the radius from contact, for fast, filtered and two of CGAL's kernels; "
                        "below, the shares of filtered's stages.", drawn,
                        f"Cost against nearness: the same triangles, the radius ever nearer to the exact distance; medians and quartiles. Below: the slowest stage "
                        f"that {code('filtered')} needed. <b>What follows:</b> {follows}")


def break_even_picture(study):
    """The time of a question when a polygon is asked n times, its preparation included."""
    panels = {}
    for vertices in (8, 32, 1024):
        own = {1 if name == "asked once" else int(name.split()[1]): c["contestants"] for name, c in named(study, f"polygons-{vertices}").items()
               if re.fullmatch(r"asked (once|\d+ times)", name)}
        if len(own) > 1:
            panels[vertices] = dict(sorted(own.items()))
    if not panels:
        return ""
    drawn, said = "", []
    for place, (vertices, own) in enumerate(panels.items()):
        curves = [chart.Curve(name, look_of(name).colour, "-", [(n, *spread(c[name]["nanoseconds"])) for n, c in own.items()]) for name in ("fast", "filtered")]
        values = [value for curve in curves for point in curve.points for value in point[1:]]
        panel = chart.Panel(chart.LEFT + place * 250, 60, 180, 200, list(own), [min(values) / 1.3, max(values) * 1.3])
        drawn += panel.frame([(n, str(n)) for n in own], ticks_of(min(values) / 1.3, max(values) * 1.3), f"{vertices:,} vertices", "questions to one polygon")
        drawn += "".join(map(panel.curve, curves)) + (chart.key(curves, chart.LEFT, 22, 150) if place == 0 else "")
        even = next((n for n, c in own.items() if c["filtered"]["nanoseconds"]["median"] <= c["fast"]["nanoseconds"]["median"]), None)
        steady = all(of_contestant(c[name]) for n, c in own.items() if even is None or n <= even for name in ("fast", "filtered"))
        said.append(f"{count(vertices)} vertices: " + (TOO_NOISY if not steady else f"not within {max(own)} questions" if even is None else f"by {even} questions"))
    drawn += chart.text(14, 160, "nanoseconds a question", more='transform="rotate(-90 14 160)"')
    return chart.figure(chart.LEFT + 250 * len(panels), 306, "Nanoseconds a question with preparation, against the number of questions to one polygon, for fast and filtered.", drawn,
                        f"Break-even: time of a question, the polygon's preparation included, when it is asked so often. {code('filtered')} builds a hierarchy of edges when "
                        f"the first question needs it. <b>What follows:</b> {code('filtered')} is the faster one for {'; '.join(said)}.")


def motions_table(every):
    """Empty where moving balls were not asked about."""
    rows = [line(escaped(name), contestants, ("exact",)) for (family, name), contestants in every.items() if family == "motions"]
    head = ["moving balls", "fast, ns", "filtered, ns", "filtered / fast", "goal", "exact / filtered", "fast is wrong"]
    return table("The same of moving balls: contact, and first contact with time, feature and point. Motions past triangles lead from "
                 "anywhere to anywhere; those of polygons pass near the plane.", head, rows, range(1, len(head))) if rows else ""


def variants_table(study):
    """What a stage saves; empty where it was not measured."""
    found = {name: contest["contestants"] for name, contest in named(study, "variants").items()}
    if not found:
        return ""
    names = [name for name in next(iter(found.values())) if name != "filtered"]
    rows = [[escaped(name), *(multiple(c[name]["ratio"]["median"], 3) if is_quoted(c, name) else TOO_NOISY for c in found.values())] for name in names]
    return table(f"{code('filtered')} without one of its stages, or with other exact arithmetic behind the first: times over those of {code('filtered')} on the same "
                 "questions. Every variant answers as exact arithmetic does.", ["variant", *map(escaped, found)], rows, range(1, len(found) + 1))


def sets_table(study):
    """What floats save where one ball is compared with many triangles; empty where it was not measured."""
    rows = [[SETS[name], multiple(c[SET]["ratio"]["median"], 3) if is_quoted(c, SET) else TOO_NOISY,
             multiple(c[WITHOUT_FLOATS]["ratio"]["median"], 3) if is_quoted(c, WITHOUT_FLOATS) else TOO_NOISY]
            for name, c in sets(study).items()]
    return table(f"One ball and 1,024 triangles that are prepared as a set: {code('filtered')} relative to {code('fast')}, one triangle after the other; and the "
                 "same set without its floats, relative to itself.", ["triangles", "set / fast", "without floats / set"], rows, (1, 2)) if rows else ""


def chapter(study):
    every = contests(study)
    rows = [line(escaped(about), every[family, ""]) for family, about in TRIANGLES.items()]
    rows += [line(f"polygons of {count(vertices)} vertices", contestants) for vertices, contestants in polygons(every).items()]
    queries = every["random-triangles", ""]["filtered"]
    head = ["questions", "fast, ns", "filtered, ns", "filtered / fast", "goal", *(f"{other} / filtered" for other in OTHERS), "fast is wrong"]
    return f"""<p>{code('fast')}, {code('filtered')} and two of CGAL's kernels answer contact, yes or no, in turns, in one run on one
core: {count(queries['asked'])} distinct questions of each kind, {count(len(queries['ratio']['repetitions']))} turns, medians. Polygons
are prepared; the balls are small and near their planes. CGAL's {words([code(other) for other in OTHERS])} (inexact and exact constructions) are
asked about triangles where their questions are the same.</p>""" + f'<div class="pair">{nearness_picture(study)}{break_even_picture(study)}</div>' + folded(
        "Every ratio: families of triangles, polygons, moving balls", table(
            "Nanoseconds per question, and ratios within the same run: median, and quartiles below it.", head, rows,
            range(1, len(head))) + motions_table(every)) + folded("What each stage saves", variants_table(study) + sets_table(study))
