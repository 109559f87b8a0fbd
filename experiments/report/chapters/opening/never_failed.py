# SPDX-License-Identifier: GPL-3.0-or-later
"""The methods that never failed, with limits from the number of answers in each study."""
from page import code, count, counted, escaped, percent, table, upper_limit, words

CERTIFIED, TRUTH = "filtered", "exact"  # must never fail; is right by definition


def sums(asked, method):
    """Sums over all studies: answers, wrong answers, and polygons or other trials."""
    own = [counts[method] for counts in asked.values() if method in counts]
    return sum(a.answers for a in own), sum(a.wrong for a in own), sum(a.trials for a in own)


def sentence(asked):
    answers, wrong, trials = sums(asked, CERTIFIED)
    if not answers:
        return f"<b>What never failed</b>: {code(CERTIFIED)} was not asked in any study that was run."
    if wrong:
        return (f'<b class="no">{code(CERTIFIED)} was wrong in {count(wrong)} of {count(answers)} answers</b>, against its '
                'guarantee: see the '
                "table below.")
    studies = sum(CERTIFIED in counts for counts in asked.values())
    return (f"<b>What never failed:</b> {code(CERTIFIED)}, in {count(answers)} answers about {count(trials)} polygons, "
            f"outlines, faces and cases of {counted(studies, 'studies', 'study')}. The share of such cases that it answers wrongly is at "
            f"most {percent(upper_limit(trials))} (95 % limit). This is a measurement; in addition, the bounds behind its answers are "
            "proved by a proof tool, in every test run.")


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
    also = f" Also never wrong: {words(f'{code(m)} ({count(sums(asked, m)[0])} answers)' for m in right)}." if right else ""
    also += "".join(f" {code(m)} was never wrong either, but said “don’t know” {count(n)} times of {count(sums(asked, m)[0])}." for m, n in unsure.items())
    return "<section><h2>What never failed, and how sure that is</h2>" + table(
        f"{code(CERTIFIED)} in every study that asked it. Answers about the same polygon depend on each other, so the limit "
        f"counts polygons (or outlines that they share, faces, cases): if more than this share of such were answered wrongly, at least one would have "
        "been seen, with 95 % "
        "confidence.",
        ["study", "answers", "about", "wrong", "95 % upper limit"], rows, range(1, 5)) + f"<p>{also.strip()}</p></section>"
