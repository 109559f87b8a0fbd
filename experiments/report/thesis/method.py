# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the thesis's contact method and of its known errors, for `touchstone thesis`.

Same data, same bytes: nothing here depends on the time or on chance."""
import math

import numpy as np
from matplotlib.patches import FancyBboxPatch, Patch, Polygon

from looks import BLACK, BLUE, GREEN, ORANGE, RED, SKY, look_of
from shares import unless_whole
from studies.cell_missed import draw_missed
from style import GREY, STYLES, on_white, picture, plt, whiskers


# ---- Chapter 4 ----

def ends(rows):
    """Balls about the gripper by where the thesis's method ends, and where the exact tests do."""
    method, exact = {}, {}
    for row in rows:
        if row["outline"] == "gripper" and row["method"] == "thesis":
            method[row["end"]] = method.get(row["end"], 0) + row["balls"]
            exact[row["exact_end"]] = exact.get(row["exact_end"], 0) + row["balls"]
    return method, exact


@picture(8.4, 6.4, frame=False)
def flowchart(axes, branches):
    method, exact = ends(branches)
    total = sum(method.values())

    def box(x, y, text, color="white", width=2.5, height=0.8):
        axes.add_patch(FancyBboxPatch((x - width / 2, y - height / 2), width, height, boxstyle="round,pad=0.08",
                                      facecolor=color, edgecolor=BLACK))
        axes.annotate(text, (x, y), ha="center", va="center", fontsize=9)

    def arrow(begin, end, text="", side=0.12):
        axes.annotate("", end, begin, arrowprops={"arrowstyle": "-|>", "color": BLACK, "shrinkA": 0, "shrinkB": 0})
        if text:
            axes.annotate(text, ((begin[0] + end[0]) / 2 + side, (begin[1] + end[1]) / 2 + 0.14), fontsize=8)

    def counts(name):
        share = lambda of: unless_whole(of.get(name, 0) / total, f"{100 * of.get(name, 0) / total:.2f}", 2)
        return f"thesis {share(method)} %\nexact  {share(exact)} %"

    box(0, 8, f"{int(total):,} random balls\nabout the gripper's front".replace(",", " "), "#eeeeee")
    box(0, 6.3, "s = N·(C − P0)\nwhere is the sphere?")
    box(-3.6, 6.3, "INFRONT\nno collision\n" + counts("in front"), "#dbe9f6", height=1.2)
    box(3.6, 6.3, "BEHIND\nno collision\n" + counts("behind"), "#dbe9f6", height=1.2)
    box(0, 4.3, "Q = C − sN\nangles at Q add up to\n0.99 · 360° or more?", height=1.0)
    box(3.6, 4.3, "inside: COLLISION\n" + counts("inside: collision"), "#f7d9c4", height=1.0)
    box(0, 2.3, "an edge nearer to C\nthan r?")
    box(3.6, 2.3, "edge: COLLISION\n" + counts("edge: collision"), "#f7d9c4", height=1.0)
    box(0, 0.4, "no collision\n" + counts("no collision"), "#dbe9f6", height=1.0)
    arrow((0, 7.5), (0, 6.8))
    arrow((-1.33, 6.3), (-2.27, 6.3), "s ≥ r", -0.2)
    arrow((1.33, 6.3), (2.27, 6.3), "else", -0.12)
    arrow((0, 5.8), (0, 4.9), "|s| < r: INTERSECTS")
    arrow((1.33, 4.3), (2.27, 4.3), "yes", -0.1)
    arrow((0, 3.7), (0, 2.8), "no")
    arrow((1.33, 2.3), (2.27, 2.3), "yes", -0.1)
    arrow((0, 1.8), (0, 1.0), "no")
    axes.set(xlim=(-5.2, 5.2), ylim=(-0.4, 8.7))


