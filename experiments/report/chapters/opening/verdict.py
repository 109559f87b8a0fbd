# SPDX-License-Identifier: GPL-3.0-or-later
"""The verdict: an outcome that is wrong, what never was and what backs it, the price, and how to use it. Every sentence is made of the data."""
from chapters import bench, cell, near_edge
from chapters.opening import never_failed, stress
from methods import EXACT, rounds
from names import NAMED, NEARNESSES, of_method
from page import code, count, percent, upper_limit, words
from readings import near_edge as near_edge_readings
from readings import stability as stability_readings

PLAIN, AMPLE = "fast", "ample"


def at_contact(found, method):
    """Wrong answers within one double of contact, and all."""
    return near_edge.at_contact(near_edge_readings.Data(found["near-edge"]), method) if "near-edge" in found else (0, 0)


def outcome(found):
    """What plain doubles get wrong: far from contact if the data say so, else at it."""
    if "stability" in found:
        failed, polygons = stability_readings.Data(found["stability"]).failed(PLAIN, AMPLE)
        if failed:
            return f"With the {NEARNESSES[AMPLE]}, {NAMED[PLAIN]} are wrong about {percent(failed / polygons)} of the polygons under stress."
    wrong, of = at_contact(found, PLAIN)
    return f"Within one double of contact, {NAMED[PLAIN]} are wrong in {percent(wrong / of)} of the answers." if wrong else ""


def headline(found, asked):
    answers, failed, _ = never_failed.sums(asked, never_failed.CERTIFIED)
    certified = code(never_failed.CERTIFIED)
    if failed:
        return f"{outcome(found)} {certified} was wrong, too, against its guarantee."
    return f"{outcome(found)} {certified} was {f'never wrong in {counted_studies(asked)}' if answers else 'not asked'}, and error bounds of its filters are proved."


def counted_studies(asked):
    n = sum(never_failed.CERTIFIED in counts for counts in asked.values())
    return "the study below" if n == 1 else f"any of {n} studies"


def how_often(found):
    if "near-edge" not in found:
        return []
    said = words(f"{of_method(m)} {percent(wrong / of)}" for m in near_edge_readings.Data(found["near-edge"]).methods if m in NAMED
                 for wrong, of in (at_contact(found, m),) if wrong)
    if not said:
        return ["<b>At contact:</b> no method was wrong within one double of contact."]
    return [f"<b>At contact:</b> with the radius within one double of the exact distance to a random polygon, wrong answers of {said}."]


def who(asked):
    """Which methods were wrong anywhere, by whether they bound the errors of floats and doubles."""
    methods = list(dict.fromkeys(method for counts in asked.values() for method in counts))
    unbounded = [m for m in methods if rounds(m)]
    wrong = [m for m in unbounded if never_failed.sums(asked, m)[1]]
    sure = [m for m in methods if m in EXACT - {never_failed.TRUTH} and not never_failed.sums(asked, m)[1]]
    if not unbounded:
        return []
    which = "All" if len(wrong) == len(unbounded) else f"{count(len(wrong))} of"
    text = f"<b>Who:</b> {which} {count(len(unbounded))} methods that compute in floats or doubles without bounding their errors were wrong somewhere."
    return [text + (f" Of those that bound them or calculate exactly, these never were: {words(map(code, sure))}." if sure else "")]


def how_sure(asked):
    if "soak" not in asked or never_failed.sums(asked, never_failed.CERTIFIED)[1]:
        return []
    own = asked["soak"][never_failed.CERTIFIED]
    return [f"<b>How sure:</b> {code(never_failed.CERTIFIED)} differed from exact arithmetic in none of {count(own.trials)} adversarial cases, so at 95 % confidence it "
            f"does in fewer than {percent(upper_limit(own.trials))} of such cases. Gappa proves the error bounds of its filters' expressions, from records that the source "
            f"templates write of themselves, and fails to prove smaller ones; Coq can check the proofs. What combines the signs is tested, not proved."]


def price(found):
    said = bench.price(found["bench"]) if "bench" in found else ""
    return [f"<b>Price:</b> {said}"] if said else []


USE = ("<b>Use it:</b> a C++20 library with two lines of CMake, <code>find_package(Touchstone REQUIRED)</code> and <code>target_link_libraries(yours PRIVATE "
       "touchstone::robust)</code>, or from Python; <code>bindings/playground/README.md</code> says how to drag a ball in a browser until doubles are dots.")


def pictures(found):
    parts = []
    if "stability" in found and (drawn := stress.picture(stability_readings.Data(found["stability"]), AMPLE)):
        parts.append(f"<figure>{drawn}<figcaption><b>Not only in the last digit.</b> Polygons under stress (slivers, tiny and huge numbers, far from the origin and others) with "
                     f"a wrong answer, the {NEARNESSES[AMPLE]}.</figcaption></figure>")
    if "cell" in found and (consequence := cell.consequence(found["cell"])):
        parts.append(f"<figure>{consequence.drawing}<figcaption><b>A wrong answer changes what the robot does.</b> {consequence.words}</figcaption></figure>")
    return f'<div class="parts">{"".join(parts)}</div>' if parts else ""


def box(found, asked):
    lines = [*never_failed.warning(asked), *how_sure(asked), *price(found), USE, *how_often(found), *who(asked)]
    return (f'<section class="verdict"><h2 id="verdict">Verdict</h2><p class="headline">{headline(found, asked)}</p>{pictures(found)}<ul>'
            + "".join(f"<li>{line}</li>" for line in lines) + "</ul></section>")
