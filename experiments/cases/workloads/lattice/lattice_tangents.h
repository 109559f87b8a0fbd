// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/cases/workloads/lattice/triangle_queries.h"
#include "experiments/cases/workloads/random.h"

namespace touchstone::workloads {

inline constexpr double kLargestCoordinate = 0x1p20;

/// Draws a ball that touches a triangle exactly, at its face, an edge or a vertex, with equal probability. All numbers
/// are integers, |.| <= kLargestCoordinate.
///
/// Uses an integer frame (workloads::lattice_frame), so that the normal is Pythagorean; the distance to the edge or the
/// vertex is a Pythagorean triple or quadruple in the units of the frame.
[[nodiscard]] TriangleQuery draw_lattice_tangent(workloads::Random& random);

}  // namespace touchstone::workloads