@picture(5, 3.6)
def plane_side(axes, s, title):
    """A sphere of radius 1 at the height s over a plane seen from its edge."""
    axes.plot([-3, 3], [0, 0], color=GREY, linewidth=1, linestyle="--")
    axes.plot([-1.8, 1.8], [0, 0], color=BLACK, linewidth=3, solid_capstyle="butt")
    axes.annotate("polygon", (1.3, -0.3), fontsize=8, ha="center")
    axes.annotate("its plane", (2.55, -0.3), fontsize=8, color="#555555", ha="center")
    axes.annotate("", (-2.3, 1.3), (-2.3, 0), arrowprops={"arrowstyle": "->"})
    axes.annotate("N", (-2.3, 1.42), ha="center")
    axes.add_patch(plt.Circle((0, s), 1, facecolor=SKY, alpha=0.4, edgecolor=BLUE))
    axes.annotate("", (0, s), (0, 0), arrowprops={"arrowstyle": "<->", "color": RED, "shrinkA": 0, "shrinkB": 0})
    axes.annotate(f"s = {s:+.1f} r".replace("-", "−"), (0.1, s / 2 if abs(s) > 0.8 else s / 2 - 0.02), color=RED, va="center")
    axes.plot(0, s, marker="o", color=BLUE, markersize=4)
    axes.annotate("C", (-0.22, s + 0.05), color=BLUE)
    axes.annotate("", (-math.sqrt(0.5), s + math.copysign(math.sqrt(0.5), s)), (0, s), arrowprops={"arrowstyle": "-", "color": BLUE, "shrinkA": 0, "shrinkB": 0})
    axes.annotate("r", (-0.5, s + math.copysign(0.25, s)), color=BLUE)
    axes.set(title=title, aspect="equal", xlim=(-3, 3), ylim=(min(-1.2, s - 1.3), max(1.7, s + 1.3)))
    axes.axis("off")


def intersection_point():
    figure = plane_side(0.6, "Q = C − sN: the intersection point")
    axes = figure.axes[0]
    axes.plot(0, 0, marker="s", color=RED, markersize=6, zorder=5)
    axes.annotate("Q", (-0.28, -0.32), color=RED)
    return figure


@picture(9, 4.6, columns=2)
def angle_views(both, corners, rows):
    """The angles at which the edges are seen from the palm and from the gap."""
    corners = np.array(corners)
    for axes, point in zip(both, ("palm", "gap")):
        own = [row for row in rows if row["point"] == point]
        at = np.array([own[0]["x_mm"], own[0]["y_mm"]])
        axes.add_patch(Polygon(corners, facecolor="#eeeeee", edgecolor=BLACK, linewidth=1.5))
        for row in own:
            i = int(row["edge"])
            a, b = corners[i], corners[(i + 1) % len(corners)]
            negative = row["angle_deg"] < 0
            axes.plot([at[0], a[0]], [at[1], a[1]], color=GREY, linewidth=0.7)
            middle = (a + b) / 2
            away = middle + (middle - at) / max(np.hypot(*(middle - at)), 1) * 7
            axes.annotate(f"{row['angle_deg']:+.1f}°".replace("-", "−"), away, ha="center", va="center", fontsize=8,
                          color=RED if negative else BLUE, bbox=on_white(0.1, 0.85))
        axes.plot(*at, marker="o", color=BLACK)
        unsigned = sum(abs(row["angle_deg"]) for row in own)
        signed = abs(sum(row["angle_deg"] for row in own))
        axes.set(title=f"from the {point}: {unsigned:.1f}° without signs, {signed:.0f}° with", aspect="equal",
                 xlim=(-64, 64), ylim=(-92, 16), xlabel="mm", ylabel="mm")


@picture(6.4, 3.8)
def edge_places(axes, numbers):
    axes.axvspan(-3, 0, color=SKY, alpha=0.2)
    axes.axvspan(6, 9, color=ORANGE, alpha=0.2)
    axes.plot([0, 6], [0, 0], color=BLACK, linewidth=3)
    axes.annotate("Pi", (0, -0.45), ha="center")
    axes.annotate("Pi+1", (6, -0.45), ha="center")
    shares = [row for row in numbers if row["id"] == "4.9"]
    for (x, y), nearest, color, row, place in zip(((-1.6, 1.1), (2.6, 1.6), (7.4, 1.3)), ((0, 0), (2.6, 0), (6, 0)),
                                                  (BLUE, GREEN, "#b37400"), shares, (-1.5, 3, 7.5)):
        axes.add_patch(plt.Circle((x, y), 1, facecolor=color, alpha=0.25, edgecolor=color))
        axes.plot([x, nearest[0]], [y, nearest[1]], color=color)
        axes.plot(*nearest, marker="o", color=color)
        axes.annotate(f"{row['what']}\n{float(row['ours']):.1f} % of pairs", (place, 3.5), ha="center", va="center",
                      fontsize=8, color=color)
    axes.set(aspect="equal", xlim=(-3, 9), ylim=(-0.9, 4.1))
    axes.axis("off")


