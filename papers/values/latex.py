# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers and tables as LaTeX."""
import math
import re

from shares import unless_whole


def count(n):
    """12345 as 12,345."""
    return f"{n:,}".replace(",", "{,}")


def percent(share):
    """To two digits; only what is 0 % or 100 % looks so."""
    value = 100 * share
    shown = unless_whole(share, f"{value:.0f}" if value >= 9.5 else f"{value:.2g}")
    return re.sub("([<>]) ", r"$\1$\\,", shown) + r"\,\%"


def power(x):
    """The least power of two that is not below x > 0."""
    return rf"$2^{{{math.ceil(math.log2(x))}}}$"


def decimal(x, digits=2):
    """In powers of ten where it is far from 1."""
    if x == 0:
        return "0"
    if 1e-3 <= abs(x) < 1e5:
        shown = f"{x:.{digits}g}"
        return shown if "e" not in shown else count(round(x, digits - 1 - math.floor(math.log10(abs(x)))) // 1).split(".")[0]
    mantissa, exponent = f"{x:.{digits - 1}e}".split("e")
    return rf"${mantissa}\cdot10^{{{int(exponent)}}}$"


def mean_limit(samples):
    """How far the mean of so many independent numbers between 0 and 1 is from what it estimates, at most, at 95 % confidence
    (two-sided, Hoeffding)."""
    return math.sqrt(math.log(2 / 0.05) / (2 * samples))


def times(ratio):
    """A ratio, to three digits and at most three places."""
    if ratio >= 100:
        return count(round(ratio))
    return f"{ratio:.1f}" if ratio >= 10 else f"{ratio:.2f}" if ratio >= 0.1 else f"{ratio:.2g}"


def escaped(text):
    for mark in "\\&%$#_{}":
        text = text.replace(mark, {"\\": r"\textbackslash "}.get(mark, "\\" + mark))
    return text.replace("^", r"\^{}").replace("~", r"\~{}")


def table(columns, head, rows):
    """A tabular with the rules of booktabs; a row that is None is a rule."""
    lines = [rf"\begin{{tabular}}{{{columns}}}", r"\toprule", " & ".join(head) + r" \\", r"\midrule"]
    lines += [r"\midrule" if row is None else " & ".join(row) + r" \\" for row in rows]
    return "\n".join([*lines, r"\bottomrule", r"\end{tabular}", ""])
