# SPDX-License-Identifier: GPL-3.0-or-later
"""Shares in percent, for people."""


def unless_whole(share, shown, places=1):
    """`shown`, what 100 * share looks like when rounded, unless that looks like 0 or 100 and is not: then with so many
    decimal places, and `<` or `>` where these do not suffice."""
    looks = float(shown.replace(",", ""))
    if not (share < 1 and looks >= 100 or share > 0 and looks == 0):
        return shown
    finer, unit = f"{100 * share:.{places}f}", 10 ** -places
    if float(finer) == 0:
        return f"< {unit:.{places}f}"
    return f"> {100 - unit:.{places}f}" if float(finer) >= 100 else finer
