# SPDX-License-Identifier: GPL-3.0-or-later
"""Which times report, paper and pages quote: those whose quartiles within their run differ by at most a factor of
MOST_SPREAD. `touchstone bench` has the same rule for ratios."""

MOST_SPREAD = 1.5
TOO_NOISY = "too noisy to tell"


def is_steady(lower, upper):
    """Of the quartiles of a time or of a ratio."""
    return upper <= MOST_SPREAD * lower


def of_contestant(contestant):
    """Whether the time of a contestant in bench.json is steady."""
    return is_steady(contestant["nanoseconds"]["lower_quartile"], contestant["nanoseconds"]["upper_quartile"])
