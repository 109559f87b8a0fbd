# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture: how far from contact each method was found wrong."""
import math

from chart import text
from looks import in_order, look_of
from names import DISTANCES
from page import power, rendered

LEFT, RIGHT, ROW, NAME, BAR, TOP = 8, 296, 58, 15, 11, 40  # of the drawing, in its units; narrow, so that a phone shows all of it
LEAST = -60  # the exponent at its left
LENGTHS = {"1 nm": 1e-9, "1 µm": 1e-6, "1 mm": 1e-3}  # on a part of 1 m
OPACITY = (1, 0.65, 0.35)
UNITS = {"m": 1, "mm": 1e-3, "µm": 1e-6, "nm": 1e-9, "pm": 1e-12, "fm": 1e-15}
HALO = 'style="paint-order: stroke; stroke: var(--paper); stroke-width: 4px; stroke-linejoin: round"'  # keeps lines apart from words


def x_of(share):
    return LEFT + (RIGHT - LEFT) * (1 - math.log2(max(min(share, 1), 2.0**LEAST)) / LEAST)


def length(share):
    """On a part of 1 m, in two digits."""
    unit = next((unit for unit, metres in UNITS.items() if share >= 0.1 * metres), "fm")
    return f"{share / UNITS[unit]:.2g}\N{NARROW NO-BREAK SPACE}{unit}"


def line(x, top, bottom, more=""):
    return f'<line x1="{x:.1f}" y1="{top}" x2="{x:.1f}" y2="{bottom}" {more}/>'


def bars(data, method, top):
    """One a distance, and their words, which come after all lines; a word in their place where no wrong answer was found."""
    shares = [data.furthest(method, distance) for distance in data.distances]
    if not any(shares):
        return "", text(LEFT + 4, top + NAME + BAR, "none found", "start", 'font-weight="600"')
    drawn = words = ""
    for i, share in enumerate(shares):
        y = top + NAME + i * (BAR + 1)
        if share:
            drawn += (f'<rect x="{LEFT}" y="{y}" width="{x_of(share) - LEFT:.1f}" height="{BAR}" fill="{look_of(method).colour}" '
                      f'stroke="none" opacity="{OPACITY[i]}"/>')
        words += text((x_of(share) if share else LEFT) + 4, y + BAR - 1.5, length(share) if share else "none", "start", f'font-size="10.5" {HALO}')
    return drawn, words


def picture(data):
    """SVG; empty where no furthest answers were searched for."""
    if not data.distances:
        return ""
    methods = in_order(data.methods)
    bottom = TOP + ROW * len(methods)
    drawn = words = ""
    for i, method in enumerate(methods):
        own_bars, own_words = bars(data, method, TOP + ROW * i)
        drawn += own_bars
        words += text(LEFT, TOP + ROW * i + NAME - 4, method, "start", f'font-family="monospace" {HALO}') + own_words
    for exponent in range(LEAST, 1, 20):
        drawn += line(x_of(2.0**exponent), TOP, bottom, 'opacity=".18"') + text(x_of(2.0**exponent), bottom + 15, power("2", exponent) if exponent else "1", "start" if exponent == LEAST else "middle")
    for named, share in LENGTHS.items():
        drawn += line(x_of(share), TOP - 6, bottom, 'stroke-dasharray="3 3"') + text(x_of(share), TOP - 10, named, "middle")
    key = "".join(f'<rect x="{LEFT}" y="{bottom + 43 + 16 * i}" width="24" height="{BAR}" fill="currentColor" opacity="{OPACITY[i]}" stroke="none"/>'
                  + text(LEFT + 30, bottom + 53 + 16 * i, f"polygon {DISTANCES[distance]}", "start") for i, distance in enumerate(data.distances))
    said = "; ".join(f"{method}: " + (", ".join(length(s) if s else "none" for s in shares) if any(
        shares := [data.furthest(method, d) for d in data.distances]) else "none found") for method in methods)
    drawn += words + text(LEFT, bottom + 33, "furthest wrong answer, as a share of the polygon’s size", "start") + key
    return rendered("reach.html", height=bottom + 94, said=said, drawn=text(LEFT, TOP - 26, "on a part of 1 m:", "start") + "\n" + drawn)
