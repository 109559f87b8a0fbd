# SPDX-License-Identifier: GPL-3.0-or-later
"""Shares in percent, as readers see them, and their limits."""


def upper_limit(trials):
    """The one-sided 95 % limit of a probability after `trials` independent trials without a failure (Clopper and Pearson)."""
    return 1 - 0.05 ** (1 / trials)


def unless_whole(share, shown, places=1):
    """`shown`, the rounded value of 100 * share, unless that is 0 or 100 and the exact value is not: then the value with
    `places` decimal places, and with `<` or `>` if these do not suffice."""
    looks = float(shown.replace(",", ""))
    if not (share < 1 and looks >= 100 or share > 0 and looks == 0):
        return shown
    finer, unit = f"{100 * share:.{places}f}", 10 ** -places
    if float(finer) == 0:
        return f"< {unit:.{places}f}"
    return f"> {100 - unit:.{places}f}" if float(finer) >= 100 else finer


def percents(part, whole, form=".2g"):
    """As text, 12 %: two digits, if no other form is given."""
    return unless_whole(part / whole, format(100 * part / whole, form)) + " %"
