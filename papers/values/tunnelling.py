# SPDX-License-Identifier: GPL-3.0-or-later
"""What steps of a moving ball miss."""
from studies.tunnelling import Data
from values.latex import count, percent, power

SMALL, LARGE = 2.0**-8, 2.0**-4  # radii, in sizes of the polygon
FEW, MANY = 4, 64  # steps


def values(study):
    data = Data(study)
    yield "passes", count(study.run["samples_done"])
    for name, radius in (("small", SMALL), ("large", LARGE)):
        yield f"{name}/radius", power(radius)
        for kind, steps in (("few", FEW), ("many", MANY)):
            yield f"{name}/{kind}", percent(data.at[radius, steps]["rate"])
    yield "few", count(FEW)
    yield "many", count(MANY)
