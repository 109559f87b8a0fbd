# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of `touchstone tunnelling`: what steps miss, and what they and the exact sweep cost.

Same data, same bytes: nothing here depends on the time or on chance."""
import csv
import math

from looks import look_of
from pictures.style import STYLES, plt, save


def draw_misses(axes, rows):
    """Shares by steps, a curve a radius."""
    radii = list(dict.fromkeys(row["radius"] for row in rows))
    for place, ((_, line, marker), radius) in enumerate(zip(STYLES, radii)):
        color = str(0.75 * place / len(radii))  # greys: colours are of methods
        own = [row for row in rows if row["radius"] == radius]
        shares = [100 * float(row["rate"]) for row in own]
        bars = [[s - 100 * float(row["lower"]) for s, row in zip(shares, own)], [100 * float(row["upper"]) - s for s, row in zip(shares, own)]]
        name = f"$2^{{{int(math.log2(float(radius)))}}}$" if float(radius) else "0 (a point)"
        axes.errorbar([int(row["steps"]) for row in own], shares, yerr=bars, color=color, linestyle=line, marker=marker, markersize=4,
                      capsize=2, label=name)
    axes.set_ylabel("missed contacts (%)")
    axes.set_ylim(-2, 102)
    axes.legend(title="radius, in sizes", fontsize=8, loc="upper left", bbox_to_anchor=(1, 1))
    axes.set_title("contacts that steps over one size of the polygon miss (bars: 95 %)")


def draw_cost(axes, rows):
    """Medians, with the quartiles as bars."""
    steps = [row for row in rows if row["asked"].split()[0].isdigit()]

    def parts(row):
        return [float(row[f"{part}_ns"]) for part in ("lower_quartile", "median", "upper_quartile")]

    lower, median, upper = zip(*map(parts, steps))
    axes.errorbar([int(row["asked"].split()[0]) for row in steps], median,
                  yerr=[[m - low for m, low in zip(median, lower)], [high - m for m, high in zip(median, upper)]], color=look_of("filtered").colour, linestyle=":", marker="o",
                  markersize=4, capsize=2, label="filtered, in steps until one touches")
    for (_, line, _), row in zip(STYLES, [row for row in rows if row not in steps]):
        axes.axhline(parts(row)[1], color=look_of("filtered").colour, linestyle=line, label=row["asked"] + ", without steps")
    axes.set_yscale("log")
    axes.set_ylabel("nanoseconds per motion")
    axes.legend()
    axes.set_title("time per motion: medians (bars: quartiles)")


def main(folder):
    with open(folder / "misses.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    with open(folder / "cost.csv", newline="") as file:
        cost = list(csv.DictReader(file))
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    draw_misses(left, rows)
    draw_cost(right, cost)
    for axes in (left, right):
        axes.set_xscale("log", base=2)
        axes.set_xlabel("steps")
        axes.grid(alpha=0.3)
    save(figure, folder, "tunnelling")
