# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone stability`: what makes answers worse, far from contact too."""
from names import NEARNESSES, SIGNS
from page import bar, code, count, counted, escaped, folded, level, percent, picture, power, smaller, table, words
from readings.stability import Data, asked

TITLE = "Polygons under stress"


# Of what a sentence says a level.
SAID = {"aspect": ("slivers {} times as long as wide", level), "origin": ("polygons {} sizes from the origin", level),
        "small": ("coordinates of about {}", lambda text: power("2", text)), "large": ("coordinates of about {}", lambda text: power("2", text))}


def finding(study):
    data = Data(study)
    failures = [said.format(shown(data.first_failure(axis, "close", "fast"))) for axis, (said, shown) in SAID.items()
                if data.first_failure(axis, "close", "fast")]
    if not failures:
        return f"With the radius 2⁻³⁰ of the distance off, {code('fast')} was not seen to fail."
    return (f"Under stress errors also occur far from contact. With the radius 2⁻³⁰ of the distance off, {code('fast')} "
            f"was first seen to fail with {words(failures)}.")


def failures_picture(study, data):
    path = smaller(study.folder, "failures")
    if path is None:
        return ""
    said = []
    for method in data.methods:
        failed, samples = data.failed(method, "ample")
        said.append(f"{code(method)} {percent(failed / samples) if failed else 'none'}")
    return picture(path, f"Heat maps, one a method: a row for each of {len(data.axes)} stresses, from mild to bad; the colour is the share of polygons "
                         "with a wrong final answer.",
                   f"Polygons with a wrong final answer, empty (none) to full colour (all); each row gets worse from left to right. <b>What follows:</b> "
                   f"even with the {NEARNESSES['ample']}, of all polygons here failed: {words(said)}. (Chains “against the motion meant” are left out of these "
                   f"shares: there rounding moves the polygon itself.)", scale=True)


def onset_picture(study, data):
    path = smaller(study.folder, "onset")
    if path is None or not data.onset:
        return ""
    parts = []
    for distance in dict.fromkeys(row["origin_distance"] for row in data.onset):
        seen = []
        for method in ("fast", "thesis", "filtered"):
            own = [row for row in data.onset if row["origin_distance"] == distance and row["method"] == method]
            wrong = [row["offset_exponent"] for row in own if row["failed_triangles"]]
            if own:
                seen.append(f"{code(method)} from {power('2', max(wrong))} on" if wrong else f"{code(method)} nowhere")
        place = "at the origin" if distance == 0 else f"{level(f'{distance:.0e}'.replace('e+0', 'e'))} sizes away"
        parts.append(f"{place}, wrong answers of {words(seen)}")
    triangles = max(row["triangles"] for row in data.onset)
    return picture(path, "Curves of the share of triangles with a wrong contact against the offset of the radius, for "
                         "triangles at the origin and a "
                   "million sizes away.",
                   f"A ball above a triangle's face, the radius off by 2⁻ᵏ of the distance to either side: where wrong answers "
                   f"begin. <b>What follows:</b> {'; '.join(parts)}; of {count(triangles)} triangles at each offset.")


def contraction_table(data):
    """What a compiler does that fuses a product and a sum into one rounding."""
    def wrong(row, compiled):
        share = row[f"{compiled}_wrong"] / row["trials"]
        limits = f"{percent(row[f'{compiled}_lower'])} to {percent(row[f'{compiled}_upper'])}"
        return bar(share, f"{percent(share) if share else '0'} <small>({limits})</small>")

    rows = [[escaped(SIGNS[row["sign"]]), escaped(row["family"]), count(row["trials"]), wrong(row, "plain"), wrong(row, "fused")]
            for row in data.contraction]
    return table("What compilers may do to a formula that was written for plain products: wrong signs of each formula in doubles, with "
                 "95 % limits, where every product is rounded and where products are fused with the sums that they go into (one "
                 "rounding for both). The measured builds do not fuse; the bounds behind " + code("filtered") + " hold either way.",
                 ["sign", "true value", "of", "plain products", "fused products"], rows, (2, 3, 4))


def chapter(study):
    data = Data(study)
    text = f"""<p>Polygons get worse in one property each: slivers, near-duplicate vertices, distance from the
origin, tiny and huge numbers, vertices off the plane, long chains of rotations, other rounding modes;
{counted(study.run['samples_asked'], 'polygons')} per level, fewer at slow levels. Each is tested with balls at three distances
from contact. A polygon counts as failed if one of its final answers is wrong.</p>"""
    return text + failures_picture(study, data) + folded("Where wrong signs begin, and what a compiler that fuses products and sums does",
                                                           onset_picture(study, data) + contraction_table(data))
