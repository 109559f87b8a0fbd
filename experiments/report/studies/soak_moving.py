# SPDX-License-Identifier: GPL-3.0-or-later
"""The chapter of `touchstone soak --moving`: filtered against exact on adversarial motions."""
from studies import OUTPUT, Run, soak

RUN = Run(12, "the certified path under attack by moving balls", full=[["soak", "--moving", "--output", OUTPUT]],
          quick=[["soak", "--moving", "--samples", "20000", "--output", OUTPUT]],
          tiny=["soak", "--moving", "--samples", "100"])
TITLE = "The certified path under attack by moving balls"
asked = soak.asked


def told(study):
    return soak.told(study, "By family")