@picture(5.4, 4)
def edge_hit(axes, corners):
    corners = np.array(corners)
    axes.add_patch(Polygon(corners, facecolor="#eeeeee", edgecolor=BLACK, linewidth=1.5))
    low, high = corners.min(axis=0), corners.max(axis=0)
    edge, y, r = high[0], (low[1] + high[1]) / 2 + 8, 16
    center = edge + 0.6 * r
    axes.add_patch(plt.Circle((center, y), r, facecolor=SKY, alpha=0.4, edgecolor=BLUE))
    axes.plot([edge, center], [y, y], color=RED)
    axes.annotate("d < r", ((edge + center) / 2, y + 1.5), color=RED, ha="center", fontsize=8)
    axes.plot(center, y, marker="o", color=BLUE, markersize=4)
    axes.annotate("Q, outside", (center, y - 6), color=BLUE, ha="center", fontsize=8)
    axes.annotate("the gripper's front", (0, high[1] - 15), ha="center", fontsize=8)
    axes.set(aspect="equal", xlim=(low[0] - 8, edge + 32), ylim=(low[1] - 8, high[1] + 8), xlabel="mm", ylabel="mm")


# ---- Known errors ----

@picture(6.8, 5.2)
def angle_map(axes, corners, rows):
    corners = np.array(corners)
    x, y = sorted({row["x_mm"] for row in rows}), sorted({row["y_mm"] for row in rows})

    def grid(values):
        return np.array(values).reshape(len(y), len(x))

    total = grid([row["sum_deg"] for row in rows])
    wrong = grid([row["called"] == "yes" and row["inside"] == "no" for row in rows]).astype(float)
    image = axes.pcolormesh(x, y, total, cmap="viridis", shading="nearest", rasterized=True, vmin=0, vmax=540)
    axes.contourf(x, y, wrong, levels=[0.5, 1.5], colors="none", hatches=["///"])
    axes.contour(x, y, wrong, levels=[0.5], colors=[RED], linewidths=1.2)
    axes.add_patch(Polygon(corners, facecolor="none", edgecolor="white", linewidth=2.5))
    axes.annotate("hatched: wrongly called inside", (0, min(y) + 8), ha="center", color="white", fontsize=9)
    axes.figure.colorbar(image, ax=axes, label="sum of the angles (degrees); from 356.4 on: inside")
    axes.set(aspect="equal", xlabel="mm", ylabel="mm", title="the gripper's front (white)")


@picture(8.4, 4.4, margins=(0.11, 0.27, 0.99, 0.93))
def false_areas(axes, outlines, rows):
    for i, row in enumerate(rows):
        share = 100 * row["share"]
        hull = 100 * row["hull"]
        axes.bar(i - 0.19, share, color=look_of("thesis").colour, width=0.36,
                 yerr=[[share - 100 * row["lower"]], [100 * row["upper"] - share]], capsize=3)
        axes.annotate(f"{unless_whole(row['share'], f'{share:.3g}')} %", (i - 0.19, 100 * row["upper"] + 3), ha="center", fontsize=7.5)
        axes.bar(i + 0.19, hull, color=look_of("hull").colour, width=0.36)
        axes.annotate(f"{hull:.0f} %", (i + 0.22, hull + 3), ha="center", fontsize=7.5, color="#555555")
        corners = np.array(outlines[row["outline"]])
        corners = (corners - corners.min(axis=0)) / (corners.max(axis=0) - corners.min(axis=0)).max()
        corners -= (corners.max(axis=0)) / 2
        small = axes.inset_axes([i - 0.32, -48, 0.64, 30], transform=axes.transData)
        small.add_patch(Polygon(corners, facecolor="#dddddd", edgecolor=BLACK, linewidth=0.8))
        small.set(xlim=(-0.55, 0.55), ylim=(-0.55, 0.55), aspect="equal")
        small.axis("off")
        axes.annotate(row["outline"], (i, -62), ha="center", annotation_clip=False, fontsize=9)
    axes.set_xticks([])
    axes.legend(handles=[Patch(color=look_of("thesis").colour, label="the thesis's angle sum (lines: 95 %)"),
                         Patch(color=look_of("hull").colour, label="the convex hull, which it is to avoid")], loc="upper left", fontsize=9)
    axes.set(ylabel="area outside taken for inside,\n% of the outline's own", ylim=(0, 195),
             title="factor 0.99, angles without signs")
    axes.grid(axis="y", alpha=0.3)


