# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone stability`: what makes answers worse, far from contact too."""
from names import AXES, MODES, NEARNESSES, SIGNS
from page import bar, code, count, counted, escaped, level, percent, picture, power, rounded, smaller, table, words
from readings.stability import STAND_IN, Data, asked

TITLE = "Polygons under stress"


def title(axis):
    return AXES[axis][0].replace("\n", " ")


# Of what a sentence says a level.
SAID = {"aspect": ("slivers {} times as long as wide", level), "origin": ("polygons {} sizes from the origin", level),
        "small": ("coordinates of about {}", lambda text: power("2", text)), "large": ("coordinates of about {}", lambda text: power("2", text))}


def finding(study):
    data = Data(study)
    failures = [said.format(shown(data.first_failure(axis, "close", "fast"))) for axis, (said, shown) in SAID.items()
                if data.first_failure(axis, "close", "fast")]
    if not failures:
        return f"<b>Under stress</b>, with the radius 2⁻³⁰ of the distance off, {code('fast')} was not seen to fail."
    return (f"<b>Under stress</b> errors also occur far from contact. With the radius 2⁻³⁰ of the distance off, {code('fast')} "
            f"was first seen to fail with {words(failures)}.")


def first_table(data, nearness):
    rows = []
    for axis in data.axes:
        mildest = next(row["level"] for row in data.rows if row["axis"] == axis)
        cells = []
        for method in data.methods:
            row = next((r for r in data.first if (r["axis"], r["nearness"], r["method"]) == (axis, nearness, method)), None)
            if row is None:
                cells.append("not asked")
            elif not row["failed_samples"]:
                cells.append("none")
            else:
                begins = (f"in mode {level(row['first_failure'])}" if axis in MODES else
                          "all levels" if row["first_failure"] == mildest else f"from {level(row['first_failure'])}")
                cells.append(bar(row["failed_samples"] / row["samples"], f"{begins}, {percent(row['failed_samples'] / row['samples'])}"))
        rows.append([f"{escaped(title(axis))} <small>({escaped(AXES[axis][1])})</small>", *cells])
    return table(f"{NEARNESSES[nearness].capitalize()}: the level from which a method was seen to give wrong final answers, "
                 "and the share of all levels' polygons on which it did. all levels: already at the mildest; in mode: the first such; none: not on one "
                 "polygon.",
                 ["what is made worse", *(code(m) for m in data.methods)], rows, range(1, len(data.methods) + 1))


def failures_picture(study, data, nearness):
    path = smaller(study.folder, f"failures-{nearness}")
    if path is None:
        return ""
    rows = [row for row in data.rows if row["nearness"] == nearness and not row["axis"].endswith(STAND_IN)]
    said = []
    for method in data.methods:
        own = [row for row in rows if row["method"] == method]
        failed, samples = sum(row["failed_samples"] for row in own), sum(row["samples"] for row in own)
        said.append(f"{code(method)} {percent(failed / samples) if failed else 'none'}")
    return picture(path, f"Curves of the share of polygons with a wrong final answer against the level of stress, a panel for "
                         "each of "
                   f"{len(data.axes)} stresses; {NEARNESSES[nearness]}.",
                   f"{NEARNESSES[nearness].capitalize()}: polygons with a wrong final answer; bars are 95 % limits. <b>What "
                   f"follows:</b> of all polygons here (chains against the motion meant aside, where rounding moves the "
                   f"polygon itself), failed: {words(said)}.")


def tightness_picture(study, data):
    path = smaller(study.folder, "tightness")
    observed = [row for row in data.tightness if row["observations"] and row["max"] is not None]
    if path is None or not observed:
        return ""
    exceeded = sum(row["exceeded"] for row in observed)
    top = max(observed, key=lambda row: row["max"])
    return picture(path, "Observed rounding errors divided by their proved bounds: median, 99 % and largest of each sign; and "
                         "the largest by stress, "
                   "as a map.",
                   f"Rounding errors of the signs that {code('filtered')} decides by, divided by the bounds that are proved "
                   f"for them. <b>What follows:</b> {'no error' if not exceeded else f'{count(exceeded)} errors'} beyond its "
                   f"bound in {count(sum(row['observations'] for row in observed))} observations; the largest is "
                   f"{rounded(top['max'])} of the bound ({escaped(top['stage'])}: {escaped(top['quantity'])}). Names: the "
                   "stage (maxima and permanent: doubles with a quick and with a sharper bound; double-double; frame: the "
                   "plane's own coordinates), then the sign that is decided.")


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
    text += failures_picture(study, data, "close") + first_table(data, "close") + failures_picture(study, data, "ample")
    return text + onset_picture(study, data) + contraction_table(data) + tightness_picture(study, data)
