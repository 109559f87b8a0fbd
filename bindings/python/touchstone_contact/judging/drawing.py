# SPDX-License-Identifier: Apache-2.0
"""Draws a question in the polygon's plane."""

from __future__ import annotations

import html
import math
from typing import Any

import numpy as np

from .. import filtered
from .question import Question

_WIDTH, _HEIGHT, _TEXT = 360, 320, 66
_MOST = 1e5  # pixels: what is farther out is not seen


def svg(question: Question, *captions: str) -> str:
    """Returns a picture: the polygon, the ball from above (dashed) and where it cuts the plane, the foot of its centre (a
    cross), and the nearest point (a dot). A small ball is shown with its surroundings alone. A moving ball is drawn at its
    first contact, or at its end if it has none; of a mesh, the nearest face. The title of a line that is cut has all of it.
    """
    if question.faces is not None:
        nearest_face: Any = question.scene.nearest(question.row()[:4])
        question = question.about_face(int(question.scene.face_numbers("mesh")[nearest_face.face]))
    centre = np.array(question.centre)
    if question.to:
        first: Any = filtered.first_contact(question.row(), question.polygon)
        centre = centre + min(first.time, 1.0) * (np.array(question.to) - centre)
    answer: Any = filtered.answer([*centre, question.radius], question.polygon)
    scale = question.size() or 1.0  # the numbers may be huge or tiny
    loops = [np.array(loop) / scale for loop in (question.vertices, *question.holes)]
    origin = loops[0].mean(axis=0)
    size = float(np.ptp(loops[0], axis=0).max()) or 1.0
    loops = [(loop - origin) / size for loop in loops]
    edges = np.roll(loops[0], -1, axis=0) - loops[0]
    normal = np.cross(loops[0], np.roll(loops[0], -1, axis=0)).sum(axis=0)
    normal /= np.linalg.norm(normal) or 1.0
    across = edges[np.argmax(np.linalg.norm(edges, axis=1))]
    across /= np.linalg.norm(across)
    axes = np.array([across, np.cross(normal, across)])
    from_origin = (centre / scale - origin) / size
    outline, foot, nearest = [loop @ axes.T for loop in loops], axes @ from_origin, axes @ ((answer.point / scale - origin) / size)
    radius, height = question.radius / scale / size, float(from_origin @ normal)
    section = math.sqrt(max(radius * radius - height * height, 0.0))

    if 0 < radius < 0.15 and np.abs(foot).max() < 2:
        shown = foot + max(radius, 1e-9) * 2.5 * np.array([[-1, -1], [1, 1]])
    else:
        near = [foot] if np.abs(foot).max() < 2 else []
        ball = [foot - radius, foot + radius] if near and radius < 2 else []
        shown = np.concatenate([*outline, [nearest, *near, *ball]])
    low, high = shown.min(axis=0), shown.max(axis=0)
    unit = min((_WIDTH - 30) / max(high[0] - low[0], 1e-12), (_HEIGHT - 30 - _TEXT) / max(high[1] - low[1], 1e-12))

    def at(point: Any) -> tuple[float, float]:
        x, y = np.clip((point - (low + high) / 2) * unit * [1, -1], -_MOST, _MOST) + [_WIDTH / 2, (_HEIGHT + _TEXT) / 2]
        return float(x), float(y)

    path = " ".join("M" + " L".join("{:.2f} {:.2f}".format(*at(p)) for p in loop) + " Z" for loop in outline)
    (x, y), (u, v) = at(foot), at(nearest)
    circle = f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{{:.2f}}" stroke="#d9822b" {{}}/>'
    lines = [*captions, f"exactly {answer.relation}, foot {answer.foot}, depth {answer.depth:.6g}"]
    texts = "".join(f'<text x="6" y="{16 + 17 * i}" font-family="sans-serif" font-size="11"><title>{html.escape(line)}</title>'
                    f'{html.escape(line if len(line) < 56 else line[:53] + "...")}</text>' for i, line in enumerate(lines))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}" height="{_HEIGHT}" viewBox="0 0 {_WIDTH} {_HEIGHT}">'
            f'<rect width="100%" height="100%" fill="white"/>'
            f'<path d="{path}" fill="#cfe0f3" stroke="#1f4e79" stroke-width="1.5" fill-rule="evenodd"/>'
            + circle.format(min(radius * unit, _MOST), 'fill="none" stroke-dasharray="4 3"')
            + circle.format(min(section * unit, _MOST), 'fill="#d9822b" fill-opacity="0.25"') +
            f'<path d="M{x - 5:.2f} {y:.2f} h10 M{x:.2f} {y - 5:.2f} v10" stroke="black"/><circle cx="{u:.2f}" cy="{v:.2f}" r="3" fill="#a61c28"/>'
            f'<rect width="100%" height="{_TEXT - 8}" fill="white" fill-opacity="0.85"/>{texts}</svg>')