@picture(7, 4.6)
def false_hits(axes, rows):
    """`rows`: the numbers of the entry."""
    lines = {}
    for row in rows:
        if ", radius " in row["what"]:
            outline, rest = row["what"].split(", radius ")
            lines.setdefault(outline, []).append((float(rest.split(" %")[0]), row))
    for (color, style, marker), (outline, own) in zip(STYLES, lines.items()):
        aside = 1.04 ** (list(lines).index(outline) - (len(lines) - 1) / 2)  # so that outlines do not cover each other
        whiskers(axes, [radius * aside for radius, _ in own], *([float(row[name]) for _, row in own] for name in ("ours", "lower", "upper")),
                 color=color, linestyle=style, marker=marker, label=outline)
        stated = [(radius * aside, float(row["stated"])) for radius, row in own if row["stated"]]
        if stated:
            axes.plot(*zip(*stated), linestyle="", marker="o", markersize=9, markerfacecolor="none", markeredgecolor=color)
    axes.plot([], [], linestyle="", marker="o", markersize=9, markerfacecolor="none", markeredgecolor=GREY, label="our fact sheet")
    axes.set_xscale("log")
    axes.set_xticks([0.2, 1, 5, 10], ["0.2", "1", "5", "10"])
    axes.minorticks_off()
    axes.set(xlabel="radius of the ball (% of the outline's extent)", ylabel="false hits per true hit (%; bars: 95 %)",
             ylim=(-2, 70))
    axes.grid(alpha=0.3)
    axes.legend(ncols=2, fontsize=8)


@picture(6.6, 4)
def factor_reach(axes, rows):
    """Against what the factor lacks to 1, whose own place is beyond a gap of the axis."""
    lowest, exact = 1e-6, 1e-6  # of the reach, and where the factor 1 stands
    for outline, color, marker in (("square", BLUE, "o"), ("gripper", ORANGE, "s")):
        own = [row for row in rows if row["outline"] == outline]
        longest = max(row["length"] for row in own)
        own = list({row["factor"]: row for row in own if row["length"] == longest}.values())
        for n, row in enumerate(own):
            share, lacks = row["reach"] / row["length"], round(1 - row["factor"], 9) or exact
            axes.plot(lacks, max(share, lowest), marker=marker, color=color, markersize=7, linestyle="", markerfacecolor=color if share > lowest else "none",
                      label=outline if n == 0 else None)
            axes.annotate(f"{share:.3g}" if share > lowest else "none", (lacks, max(share, lowest)), xytext=(8, -2) if outline == "square" else (0, 9),
                          textcoords="offset points", ha="left" if outline == "square" else "center", va="center", fontsize=8, color=color)
    lacks = np.geomspace(1e-5, 0.04, 60)
    axes.plot(lacks, 1 / (2 * np.tan(np.radians(90 * (1 - lacks)))), color=BLACK, linewidth=1, linestyle="--", label="1 / (2 tan(90° · factor)), a convex outline")
    axes.axvline(3.2e-6, color=GREY, linewidth=0.6)
    axes.set(xscale="log", yscale="log", xlim=(exact / 2.5, 0.06), ylim=(lowest / 2, 1))
    axes.set_xticks([exact, 1e-4, 1e-2], ["1", "0.9999", "0.99"])
    axes.minorticks_off()
    axes.set_xlabel("factor of the full turn from which the foot counts as inside")
    axes.set_ylabel("how far outside the middle of the longest edge\nis called inside, as a share of its length")
    axes.grid(axis="y", alpha=0.3)
    axes.legend(fontsize=8)


@picture(7, 2.9)
def not_numbers(axes, rows):
    """Shares of one whole: each bar of floats is a part of the one above it."""
    floats, doubles, outside, missed_ = (float(row["ours"]) for row in rows)
    steps = [("floats: the arc cosine is not a number", floats, look_of("thesis-float").colour),
             ("of these, also: the point is called outside", floats * outside / 100, look_of("thesis-float").colour),
             ("of these, also: a contact is missed", floats * outside * missed_ / 1e4, look_of("thesis-float").colour),
             ("doubles: the arc cosine is not a number", doubles, look_of("thesis").colour)]
    for place, (words, value, color) in enumerate(steps):
        axes.barh(-place, value, color=color, height=0.62, alpha=(1, 0.7, 0.45, 1)[place])
        axes.annotate(f"{unless_whole(value / 100, f'{value:.3g}')} %", (value, -place), xytext=(4, 0), textcoords="offset points", va="center", fontsize=9)
    axes.set_yticks([-place for place in range(len(steps))], [words for words, _, _ in steps])
    axes.set(xlim=(0, 1.2 * max(value for _, value, _ in steps)), xlabel="% of all points on edges",
             title="Feet on an edge, where the cosine of the angle rounds to below −1")
    axes.grid(axis="x", alpha=0.3)


