# SPDX-License-Identifier: GPL-3.0-or-later
"""What the report says over all studies: the verdict (an outcome that is wrong, what never was and what backs it, the price, and how to
use it), the methods that never failed, and what each method is."""
import reach
from looks import EXACT, rounds
from names import DISTANCES, NAMED, of_method
from page import code, count, escaped, percent, rendered, rounded, upper_limit
from results import DataError
from studies import bench, cell, meshes, near_edge

CERTIFIED, TRUTH = "filtered", "exact"  # must never fail; is right by definition
PLAIN = "fast"


def sums(asked, method):
    """Sums over all studies: answers, wrong answers, and polygons or other trials."""
    own = [counts[method] for counts in asked.values() if method in counts]
    return sum(a.answers for a in own), sum(a.wrong for a in own), sum(a.trials for a in own)


def at_contact(found, method):
    """Wrong answers within u x size of contact with exactly planar polygons, and all."""
    return near_edge.at_contact(near_edge.Data(found["near-edge"]), method) if "near-edge" in found else (0, 0)


def outcome(found):
    """What plain doubles get wrong: about real meshes if they were asked, else about random polygons."""
    real = meshes.Data(found["meshes"]) if "meshes" in found else None
    wrong, of = real.counts(PLAIN) if real else at_contact(found, PLAIN)
    return {"real": sum(real.faces.values()) if real else 0, "share": wrong / of if wrong else 0, "answers": of}


def furthest(found):
    """Of a wrong answer of plain doubles that random samples or a search found, on a polygon of 1 m: at the origin and far away."""
    data = near_edge.Data(found["near-edge"]) if "near-edge" in found else None
    if data is None or not data.distances or PLAIN not in data.methods:
        return None
    return [(DISTANCES[distance], reach.length(share) if share else "none") for distance in (data.distances[0], data.distances[-1])
            for share in (data.furthest(PLAIN, distance),)]


def price(study):
    """Of questions for which neither side has a hierarchy; None if the times of this run are too noisy to tell."""
    ratio = bench.contests(study)["random-triangles", ""]["filtered"]["ratio"]
    return None if bench.is_noisy(ratio) else {"ratio": ratio["median"], "turns": len(ratio["repetitions"]),
                                               "lower": rounded(ratio["lower_quartile"], 3), "upper": rounded(ratio["upper_quartile"], 3)}


def who(asked):
    """Which methods were wrong anywhere, by whether they bound the errors of floats and doubles."""
    methods = list(dict.fromkeys(method for counts in asked.values() for method in counts))
    unbounded = [m for m in methods if rounds(m)]
    return {"unbounded": len(unbounded), "wrong": sum(sums(asked, m)[1] > 0 for m in unbounded),
            "sure": [code(m) for m in methods if m in EXACT - {TRUTH} and not sums(asked, m)[1]]}


def verdict(found, asked):
    """`found`: the studies; `asked`: of each, how often methods were asked."""
    answers, wrong, _ = sums(asked, CERTIFIED)
    contact = None if "near-edge" not in found else [
        f"{of_method(m)} {percent(failed / of)}" for m in near_edge.Data(found["near-edge"]).methods if m in NAMED
        for failed, of in (at_contact(found, m),) if failed]
    return rendered(
        "verdict.html", plain=NAMED[PLAIN], outcome=outcome(found), furthest=furthest(found), answers=answers, wrong=wrong, contact=contact, who=who(asked),
        studies=sum(CERTIFIED in counts for counts in asked.values()), soak=asked["soak"][CERTIFIED].trials if "soak" in asked else 0,
        price=price(found["bench"]) if "bench" in found else None,
        consequence=cell.consequence(found["cell"]) if "cell" in found else None)


def never_failed(asked, titles):
    """With limits from the number of answers in each study; empty where the certified method was not asked."""
    certified = {name: counts[CERTIFIED] for name, counts in asked.items() if CERTIFIED in counts}
    methods = dict.fromkeys(m for counts in asked.values() for m in counts if m not in (CERTIFIED, TRUTH))
    never = [m for m in methods if sums(asked, m)[1] == 0 and sums(asked, m)[2] >= 100]
    unsure = {m: sum(counts[m].unsure for counts in asked.values() if m in counts) for m in never}
    rows = [[f'<a href="#{name}">{escaped(titles[name])}</a>', count(a.answers), f"{count(a.trials)} {escaped(a.trial)}", count(a.wrong),
             "none: it failed" if a.wrong else percent(upper_limit(a.trials))] for name, a in certified.items()]
    return rendered("never_failed.html", rows=rows, failed=[escaped(titles[name]) for name, a in certified.items() if a.wrong],
                    right=[code(m) for m in never if not unsure[m]],
                    unsure=[{"method": m, "times": n, "answers": sums(asked, m)[0]} for m, n in unsure.items() if n]) if rows else ""


def methods(results):
    """Names and summaries, from the output of `touchstone methods`, which ./reproduce keeps; None if it was not kept."""
    path = results / "methods.txt"
    if not path.exists():
        return None
    entries = {}
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        name, _, about = line.partition(" ")
        if not name or not about.strip():
            raise DataError(f"{path}: line {number}: no name and summary of a method")
        entries[name] = about.strip()
    return entries
