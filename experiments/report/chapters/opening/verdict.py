# SPDX-License-Identifier: GPL-3.0-or-later
"""The verdict: what fails, how far from contact, what never failed, what that costs."""
from chapters import bench, meshes, motions, near_edge, regress, stability, thesis, tradeoff, tunnelling
from chapters.opening import never_failed
from page import code, count

BEFORE = (("meshes", meshes), ("near-edge", near_edge), ("stability", stability))
BEHIND = (("tradeoff", tradeoff), ("bench", bench), ("regress", regress), ("motions", motions), ("tunnelling", tunnelling),
          ("thesis", thesis))


def headline(asked):
    methods = dict.fromkeys(method for counts in asked.values() for method in counts if method != never_failed.TRUTH)
    wrong = [method for method in methods if never_failed.sums(asked, method)[1]]
    text = f"Near contact, {count(len(wrong))} of {count(len(methods))} methods gave wrong answers"
    answers = never_failed.sums(asked, never_failed.CERTIFIED)[0]
    if answers and never_failed.CERTIFIED not in wrong:
        text += f"; {code(never_failed.CERTIFIED)} gave none in {count(answers)}"
    return text + "."


def lines(found, asked):
    return [*(chapter.finding(found[name]) for name, chapter in BEFORE if name in found), never_failed.sentence(asked),
            *(chapter.finding(found[name]) for name, chapter in BEHIND if name in found)]