@picture(6.8, 4)
def touching(axes, rows):
    kinds = (("missed", "thesis", "as it is"), ("missed_signed", "thesis-signed", "with signed angles"),
             ("missed_closed", "thesis-closed", "where touching counts"))
    hatches = ("", "", "///")  # two have the same colour
    for j, (name, method, text) in enumerate(kinds):
        for i, row in enumerate(rows):
            value = 100 * row[name] / row["balls"]
            axes.bar(i + (j - 1) * 0.26, value, width=0.24, color=look_of(method).colour, hatch=hatches[j], edgecolor="white", linewidth=0,
                     label=text if i == 0 else None)
            axes.annotate(f"{value:.3g}", (i + (j - 1) * 0.26, value + 1.5), ha="center", fontsize=8)
    axes.set_xticks(range(len(rows)), [row["touched"] + "s" for row in rows])
    axes.set(ylabel="contacts missed (%)", ylim=(0, 135))
    axes.set_yticks(range(0, 101, 20))
    axes.set_title("balls that touch in exactly one point")
    axes.grid(axis="y", alpha=0.3)
    axes.legend(fontsize=8, ncols=3, loc="upper center")


@picture(5.6, 4.2)
def collinear(axes, corners, rows):
    corners = np.array(corners)
    axes.add_patch(Polygon(corners, facecolor="#eeeeee", edgecolor=BLACK, linewidth=1.5))
    for i, point in enumerate((corners[0], (corners[0] + corners[1]) / 2, corners[1])):
        axes.plot(*point, marker="o", color=RED, markersize=7)
        axes.annotate(f"P{i}", point, xytext=(0, -17), textcoords="offset points", ha="center", color=RED)
    axes.set(aspect="equal", ylim=(corners[:, 1].min() - 16, corners[:, 1].max() + 8),
             xlim=(corners[:, 0].min() - 10, corners[:, 0].max() + 10), xlabel="mm", ylabel="mm")
    first, every = (f"{unless_whole(float(row['ours']) / 100, row['ours'])} %" for row in rows)
    axes.set_title(f"contacts missed: {first} with N of P0, P1, P2; {every} with N of all vertices")


@picture(6.8, 4)
def far_away(axes, rows):
    for name, method, text in (("wrong_signed_float", "thesis-signed-float", "thesis, signed angles, floats"),
                               ("wrong_signed", "thesis-signed", "the same in doubles"), ("wrong_fast", "fast", "ours in plain doubles")):
        look = look_of(method)
        axes.plot([row["offset_mm"] for row in rows], [100 * row[name] / row["balls"] for row in rows], color=look.colour,
                  linestyle=look.line, marker=look.marker, markersize=4, label=text)
    axes.set_xscale("log")
    axes.set_yscale("symlog", linthresh=0.01)
    axes.set_ylim(-0.002, 100)
    axes.set_yticks([0, 0.01, 0.1, 1, 10, 100], ["none", "0.01", "0.1", "1", "10", "100"])
    axes.axhline(0.01, color=GREY, linewidth=0.6, linestyle="--")
    axes.annotate("logarithmic above, linear below", (1, 0.01), xycoords=("axes fraction", "data"), xytext=(-2, 2), textcoords="offset points",
                  ha="right", fontsize=7, color="#555555")
    axes.set(xlabel="moved from the origin along every axis (mm)", ylabel="wrong answers (%)",
             title="the gripper, 90 mm wide, and balls of 4.5 mm")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)


@picture(6.8, 4.2)
def missed(axes, rows):
    draw_missed(axes, rows)
    axes.set(xlabel="step of the joint (degrees); the thesis's is 1", ylabel="missed first contacts (%; bars: 95 %)",
             ylim=(-2, 102))
    axes.legend(title="radius of the sphere", fontsize=8, loc="lower right")
