# SPDX-License-Identifier: GPL-3.0-or-later
"""What the drawings of the pages share: one style for light and dark, lines of text for shapes, and writing or comparing."""

import sys

# Each drawing has its own background, so that it is legible wherever it is shown.
STYLE = """<style>
.ground{fill:#fff}.plane{fill:#eef2f6;stroke:#9aabbc}.region{fill:#c9d9ea;stroke:#44566a;stroke-width:1.5}
.hole{fill:#fff;stroke:#44566a;stroke-width:1.5}.ball{fill:#888;fill-opacity:.16;stroke:#555;stroke-width:1.5}
.line{fill:none;stroke:#44566a;stroke-width:1.5}.bad{fill:none;stroke:#c24a00;stroke-width:3}.bad-dot{fill:#c24a00}
.near{fill:none;stroke:#0067a8;stroke-width:2.5}.near-dot{fill:#0067a8}.thin{fill:none;stroke:#444}.dot{fill:#222}
.hidden{stroke-dasharray:4 4}text{fill:#222;stroke:#fff;stroke-opacity:.6;stroke-width:3;paint-order:stroke;stroke-linejoin:round}
.bad-text{fill:#a83f00}.near-text{fill:#005a94}.quiet{fill:#5a6673}
@media(prefers-color-scheme:dark){.ground{fill:#161b22}.plane{fill:#202a35;stroke:#5b6b7c}
.region{fill:#35506c;stroke:#a9bdd2}.hole{fill:#161b22;stroke:#a9bdd2}.ball{fill:#ccc;stroke:#bbb}.line{stroke:#a9bdd2}
.bad{stroke:#ff9248}.bad-dot{fill:#ff9248}.near{stroke:#62b0ff}.near-dot{fill:#62b0ff}.thin{stroke:#bbb}.dot{fill:#eee}
text{fill:#eee;stroke:#161b22}.bad-text{fill:#ffa463}.near-text{fill:#7cbcff}.quiet{fill:#a3afbb}}
</style>"""


def number(value):
    return f"{value:.1f}".removesuffix(".0")


def at(point):
    return " ".join(number(value) for value in point)


def path(points, style, closed=False):
    return f'<path class="{style}" d="M{"L".join(map(at, points))}{"Z" if closed else ""}"/>\n'


def dot(point, style="dot", radius=3.5):
    return f'<circle class="{style}" cx="{number(point[0])}" cy="{number(point[1])}" r="{radius}"/>\n'


def circle(centre, radius, style):
    return f'<circle class="{style}" cx="{number(centre[0])}" cy="{number(centre[1])}" r="{number(radius)}"/>\n'


def text(point, words, style="", anchor="start", size=14):
    style = f' class="{style}"' if style else ""
    return (f'<text{style} x="{number(point[0])}" y="{number(point[1])}" text-anchor="{anchor}" font-size="{size}">'
            f"{words}</text>\n")


def drawing(width, height, title, shapes):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
            f'font-family="sans-serif">\n<title>{title}</title>\n{STYLE}\n'
            f'<rect class="ground" width="{width}" height="{height}" rx="6"/>\n{shapes}</svg>\n')


def write_or_compare(drawings, options, script):
    """Writes the drawings, by path, if --write is given; otherwise returns 1 if one differs from its file."""
    status = 0
    for file, made in drawings.items():
        if "--write" in options:
            file.parent.mkdir(exist_ok=True)
            file.write_text(made)
        elif not file.exists() or file.read_text() != made:
            print(f"{file}: differs from what {script} draws; --write updates it")
            status = 1
    if not status:
        print(f"{len(drawings)} drawings", file=sys.stderr)
    return status
