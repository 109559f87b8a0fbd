// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons to begin with.

const SAMPLES = {
  "gripper": {loops: [[[0, 0, 0], [3, 0, 0], [3, 3, 0], [2, 3, 0], [2, 1, 0], [1, 1, 0], [1, 3, 0], [0, 3, 0]]],
              ball: {center: [1.5, 2, 0], radius: 0.5}},
  "triangle of tenths": {loops: [[[0.1, 0.1, 0.3], [1.3, 0.2, 0.3], [0.7, 1.1, 0.3]]], ball: {center: [1.0, 0.65, 0.4], radius: 0.1}},
  "frame with a hole": {loops: [[[0, 0, 0], [6, 0, 0], [6, 5, 0], [0, 5, 0]], [[2, 1.5, 0], [2, 3.5, 0], [4, 3.5, 0], [4, 1.5, 0]]],
                        ball: {center: [3, 2.5, 0.75], radius: 1.25}},
  "tilted L": {loops: [[[0, 0, 0], [4, 0, 1], [4, 1, 1.25], [1, 1, 0.5], [1, 4, 1.25], [0, 4, 1]]], ball: {center: [1.4, 1.4, 1.1], radius: 0.5}},
  "far from the origin": {loops: [[[1e8, 1e8, 1e8], [1e8 + 3, 1e8, 1e8 + 1], [1e8 + 1, 1e8 + 3, 1e8 + 2]]],
                          ball: {center: [1e8 + 1.5, 1e8 + 1.25, 1e8 + 2], radius: 1}},
};
