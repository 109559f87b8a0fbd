# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of the verdict: how far from contact each method was found wrong."""
import math

from looks import in_order, look_of
from names import DISTANCES
from page import escaped, power, share_of_size
from readings.near_edge import CONTACT

LEFT, RIGHT, ROW, BAR, TOP = 130, 700, 46, 11, 44  # of the drawing, in its units
LEAST = -60  # the exponent at its left
LENGTHS = {"1 nm": 1e-9, "1 µm": 1e-6, "1 mm": 1e-3}  # on a part of 1 m
OPACITY = (1, 0.65, 0.35)
UNITS = {"m": 1, "mm": 1e-3, "µm": 1e-6, "nm": 1e-9, "pm": 1e-12, "fm": 1e-15}
HALO = 'style="paint-order: stroke; stroke: var(--soft); stroke-width: 4px; stroke-linejoin: round"'  # keeps lines apart from words


def x_of(share):
    return LEFT + (RIGHT - LEFT) * (1 - math.log2(max(min(share, 1), 2.0**LEAST)) / LEAST)


def length(share):
    """On a part of 1 m, in two digits."""
    unit = next((unit for unit, metres in UNITS.items() if share >= 0.1 * metres), "fm")
    return f"{share / UNITS[unit]:.2g}\N{NARROW NO-BREAK SPACE}{unit}"


def line(x, top, bottom, more=""):
    return f'<line x1="{x:.1f}" y1="{top}" x2="{x:.1f}" y2="{bottom}" {more}/>'


def text(x, y, words, anchor="start", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {more}>{words}</text>'


def bars(data, method, top):
    """One a distance, and their words, which come after all lines; a word in their place where no wrong answer was found."""
    shares = [data.furthest(method, distance, CONTACT) for distance in data.distances]
    if not any(shares):
        return "", text(LEFT + 8, top + ROW / 2, "none found", more='font-weight="600"')
    drawn = words = ""
    for i, share in enumerate(shares):
        y = top + 4 + i * (BAR + 1)
        if share:
            drawn += (f'<rect x="{LEFT}" y="{y}" width="{x_of(share) - LEFT:.1f}" height="{BAR}" fill="{look_of(method).colour}" '
                      f'stroke="none" opacity="{OPACITY[i]}"/>')
        words += text((x_of(share) if share else LEFT) + 4, y + BAR - 1.5, length(share) if share else "none", more=f'font-size="10.5" {HALO}')
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
        drawn += text(LEFT - 8, TOP + ROW * i + ROW / 2 + 3, escaped(method), "end", 'font-family="monospace"') + own_bars
        words += own_words
    for exponent in range(LEAST, 1, 10):
        drawn += line(x_of(2.0**exponent), TOP, bottom, 'opacity=".18"') + text(x_of(2.0**exponent), bottom + 15, power("2", exponent) if exponent else "1", "middle")
    for named, share in LENGTHS.items():
        drawn += line(x_of(share), TOP - 10, bottom, 'stroke-dasharray="3 3"') + text(x_of(share), TOP - 15, named, "middle")
    key = "".join(f'<rect x="{LEFT + 190 * i}" y="{bottom + 45}" width="24" height="{BAR}" fill="currentColor" opacity="{OPACITY[i]}" stroke="none"/>'
                  + text(LEFT + 190 * i + 30, bottom + 55, f"polygon {DISTANCES[distance]}") for i, distance in enumerate(data.distances))
    said = "; ".join(f"{method}: " + (", ".join(share_of_size(s) if s else "none" for s in shares) if any(
        shares := [data.furthest(method, d, CONTACT) for d in data.distances]) else "none found") for method in methods)
    return f"""<figure><div class="scroll" tabindex="0" role="group" aria-label="A drawing; scrolls sideways where it is wider"><svg class="scheme"
viewBox="0 0 {RIGHT + 50} {bottom + 66}" role="img" aria-labelledby="reach-title" fill="none" stroke="currentColor" stroke-width="1" font-family="system-ui, sans-serif" font-size="12">
<title id="reach-title">The furthest wrong answer of each method from contact, as a share of the polygon's size, at growing distances from the
origin. {escaped(said)}.</title>
<g>{text(LEFT - 8, TOP - 15, "on a part of 1 m:", "end")}</g>
<g>{drawn}{words}</g>
<g>{text((LEFT + RIGHT) / 2, bottom + 33, "furthest wrong answer from contact, as a share of the polygon’s size (logarithmic)", "middle")}{key}</g>
</svg></div><figcaption>How far from contact each method was found wrong, by random samples and by a search that moves coordinates: a ball whose
radius is off by so much is still answered wrongly. Lengths are those on a part of 1 m.</figcaption></figure>"""
