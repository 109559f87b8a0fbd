# SPDX-License-Identifier: GPL-3.0-or-later
"""Where answers fail under stress."""
from shares import upper_limit
from studies.stability import STAND_IN, Data, asked
from values.latex import count, decimal, percent

FAR = 1000000


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
