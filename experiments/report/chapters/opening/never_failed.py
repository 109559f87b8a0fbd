# SPDX-License-Identifier: GPL-3.0-or-later
"""The methods that never failed, with limits from the number of answers in each study."""
from page import code, count, counted, escaped, folded, percent, table, upper_limit, words

CERTIFIED, TRUTH = "filtered", "exact"  # must never fail; is right by definition


def sums(asked, method):
    """Sums over all studies: answers, wrong answers, and polygons or other trials."""
    own = [counts[method] for counts in asked.values() if method in counts]
    return sum(a.answers for a in own), sum(a.wrong for a in own), sum(a.trials for a in own)


def warning(asked):
    """What to read first, if what must not fail did."""
    answers, wrong, _ = sums(asked, CERTIFIED)
    return [f'<b class="no">{code(CERTIFIED)} was wrong in {count(wrong)} of {count(answers)} answers</b>, against its guarantee: see the table below.'] if wrong else []


def others(asked):
    """The other methods that were never wrong; and those of them that sometimes did not answer."""
    methods = dict.fromkeys(m for counts in asked.values() for m in counts if m not in (CERTIFIED, TRUTH))
    never = [m for m in methods if sums(asked, m)[1] == 0 and sums(asked, m)[2] >= 100]
    unsure = {m: sum(counts[m].unsure for counts in asked.values() if m in counts) for m in never}
    return [m for m in never if not unsure[m]], {m: n for m, n in unsure.items() if n}


def table_of(asked, titles):
    rows = []
    for name, counts in asked.items():
        if CERTIFIED in counts:
            a = counts[CERTIFIED]
            rows.append([f'<a href="#{name}">{escaped(titles[name])}</a>', count(a.answers), f"{count(a.trials)} "
                                                                                             f"{escaped(a.trial)}", count(a.wrong),
                         "none: it failed" if a.wrong else percent(upper_limit(a.trials))])
    if not rows:
        return ""
    right, unsure = others(asked)
    failed = [escaped(titles[name]) for name, counts in asked.items() if CERTIFIED in counts and counts[CERTIFIED].wrong]
    also = f"Compared with exact answers, {code(CERTIFIED)} was wrong in " + (words(failed) + "." if failed else "none of the studies.")
    also += f" Also never wrong: {words(map(code, right))}." if right else ""
    also += "".join(f" {code(m)} was never wrong either, but said “don’t know” {count(n)} times of {count(sums(asked, m)[0])}." for m, n in unsure.items())
    limits = table(
        f"Answers of {code(CERTIFIED)} about contact that were compared with exact ones. Answers about the same polygon depend on each "
        "other, so the limit counts polygons (or outlines that they share, faces, cases). It holds for polygons that are drawn as that "
        "study draws them; studies are not added up. Error bounds behind the answers are proved as well.",
        ["study", "answers", "about", "wrong", "95 % upper limit"], rows, range(1, 5))
    return (f"<section><h2>What never failed, and how sure that is</h2><p>{also}</p>"
            + folded(f"By study: how often {CERTIFIED} was asked, and the limits", limits) + "</section>")
