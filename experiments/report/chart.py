# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts that a page draws itself, as SVG in the colours of its text: curves over two logarithmic axes, and stacked columns."""
import dataclasses
import math

from page import escaped

LEFT = 62  # of a panel, in its units
DASHES = {"-": "", "--": "6 3", ":": "2 3", "-.": "7 3 2 3"}


@dataclasses.dataclass(frozen=True)
class Curve:
    name: str
    colour: str
    line: str
    points: list  # (x, y), or (x, y, lower, upper)


def text(x, y, words, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {more}>{escaped(words)}</text>'


class Panel:
    """A frame at (left, top) of a drawing; both axes are logarithmic."""

    def __init__(self, left, top, width, height, xs, ys):
        self.left, self.top, self.width, self.height = left, top, width, height
        self.low, self.high = [math.log(min(each)) for each in (xs, ys)], [math.log(max(each)) for each in (xs, ys)]

    def at(self, x, y):
        across, up = ((math.log(v) - low) / ((high - low) or 1) for v, low, high in zip((x, y), self.low, self.high))
        return self.left + across * self.width, self.top + (1 - up) * self.height

    def frame(self, x_ticks, y_ticks, title, x_label):
        """Ticks are (value, words); ticks outside the frame are left out."""
        drawn = f'<rect x="{self.left}" y="{self.top}" width="{self.width}" height="{self.height}" opacity=".35"/>'
        foot = self.top + self.height
        for value, words in x_ticks:
            x = self.at(value, 1)[0]
            drawn += f'<line x1="{x:.1f}" y1="{foot}" x2="{x:.1f}" y2="{foot + 4}"/>' + text(x, foot + 16, words)
        for value, words in y_ticks:
            y = self.at(1, value)[1]
            if self.top - 0.5 <= y <= foot + 0.5:
                drawn += f'<line x1="{self.left}" y1="{y:.1f}" x2="{self.left + self.width}" y2="{y:.1f}" opacity=".15"/>' + text(self.left - 6, y + 4, words, "end")
        return drawn + text(self.left + self.width / 2, self.top - 8, title, more='font-weight="600"') + text(self.left + self.width / 2, foot + 33, x_label)

    def curve(self, curve):
        style = f'stroke="{curve.colour}" stroke-dasharray="{DASHES[curve.line]}"'
        places = [self.at(*point[:2]) for point in curve.points]
        drawn = f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in places)}" {style} stroke-width="2"/>'
        for (x, y), point in zip(places, curve.points):
            drawn += f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="{curve.colour}" stroke="none"/>'
            if len(point) == 4:
                drawn += f'<line x1="{x:.1f}" y1="{self.at(point[0], point[2])[1]:.1f}" x2="{x:.1f}" y2="{self.at(point[0], point[3])[1]:.1f}" stroke="{curve.colour}"/>'
        return drawn


def key(curves, left, top, step):
    """The legend, in a row."""
    return "".join(f'<line x1="{left + i * step}" y1="{top - 4}" x2="{left + i * step + 26}" y2="{top - 4}" stroke="{c.colour}" '
                   f'stroke-dasharray="{DASHES[c.line]}" stroke-width="2"/>' + text(left + i * step + 32, top, c.name, "start") for i, c in enumerate(curves))


def columns(panel, xs, shares, colours, top, height):
    """Below a panel, at its xs: stacked shares, a list of parts each."""
    middles = [panel.at(x, 1)[0] for x in xs]
    half = 0.42 * min(abs(b - a) for a, b in zip(middles, middles[1:]))
    drawn = ""
    for middle, parts in zip(middles, shares):
        y = top + height
        for part, colour in zip(parts, colours):
            y -= part * height
            drawn += f'<rect x="{middle - half:.1f}" y="{y:.1f}" width="{2 * half:.1f}" height="{part * height:.1f}" fill="{colour}" stroke="none"/>'
    return drawn


def part(width, height, title, drawn):
    """A drawing that is as wide as a phone, and no wider on a screen."""
    return (f'<svg class="part" viewBox="0 0 {width} {height}" role="img" fill="none" stroke="currentColor" stroke-width="1" font-family="system-ui, sans-serif" '
            f'font-size="13"><title>{escaped(title)}</title>\n{drawn}</svg>')
