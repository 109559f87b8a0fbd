# SPDX-License-Identifier: Apache-2.0
"""Where plain doubles misplace the foot of a centre above an edge, double by double: python3 failure_map.py [PICTURE]"""
import sys

import matplotlib
import numpy as np
import touchstone_contact as touchstone

matplotlib.use("Agg")
import matplotlib.pyplot as plt

half = 64
steps = np.arange(-half, half + 1)
outline = [[-12.1, -7.3], [12.7, 9.9], [10, 20], [1, 8], [-10, 20]]
notched = touchstone.Polygon([[x, y, x / 4 + y / 8] for x, y in outline])
start, end = notched.outer[:2]
above = start + 0.51 * (end - start) + [-0.125, -0.0625, 0.5]  # along the normal from a point of edge 0
x, y = np.meshgrid(above[0] + steps * np.spacing(above[0]), above[1] + steps * np.spacing(above[1]))
balls = np.stack([x, y, np.full_like(x, above[2]), np.ones_like(x)], axis=-1).reshape(-1, 4)
said, true = touchstone.fast.foot(balls, notched), touchstone.filtered.foot(balls, notched)  # inside 0 to outside 2
plt.imshow((true - said).reshape(x.shape), origin="lower", extent=[-half, half] * 2, cmap="coolwarm", vmin=-2, vmax=2)
wrong = ["outside for inside", "one place too far out", "right", "one place too far in", "inside for outside"]
plt.colorbar(ticks=range(-2, 3)).ax.set_yticklabels(wrong)
plt.xlabel("x of the centre, in doubles")
plt.ylabel("y of the centre, in doubles")
plt.title(f"fast misplaces {np.count_nonzero(said != true)} of {said.size} feet near an edge")
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "failure_map.png", dpi=150, bbox_inches="tight")
