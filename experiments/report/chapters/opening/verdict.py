# SPDX-License-Identifier: GPL-3.0-or-later
"""The verdict: a headline, a picture and three lines: how often, how far, at what price."""
from chapters import bench, near_edge, tradeoff
from chapters.opening import never_failed, reach
from methods import rounds
from names import NAMED, of_method
from page import code, count, percent, words
from readings import near_edge as near_edge_readings


def headline(asked):
    methods = [m for m in dict.fromkeys(method for counts in asked.values() for method in counts) if rounds(m)]
    wrong = [method for method in methods if never_failed.sums(asked, method)[1]]
    which = "every method that computes" if len(wrong) == len(methods) else f"{count(len(wrong))} of {count(len(methods))} methods that compute"
    text = f"Near contact, {which} in floats or doubles gave wrong answers; " if wrong else ""
    answers, failed, _ = never_failed.sums(asked, never_failed.CERTIFIED)
    certified = f"{code(never_failed.CERTIFIED)}, which decides exactly, "
    if failed:
        return text + certified + "gave some, against its guarantee."
    return text + certified + (f"gave {'none' if wrong else 'no wrong answer'} in {count(answers)} questions." if answers else "was not asked.")


def how_often(found):
    if "near-edge" not in found:
        return []
    data = near_edge_readings.Data(found["near-edge"])
    rates = {m: near_edge.at_contact(data, m) for m in data.methods}
    said = words(f"{of_method(m)} {percent(wrong / of)}" for m, (wrong, of) in rates.items() if m in NAMED and of and wrong)
    if not said:
        return ["<b>How often:</b> no method was wrong within one double of contact."]
    return [f"<b>How often:</b> with the radius within one double of the exact distance to a random polygon, wrong answers of {said}."]


def how_far(found):
    if "near-edge" not in found or not (data := near_edge_readings.Data(found["near-edge"])).distances:
        return []
    return [f"<b>How far:</b> {near_edge.furthest_sentence(data)}"]


def what_it_costs(found):
    said = bench.price(found["bench"]) if "bench" in found else ""
    if not said and "tradeoff" in found:
        said = tradeoff.price(found["tradeoff"])
    return [f"<b>What it costs:</b> {said}"] if said else []


def box(found, asked):
    lines = [*how_often(found), *how_far(found), *what_it_costs(found), *never_failed.warning(asked)]
    drawn = reach.picture(near_edge_readings.Data(found["near-edge"])) if "near-edge" in found else ""
    return (f'<section class="verdict"><h2 id="verdict">Verdict</h2><p class="headline">{headline(asked)}</p>{drawn}<ul>'
            + "".join(f"<li>{line}</li>" for line in lines) + "</ul></section>")
