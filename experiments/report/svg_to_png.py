# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: svg_to_png.py SVG PNG

Draws what `touchstone show --svg` writes (lines, circles, rectangles, paths of straight lines, texts and panels that are
cut off) as a PNG, with Matplotlib. Anything else in the file is an error.
"""
import pathlib
import sys
import xml.etree.ElementTree

import matplotlib

from replacing import replacing

matplotlib.use("Agg")
from matplotlib import figure, patches, path  # noqa: E402

SCALE = 2  # pixels of a unit
ANCHORS = {"start": "left", "middle": "center", "end": "right"}


def style(element):
    fill, stroke = element.get("fill", "none"), element.get("stroke", "none")
    face = matplotlib.colors.to_rgba(fill, float(element.get("fill-opacity", 1))) if fill != "none" else "none"
    dashes = (0, (4, 3)) if element.get("stroke-dasharray") else "solid"
    return {"facecolor": face, "edgecolor": stroke, "linewidth": float(element.get("stroke-width", 0)) * 0.75, "linestyle": dashes}


def vertices(data):
    """The loops of a path, each ended by Z."""
    points, codes = [], []
    for loop in data.split("Z")[:-1]:
        corners = [tuple(map(float, pair.split())) for pair in loop.replace("M", "").split("L")]
        points += [*corners, corners[0]]
        codes += [path.Path.MOVETO, *[path.Path.LINETO] * (len(corners) - 1), path.Path.CLOSEPOLY]
    return path.Path(points, codes)


def draw(axes, element, dx, dy, clip):
    """Draws an element that is moved by (dx, dy)."""
    name = element.tag.rpartition("}")[2]
    number = lambda key: float(element.get(key))
    if name == "svg":
        dx, dy = dx + float(element.get("x", 0)), dy + float(element.get("y", 0))
        box = patches.Rectangle((dx, dy), number("width"), number("height"), transform=axes.transData)
        for child in element:
            draw(axes, child, dx, dy, box)
        return
    if name == "title":
        return
    if name == "line":
        ends = path.Path([(number("x1") + dx, number("y1") + dy), (number("x2") + dx, number("y2") + dy)])
        shape = patches.PathPatch(ends, **{**style(element), "facecolor": "none"})
    elif name == "circle":
        shape = patches.Circle((number("cx") + dx, number("cy") + dy), number("r"), **style(element))
    elif name == "rect":
        shape = patches.Rectangle((number("x") + dx, number("y") + dy), number("width"), number("height"), **style(element))
    elif name == "path":
        moved = vertices(element.get("d")).transformed(matplotlib.transforms.Affine2D().translate(dx, dy))
        shape = patches.PathPatch(moved, **style(element))
    elif name == "text":
        axes.text(number("x") + dx, number("y") + dy, (element.text or "").replace("$", r"\$"), fontsize=number("font-size") * 0.72,
                  color=element.get("fill"), ha=ANCHORS[element.get("text-anchor")], va="baseline")
        return
    else:
        sys.exit(f"svg_to_png.py: <{name}> is not drawn")
    axes.add_patch(shape)
    if clip is not None:
        shape.set_clip_path(clip)


def main(source, target):
    root = xml.etree.ElementTree.parse(source).getroot()
    width, height = float(root.get("width")), float(root.get("height"))
    drawing = figure.Figure(figsize=(width / 72 * 0.72, height / 72 * 0.72))
    axes = drawing.add_axes((0, 0, 1, 1))
    axes.set(xlim=(0, width), ylim=(height, 0))
    axes.axis("off")
    for child in root:
        draw(axes, child, 0, 0, None)
    with replacing(pathlib.Path(target)) as file:
        drawing.savefig(file, format="png", dpi=100 * SCALE)


if __name__ == "__main__":
    main(*sys.argv[1:])
