# SPDX-License-Identifier: GPL-3.0-or-later
"""Where answers fail under stress, and how much room the proofs leave."""
import pathlib
import re

from results import finite, maybe, natural, share
from values.latex import decimal, never, percent, count, table

ROOT = pathlib.Path(__file__).resolve().parents[2]
FAR = 1000000
MOTIONS_MEANT = ("chain-motion", "pose-motion")  # held against the motion meant, which no method is given
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
FRAME = [("height", "coordinate in the frame", "$W$", "kCoordinate"),
         ("along", "along, across an edge in the frame", "$S$", "kEdgeFrame")]


def constants():
    """Those of bounds.h."""
    text = (ROOT / "robust/filtered/bounds.h").read_text()
    return {name: float(value) for name, value in re.findall(r"constexpr double (k\w+) = ([\d.]+);", text)}


def onset(study):
    """(distance, method): (first offset with a wrong answer, share of wrong answers at 2^-36)."""
    found = {}
    for row in study.rows("onset.csv", origin_distance=finite, method=str, offset_exponent=int, failed_triangles=natural,
                          wrong_answers=natural, answers=natural):
        entry = found.setdefault((int(row["origin_distance"]), row["method"]), [None, None])
        if row["failed_triangles"]:
            entry[0] = max(entry[0] or row["offset_exponent"], row["offset_exponent"])
        if row["offset_exponent"] == -36:
            entry[1] = row["wrong_answers"] / row["answers"]
    return found


def tightest(study):
    """The largest observed share of its bound, by stage and quantity."""
    return {(row["stage"], row["quantity"]): row["max"]
            for row in study.rows("tightness.csv", stage=str, quantity=str, axis=str, max=finite, exceeded=natural)
            if row["axis"] == "all"}


def values(study):
    failures = study.rows("failures.csv", axis=str, level=str, nearness=str, test=str, method=str, failed_samples=natural,
                          samples=natural)
    filtered = [row for row in failures if row["method"] == "filtered" and row["axis"] not in MOTIONS_MEANT]
    if any(row["failed_samples"] for row in filtered):
        raise ValueError("filtered failed")
    one_double = [row for row in filtered if (row["nearness"], row["test"]) == ("one-double", "contact")]
    yield "axes", str(len({row["axis"] for row in filtered}))
    for name, axis in (("vertices", "vertices"), ("rotations", "chain-input")):
        yield f"most-{name}", count(max((int(float(row["level"])) for row in filtered if row["axis"] == axis), default=0))
    yield "levels", str(len({(row["axis"], row["level"]) for row in filtered}))
    samples = sum(row["samples"] for row in one_double)
    yield "filtered-samples", count(samples)
    yield "filtered-limit", percent(never(samples))
    for row in study.rows("first-failure.csv", axis=str, nearness=str, test=str, method=str, first_failure=str):
        if (row["axis"], row["nearness"], row["test"]) == ("aspect", "close", "contact") and row["first_failure"]:
            yield f"aspect-close/{row['method']}", decimal(float(row["first_failure"]), 1)
    for (distance, method), (first, wrong) in onset(study).items():
        where = "1e6" if distance == FAR else str(distance)
        if first is not None:
            yield f"first/{where}/{method}", f"$2^{{{first}}}$"
        if distance == FAR:
            yield f"wrong36/{method}", percent(wrong)
    for stage in ("maxima", "permanent"):
        yield f"tightest-{stage}", percent(max(value for (its, _), value in tightest(study).items() if its == stage))
    for row in study.rows("contraction.csv", sign=str, family=str, trials=natural, fused_wrong=natural):
        if (row["sign"], row["family"]) == ("orientation", "exactly zero"):
            yield "contraction-zero", percent(row["fused_wrong"] / row["trials"])


def tables(study):
    seen, proved = tightest(study), constants()
    row = lambda stage, name, words, maxima, constant: [words, maxima, f"{proved[constant]:.4f}", percent(seen[stage, name])]
    yield "bounds", table("llrr", ["sign of", "maxima", "constant", "observed"],
                          [*(row("maxima", *sign) for sign in SIGNS), None, *(row("frame", *entry) for entry in FRAME)])
