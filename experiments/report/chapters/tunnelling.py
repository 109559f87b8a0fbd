# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone tunnelling`: what steps miss, and what the exact sweep costs instead."""
from noise import TOO_NOISY
from page import bar, count, folded, multiple, percent, picture, rounded, share_of_size, smaller, table, upper_limit
from readings.tunnelling import CONTACT, FIRST, Data, asked, has_steady_ratio, has_steady_time

TITLE = "Steps that pass through: tunnelling"


def ball_of(radius):
    return f"radius {share_of_size(radius)} of the size" if radius else "a point"


def finding(study):
    data = Data(study)
    small, steps = next(radius for radius in data.radii if radius), data.steps[-4]
    large = data.radii[-3]
    text = (f"A ball whose radius is {share_of_size(small)} of the polygon's size, moved by {count(steps)} steps over one size, misses "
            f"{percent(data.at[small, steps]['rate'])} of its contacts; one of {share_of_size(large)}, by "
            f"{count(data.steps[2])} steps, {percent(data.at[large, data.steps[2]]['rate'])}.")
    if CONTACT in data.cost:
        beaten = [n for n in data.steps if has_steady_ratio(data.cost_of(n)) and data.cost_of(n)["median_ratio"] > 1]
        text += (f" The exact sweep misses none. Measured here, it costs less than {count(beaten[0])} steps." if beaten and beaten[0] > 1 else
                 " The exact sweep misses none.")
    return text


def missed(row):
    if not row["missed"]:
        return f"0 (&lt; {percent(upper_limit(row['contacts']))})" if row["contacts"] else ""
    return bar(row["rate"], percent(row["rate"]))


def misses_table(data):
    shown = data.steps[::2]
    rows = [[ball_of(radius), count(data.at[radius, shown[0]]["contacts"]), *(missed(data.at[radius, n]) for n in shown)] for radius in data.radii]
    return table("Contacts that steps miss: no place between two steps touches, although the ball touches on its way. Ways are as long as the "
                 "polygon's size. In brackets: the upper 95 % limit.",
                 ["the ball", "contacts", *(f"{count(n)} step{'s' if n > 1 else ''}" for n in shown)], rows, range(1, len(shown) + 2))


def cost_table(data):
    if not data.cost:
        return ""
    rows = [[name, f"{rounded(row['median_ns'])} ns" if has_steady_time(row) else TOO_NOISY,
             "1" if not row["median_ratio"] else multiple(row["median_ratio"]) if has_steady_ratio(row) else TOO_NOISY]
            for name, row in data.cost.items()]
    return table(f"A measurement on this machine: what a motion costs, median; by the exact sweep ({CONTACT}, {FIRST}), and by steps until one "
                 "touches, both by <code>filtered</code> on prepared polygons.", ["asked", "time", "relative to the sweep"], rows, (1, 2))


def chapter(study):
    data = Data(study)
    path = smaller(study.folder, "tunnelling")
    text = f"""<p>Simulations often move a ball by steps and ask at each place whether it touches. A thin face may lie between two
places. {count(study.run["samples_done"])} ways lead through or past random polygons; each is walked by balls of {len(data.radii)} radii in 1 to
{count(data.steps[-1])} steps, and swept exactly.</p>"""
    if path is not None:
        text += picture(path, "Curves of the share of missed contacts against the number of steps, a curve for each radius; beside it, the time of "
                              "a motion by steps and by the exact sweep.",
                        "Left: contacts that steps miss; bars are 95 % limits. Right: a measurement on this machine, the median time of a motion.")
    return text + folded("The numbers", misses_table(data) + cost_table(data))
