# SPDX-License-Identifier: GPL-3.0-or-later
"""Where answers fail under stress, and how much room the proofs leave."""
import pathlib
import re

from shares import upper_limit
from studies.stability import STAND_IN, Data, asked
from values.latex import count, decimal, percent, table

ROOT = pathlib.Path(__file__).resolve().parents[2]
FAR = 1000000
SIGNS = [  # of tightness.csv: expression, maxima, constant of bounds.h
    ("vertex", r"$w\cdot w-r^2$", "$m_w^2$", "kVertex"),
    ("along", r"$w\cdot e$", "$m_wm_e$", "kAlong"),
    ("beyond", r"$w\cdot e-e\cdot e$", r"$m_e\max(m_w,m_e)$", "kBeyond"),
    ("line", r"$|e\times w|^2-r^2\,e\cdot e$", "$m_w^2m_e^2$", "kLine"),
    ("front", r"$N\cdot w$", "$m_Nm_w$", "kFront"),
    ("plane", r"$(N\cdot w)^2-r^2\,N\cdot N$", "$m_N^2m_w^2$", "kPlane"),
    ("side", r"$N\cdot(e\times w)$", "$m_Nm_em_w$", "kSide"),
    ("above", r"$(N\cdot N)\,w_k-(N\cdot w)\,N_k$", "$m_N^2m_w$", "kAbove"),
    ("normal", r"$u\times v$", "$2m_um_v$", "kNormal"),
]
FRAME = [("height", "height above the plane in the frame", "$S$", "kHeight"),
         ("along", "along, across an edge in the frame", "$S$", "kEdgeFrame")]


def constants():
    """Those of bounds.h."""
    text = (ROOT / "robust/filtered/detail/signs/bounds.h").read_text()
    return {name: float(value) for name, value in re.findall(r"constexpr double (k\w+) = ([\d.]+);", text)}


def onset(data):
    """(distance, method): (first offset with a wrong answer, share of wrong answers at 2^-36)."""
    found = {}
    for row in data.onset:
        entry = found.setdefault((int(row["origin_distance"]), row["method"]), [None, None])
        if row["failed_triangles"]:
            entry[0] = max(entry[0] or row["offset_exponent"], row["offset_exponent"])
        if row["offset_exponent"] == -36:
            entry[1] = row["wrong_answers"] / row["answers"]
    return found


def tightest(data):
    """The largest observed share of its bound, by stage and quantity."""
    return {(row["stage"], row["quantity"]): row["max"] for row in data.tightness}


def values(study):
    data = Data(study)
    certified = [row for row in data.rows if row["method"] == "filtered" and not row["axis"].endswith(STAND_IN)]
    if any(row["failed_samples"] for row in data.all_tests if row["method"] == "filtered" and not row["axis"].endswith(STAND_IN)):
        raise ValueError("filtered failed")
    yield "axes", str(len({row["axis"] for row in certified}))
    for name, axis in (("vertices", "vertices"), ("rotations", "chain-input")):
        yield f"most-{name}", count(max((int(float(row["level"])) for row in certified if row["axis"] == axis), default=0))
    yield "levels", str(len({(row["axis"], row["level"]) for row in certified}))
    polygons = asked(study)["filtered"].trials
    yield "filtered-samples", count(polygons)
    yield "filtered-limit", percent(upper_limit(polygons))
    yield "aspect-close/fast", decimal(float(data.first_failure("aspect", "close", "fast")), 1)
    for (distance, method), (first, wrong) in onset(data).items():
        where = "1e6" if distance == FAR else str(distance)
        if first is not None:
            yield f"first/{where}/{method}", f"$2^{{{first}}}$"
        if distance == FAR:
            yield f"wrong36/{method}", percent(wrong)
    for stage in ("maxima", "permanent"):
        yield f"tightest-{stage}", percent(max(value for (its, _), value in tightest(data).items() if its == stage))
    for row in data.contraction:
        for compiled in ("plain", "fused"):
            share = row[f"{compiled}_wrong"] / row["trials"]
            yield f"contraction/{row['sign']}/{row['family']}/{compiled}", percent(share) if share else "none"
        yield f"contraction/{row['sign']}/{row['family']}/trials", count(row["trials"])


def tables(study):
    seen, proved = tightest(Data(study)), constants()
    row = lambda stage, name, words, maxima, constant: [words, maxima, f"{proved[constant]:.4f}", percent(seen[stage, name])]
    yield "bounds", table("llrr", ["sign of", "maxima", "constant", "observed"],
                          [*(row("maxima", *sign) for sign in SIGNS), None, *(row("frame", *entry) for entry in FRAME)])
