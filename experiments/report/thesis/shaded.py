# SPDX-License-Identifier: GPL-3.0-or-later
"""Shaded pictures of solids: triangles with a depth buffer, and the visible creases between them as lines.

Same data, same bytes: nothing here depends on the time or on chance."""
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgb

CREASE = np.cos(np.radians(25))  # edges between faces that meet at less are those of round things


class Solid:
    """Triangles of one colour, with the edges that are drawn."""

    def __init__(self, vertices, triangles, color, alpha=1.0):
        self.vertices = np.asarray(vertices, float)
        self.triangles = np.asarray(triangles, int)
        self.color = np.array(to_rgb(color))
        self.creases = creases(self.vertices, self.triangles)
        self.hollow = alpha == 0  # its edges alone are drawn

    def moved(self, pose):
        """`pose`: a rotation, row by row, and a translation."""
        other = object.__new__(Solid)
        other.__dict__.update(self.__dict__)
        other.vertices = self.vertices @ np.reshape(pose[:9], (3, 3)).T + np.asarray(pose[9:])
        return other


def creases(vertices, triangles):
    """Pairs of vertices, the edges at which the surface bends."""
    normals = {}
    corners = vertices[triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(across, axis=1)
    for triangle, normal, length in zip(triangles, across, lengths):
        if length == 0:
            continue
        for i in range(3):
            edge = tuple(sorted((triangle[i], triangle[(i + 1) % 3])))
            normals.setdefault(edge, []).append(normal / length)
    return np.array([edge for edge, found in sorted(normals.items())
                     if len(found) != 2 or found[0] @ found[1] < CREASE], int).reshape(-1, 2)


class Camera:
    """Looks at `target` from a direction: degrees counter-clockwise from x, and above the horizon. `width`: of what is
    seen at the target, in the unit of the solids; `distance` of the eye, in such widths."""

    def __init__(self, target, azimuth, elevation, width, distance=3.5):
        a, e = np.radians(azimuth), np.radians(elevation)
        self.back = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
        self.right = np.array([-np.sin(a), np.cos(a), 0])
        self.up = np.cross(self.back, self.right)
        self.target, self.width, self.distance = np.asarray(target, float), width, distance * width

    def project(self, points):
        """x and y in the unit of the solids at the target's depth, and the nearness: 1 there, more in front."""
        moved = np.asarray(points, float) - self.target
        nearness = self.distance / (self.distance - moved @ self.back)
        return np.stack([moved @ self.right * nearness, moved @ self.up * nearness, nearness], axis=-1)

    def eye(self):
        return self.target + self.distance * self.back


def fill(image, depth, corners, color):
    """One triangle: x and y in pixels, and the nearness."""
    height, width = depth.shape
    low = np.maximum(np.floor(corners[:, :2].min(axis=0)).astype(int), 0)
    high = np.minimum(np.ceil(corners[:, :2].max(axis=0)).astype(int) + 1, (width, height))
    if (low >= high).any():
        return
    x, y = np.arange(low[0], high[0])[None, :] + 0.5, np.arange(low[1], high[1])[:, None] + 0.5
    (x0, y0, z0), (x1, y1, z1), (x2, y2, z2) = corners
    area = (x1 - x0) * (y2 - y0) - (y1 - y0) * (x2 - x0)
    if area == 0:
        return
    b1 = ((x - x0) * (y2 - y0) - (y - y0) * (x2 - x0)) / area
    b2 = ((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)) / area
    inside = (b1 >= -1e-9) & (b2 >= -1e-9) & (b1 + b2 <= 1 + 1e-9)
    z = z0 + b1 * (z1 - z0) + b2 * (z2 - z0)
    part = depth[low[1]:high[1], low[0]:high[0]]
    nearer = inside & (z > part)
    part[nearer] = z[nearer]
    image[low[1]:high[1], low[0]:high[0]][nearer] = color


def draw(axes, solids, camera, aspect=0.75, pixels=900):
    """Fills the axes, which get no frame: `aspect` is height by width."""
    width, height = pixels, int(pixels * aspect)
    image, depth = np.ones((height, width, 4)), np.full((height, width), 1e-9)
    image[..., 3] = 0
    scale = pixels / camera.width

    def to_pixels(points):
        seen = camera.project(points)
        seen[..., 0] = seen[..., 0] * scale + width / 2
        seen[..., 1] = seen[..., 1] * scale + height / 2
        return seen

    light = camera.right * 0.35 + camera.up * 0.6 + camera.back * 0.75
    light /= np.linalg.norm(light)
    for solid in solids:
        if solid.hollow:
            continue
        corners = solid.vertices[solid.triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        lengths = np.linalg.norm(normals, axis=1)
        seen = to_pixels(corners)
        facing = np.einsum("ij,ij->i", normals, camera.eye() - corners[:, 0])
        for triangle, normal, length, front in zip(seen, normals, lengths, facing):
            if length == 0 or front <= 0:
                continue
            shade = 0.52 + 0.48 * max(0.0, normal @ light / length)
            fill(image, depth, triangle, (*np.clip(solid.color * shade, 0, 1), 1))
    axes.imshow(image, origin="lower", extent=(0, width, 0, height), interpolation="antialiased")
    draw_creases(axes, solids, to_pixels, depth)
    axes.set(xlim=(0, width), ylim=(0, height), aspect="equal")
    axes.axis("off")
    return lambda point: to_pixels(np.asarray(point, float))[:2]


def draw_creases(axes, solids, to_pixels, depth):
    height, width = depth.shape
    # What lies on a surface must not be hidden by it: the nearest neighbour that is furthest off decides.
    padded = np.pad(depth, 1, constant_values=1e-9)
    least = np.min([padded[i:i + height, j:j + width] for i in range(3) for j in range(3)], axis=0)
    for solid in solids:
        if len(solid.creases) == 0:
            continue
        ends = to_pixels(solid.vertices[solid.creases])
        lines = []
        for a, b in ends:
            steps = max(2, int(np.hypot(*(b - a)[:2]) / 2) + 1)
            t = np.linspace(0, 1, steps)[:, None]
            points = a + t * (b - a)
            column, row = points[:, 0].astype(int), points[:, 1].astype(int)
            known = (column >= 0) & (column < width) & (row >= 0) & (row < height)
            shown = known.copy()
            shown[known] = points[known, 2] >= least[row[known], column[known]] - 2e-4
            runs = np.flatnonzero(np.diff(np.concatenate([[0], shown.astype(int), [0]])))
            lines += [points[[begin, end - 1], :2] for begin, end in zip(runs[::2], runs[1::2]) if end - begin > 1]
        style = {"linewidths": 0.9, "linestyles": "--", "colors": [solid.color]} if solid.hollow else \
            {"linewidths": 0.5, "colors": "#222222"}
        axes.add_collection(LineCollection(lines, capstyle="round", **style))
