# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of the verdict: how many polygons under stress methods are wrong about, with the radius far from contact."""
import chart
from looks import in_order, look_of
from names import NAMED
from page import percent_number

WIDTH, LEFT, RIGHT, ROW, BAR = 360, 4, 300, 34, 13


def picture(data, nearness):
    """SVG; empty where nothing was asked."""
    drawn, said = "", []
    methods = [method for method in in_order(data.methods) if data.failed(method, nearness)[1]]
    for i, method in enumerate(methods):
        failed, polygons = data.failed(method, nearness)
        share, top = failed / polygons, ROW * i + 4
        words = f"{percent_number(share)} %" if failed else "none"
        about = f", {NAMED[method]}" if method in NAMED else ""
        drawn += (chart.text(LEFT, top + 10, method + about, "start") + f'<rect x="{LEFT}" y="{top + 15}" width="{RIGHT - LEFT}" height="{BAR}" opacity=".25"/>'
                  f'<rect x="{LEFT}" y="{top + 15}" width="{share * (RIGHT - LEFT):.1f}" height="{BAR}" fill="{look_of(method).colour}" stroke="none"/>'
                  + chart.text(RIGHT + 6, top + 26, words, "start", 'font-weight="600"'))
        said.append(f"{method} {words}")
    return chart.part(WIDTH, ROW * len(methods) + 4, f"Polygons under stress with a wrong answer: {', '.join(said)}.", drawn) if methods else ""
