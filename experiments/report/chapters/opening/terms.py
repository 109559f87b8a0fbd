# SPDX-License-Identifier: GPL-3.0-or-later
"""The words of the report, and what each method is."""
from page import code, escaped, folded
from results import DataError

TERMS = """
<dl>
<dt>Ball, polygon, contact</dt>
<dd>A closed ball with a centre and a radius; a flat, closed polygon in space, which may be non-convex and have holes. They
are in contact if they share a point; exactly touching is contact. The numbers given are taken as exact.</dd>
<dt>Double, one double away</dt>
<dd>A 64-bit floating-point number. A program can be given no number between neighbouring doubles, so “one
double away” is the smallest possible change. A float has 32 bits.</dd>
<dt>Threshold, offset</dt>
<dd>The value at which the true answer changes: of the radius, the exact distance; of a coordinate of the centre, where the
foot crosses an edge. Offsets from it are counted in doubles, or given as shares: 2⁻³⁰ is about one billionth of the distance
or of the polygon's size.</dd>
<dt>Foot; the three tests</dt>
<dd>The foot is the point of the polygon's plane straight below the centre. Contact is decided by three tests: does the ball
cross the plane (<i>plane</i>), is the foot inside the polygon (<i>foot</i>), which edges are within the radius
(<i>edges</i>).</dd>
<dt>Planar (lattice) and rotated polygons</dt>
<dd>Vertices on an integer lattice lie exactly in one plane. Rotated ones are rounded to doubles, so they do so only nearly;
the polygon is then their projection onto one exact plane.</dd>
<dt>95 % limit</dt>
<dd>The true share lies within the limits with 95 % confidence, given independent trials (Clopper and Pearson;
Hoeffding where stated). If nothing failed, the upper limit is one-sided: 1 − 0.05<sup>1/n</sup> after n trials. In
pictures, limits are two-sided.</dd>
</dl>
"""


def methods(results):
    """The methods, from the output of `touchstone methods`, which ./reproduce keeps."""
    path = results / "methods.txt"
    if not path.exists():
        return ('<section><h2 id="methods">The methods</h2><p>Their list was not kept; <code>touchstone methods</code> prints '
                'it.</p></section>')
    entries = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        name, _, about = line.partition(" ")
        if not name or not about.strip():
            raise DataError(f"{path}: line {number}: no name and summary of a method")
        entries.append(f"<dt>{code(name)}</dt><dd>{escaped(about.strip())}</dd>")
    return ('<section><h2 id="methods">The methods</h2><p>Each answers the same questions about the same balls and polygons.</p>'
            + folded("The list", f'<dl class="methods">{"".join(entries)}</dl>') + "</section>")
