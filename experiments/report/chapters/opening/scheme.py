# SPDX-License-Identifier: GPL-3.0-or-later
"""A drawing of the question: a ball over a polygon, and the doubles about the threshold."""


def doubles():
    """A line of doubles; the exact distance lies between two of them."""
    text = '<line x1="390" y1="150" x2="690" y2="150"/>'
    for i in range(-3, 4):
        signed = f"{i:+d}".replace("-", "−") if i else "0"
        text += f'<line x1="{540 + 40 * i}" y1="144" x2="{540 + 40 * i}" y2="156"/>'
        text += f'<text x="{540 + 40 * i}" y="174" text-anchor="middle">{signed}</text>'
    return text


def part(name, title, box, drawn):
    return (f'<svg class="part" viewBox="{box}" role="img" aria-labelledby="{name}" fill="none" stroke="currentColor" font-family="system-ui, sans-serif" '
            f'font-size="13"><title id="{name}">{title}</title>{drawn}</svg>')


BALL = """
<polygon points="40,215 250,215 300,165 195,165 220,140 115,140" fill="var(--soft)" stroke-width="1.5"/>
<circle cx="135" cy="110" r="68" stroke-width="1.5"/><circle cx="135" cy="110" r="2.5" fill="currentColor"/>
<line x1="135" y1="110" x2="135" y2="178" stroke-dasharray="4 3"/><circle cx="135" cy="178" r="3" fill="currentColor"/>
<g fill="currentColor" stroke="none"><text x="128" y="108" text-anchor="end">centre</text><text x="142" y="162">d</text><text x="143" y="194">foot</text><text x="185" y="207">polygon</text>
<text x="205" y="76">radius r</text></g><line x1="135" y1="110" x2="196" y2="79"/>
"""
NUMBERS = f"""<g stroke="currentColor">{doubles().replace('<text', '<text fill="currentColor" stroke="none"')}</g>
<line x1="551" y1="105" x2="551" y2="150" stroke="var(--bad)" stroke-width="2"/>
<g fill="currentColor" stroke="none"><text x="551" y="96" text-anchor="middle">the exact distance d</text>
<text x="465" y="128" text-anchor="middle">separate</text><text x="630" y="128" text-anchor="middle">contact</text>
<text x="540" y="200" text-anchor="middle">radius: doubles from the one nearest to d</text></g>
"""
PICTURE = f"""<figure><div class="parts">{part("scheme-ball", "A ball over an L-shaped polygon, its foot and its distance.", "20 30 300 200", BALL)}
{part("scheme-doubles", "The doubles next to the exact distance, one of which is the radius.", "380 30 320 200", NUMBERS)}</div>
<figcaption>The question, and how it is made hard: the exact distance lies between two doubles, and the radius is
set to one of them. On the line of doubles, left of d the truth is “separate”, right of it
“contact”; a program whose own distance is off by one double gives the wrong one.</figcaption></figure>"""
