# SPDX-License-Identifier: GPL-3.0-or-later
"""What `touchstone bench` measured: bench.json, contestants by name."""
import json
import math
import re

import chart
from looks import look_of
from noise import TOO_NOISY, of_contestant
from page import count, escaped, multiple, percent, power, rounded
from results import DataError
from studies import OUTPUT, Run
from studies.soak import COLOURS as STAGES

RUN = Run(6, "what certainty costs", full=[["bench", "--output", OUTPUT]],
          quick=[["bench", "--family", "random-triangles,half-near,lattice-tangent,slivers,far,extreme,nearness,polygons-128", "--output", OUTPUT]],
          paper=[["bench", "--repetitions", "7", "--output", OUTPUT]])
TITLE = "Certainty, timed"
OTHERS = ("EPICK", "EPECK")


TRIANGLES = {  # family of balls and triangles: in words
    "random-triangles": "random triangles, balls anywhere", "half-near": "half of the balls at 2⁻⁵⁰ from contact",
    "lattice-tangent": "exactly tangent, on lattices", "slivers": "slivers of aspect 10⁻⁸",
    "far": "10⁶ sizes from the origin", "extreme": "extreme exponents"}


SETS = {  # of one ball and many triangles, of the family batches: in words
    "one ball, 1024 triangles": "triangles anywhere", "one ball, 1024 triangles, all near its surface": "all near the ball’s surface"}
SET, WITHOUT_FLOATS = "filtered, set", "filtered, no floats"


def read(study):
    """Each contest as bench.json has it, but its contestants by name."""
    path = study.folder / "bench.json"
    try:
        return [contest | {"contestants": {c["name"]: c for c in contest["contestants"]}}
                for contest in json.loads(path.read_text(encoding="utf-8"))["contests"]]
    except OSError as error:
        raise DataError(f"{path}: {error.strerror}") from None
    except (ValueError, KeyError, TypeError) as error:
        raise DataError(f"{path}: {type(error).__name__}: {error}") from None


def contests(study):
    """By (family, name): the contestants by name."""
    found = {(contest["family"], contest["name"]): contest["contestants"] for contest in read(study)}
    if missing := [family for family in TRIANGLES if (family, "") not in found]:
        raise DataError(f"{study.folder / 'bench.json'}: no contest {', '.join(missing)}")
    return found


def named(study, family):
    """The contests of a family, by name."""
    return {contest["name"]: contest for contest in read(study) if contest["family"] == family}


def sets(study):
    """Contestants of each kind of set, by its name; without those of a run that left sets out."""
    return {name: contest["contestants"] for name, contest in named(study, "batches").items() if name in SETS}


def polygons(all_contests):
    """By vertices: the contestants over all outlines together."""
    found = {}
    for (family, name), contestants in all_contests.items():
        if (size := re.fullmatch(r"polygons-(\d+)", family)) and name == "all outlines":
            found[int(size[1])] = contestants
    return dict(sorted(found.items()))


def is_noisy(ratio):
    """Whether `touchstone bench` found a ratio too noisy to tell."""
    return ratio.get("too_noisy", False)


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
            quoted, aim, *(multiple(contestants[other]["ratio"]["median"]) if is_quoted(contestants, other) else "" for other in others),
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
        return None
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
    ends = [measured[k]["contestants"]["filtered"] for k in (exponents[0], exponents[-1])]
    near, far = (rounded(each["nanoseconds"]["median"], 3) for each in ends) if all(map(of_contestant, ends)) else ("", "")
    return {"width": chart.LEFT + 670, "height": foot + 84, "svg": drawn, "near": near, "far": far,
            "title": "Nanoseconds a question against the distance of the radius from contact, for fast, filtered and two of CGAL's kernels; "
                     "below, the shares of filtered's stages."}


def break_even(vertices, own):
    """From how many questions on `filtered` is the faster one, in words. `own`: contestants by the number of questions."""
    even = next((n for n, c in own.items() if c["filtered"]["nanoseconds"]["median"] <= c["fast"]["nanoseconds"]["median"]), None)
    steady = all(of_contestant(c[name]) for n, c in own.items() if even is None or n <= even for name in ("fast", "filtered"))
    return f"{count(vertices)} vertices: " + (TOO_NOISY if not steady else f"not within {max(own)} questions" if even is None else f"by {even} questions")


def break_even_picture(study):
    """The time of a question when a polygon is asked n times, its preparation included."""
    panels = {}
    for vertices in (8, 32, 1024):
        own = {1 if name == "asked once" else int(name.split()[1]): c["contestants"] for name, c in named(study, f"polygons-{vertices}").items()
               if re.fullmatch(r"asked (once|\d+ times)", name)}
        if len(own) > 1:
            panels[vertices] = dict(sorted(own.items()))
    if not panels:
        return None
    drawn = ""
    for place, (vertices, own) in enumerate(panels.items()):
        curves = [chart.Curve(name, look_of(name).colour, "-", [(n, *spread(c[name]["nanoseconds"])) for n, c in own.items()]) for name in ("fast", "filtered")]
        values = [value for curve in curves for point in curve.points for value in point[1:]]
        panel = chart.Panel(chart.LEFT + place * 250, 60, 180, 200, list(own), [min(values) / 1.3, max(values) * 1.3])
        drawn += panel.frame([(n, str(n)) for n in own], ticks_of(min(values) / 1.3, max(values) * 1.3), f"{vertices:,} vertices", "questions to one polygon")
        drawn += "".join(map(panel.curve, curves)) + (chart.key(curves, chart.LEFT, 22, 150) if place == 0 else "")
    drawn += chart.text(14, 160, "nanoseconds a question", more='transform="rotate(-90 14 160)"')
    return {"width": chart.LEFT + 250 * len(panels), "height": 306, "svg": drawn, "said": [break_even(*item) for item in panels.items()],
            "title": "Nanoseconds a question with preparation, against the number of questions to one polygon, for fast and filtered."}


def relative(contestants, name):
    return multiple(contestants[name]["ratio"]["median"], 3) if is_quoted(contestants, name) else TOO_NOISY


def told(study):
    every = contests(study)
    ratios = [c["filtered"]["ratio"] for c in every.values() if "ratio" in c.get("filtered", {})]
    return {
        "steady": sum(not is_noisy(ratio) for ratio in ratios), "noisy": sum(map(is_noisy, ratios)), "queries": every["random-triangles", ""]["filtered"],
        "others": OTHERS, "too_noisy": TOO_NOISY, "nearness": nearness_picture(study), "break_even": break_even_picture(study),
        "heads": ["questions", "fast, ns", "filtered, ns", "filtered / fast", "goal", *(f"{other} / filtered" for other in OTHERS), "fast is wrong"],
        "ratios": [*(line(about, every[family, ""]) for family, about in TRIANGLES.items()),
                   *(line(f"polygons of {count(vertices)} vertices", contestants) for vertices, contestants in polygons(every).items())],
        "motions": [line(escaped(name), contestants, ("exact",)) for (family, name), contestants in every.items() if family == "motions"],
        "sets": [[SETS[name], relative(c, SET), relative(c, WITHOUT_FLOATS)] for name, c in sets(study).items()]}
