# SPDX-License-Identifier: GPL-3.0-or-later
"""The rates of random polygons with other seeds, which the paper alone tells."""
from studies import NEAR_EDGE, OUTPUT, Run

SEEDS = range(2, 7)  # the others have 1


def of_seed(seed, *samples):
    """The folder of the first one also has the study's run.json."""
    folder = OUTPUT if seed == SEEDS[0] else f"{OUTPUT}/seed-{seed}"
    return [*NEAR_EDGE, *samples, "--search", "0", "--no-maps", "--no-pictures", "--seed", str(seed), "--output", folder]


RUN = Run(3, "random polygons, with other seeds", full=[of_seed(seed) for seed in SEEDS],
          paper=[of_seed(seed, "--samples", "60") for seed in SEEDS])
