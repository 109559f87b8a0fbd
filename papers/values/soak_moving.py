# SPDX-License-Identifier: GPL-3.0-or-later
"""filtered against exact, about moving balls."""
from shares import upper_limit
from studies.soak import asked
from values.latex import count, decimal


def values(study):
    certified = asked(study)["filtered"]
    if certified.wrong:
        raise ValueError(f"{certified.wrong} answers of filtered differ from those of exact")
    yield "cases", count(certified.trials)
    yield "limit", decimal(upper_limit(certified.trials))
