// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::workloads {

struct TriangleQuery {
  Ball ball;
  Triangle triangle;
};

/// The families of queries about triangles.
enum class TriangleFamily {
  Random,    ///< vertices and centre uniform in the unit cube, radius uniform in [0, 0.5)
  HalfNear,  ///< a random half of them with the radius at (1 +- 2^-50) x the exact distance, to face, edge or vertex
  LatticeTangent,  ///< touching exactly a face, an edge or a vertex: integers up to 2^20
  Slivers,         ///< Random, but the third vertex at 1e-8 of the length of an edge from that edge
  Far,             ///< Random, moved by 1e6 in a random direction
  Extreme,  ///< Random, times 2^-1000, 2^-500, 2^480 or 2^1000, or each point and the radius times its own one of these
  Near,     ///< as the near half of HalfNear
};

[[nodiscard]] std::string_view to_string(TriangleFamily family);
[[nodiscard]] std::string_view summary(TriangleFamily family);
[[nodiscard]] const std::vector<TriangleFamily>& all_triangle_families();

/// Draws query number `index`: a function of (family, seed, index) alone; `exact::validate` accepts the triangle.
/// Requires rounding to nearest. Cost: about 1 us; HalfNear 30 us.
[[nodiscard]] TriangleQuery draw_triangle_query(TriangleFamily family, std::uint64_t seed, std::uint64_t index);

inline constexpr double kLargestCoordinate = 0x1p20;

/// Draws a ball that touches a triangle exactly, at its face, an edge or a vertex, with equal probability. All numbers
/// are integers, |.| <= kLargestCoordinate.
///
/// Uses an integer frame (workloads::lattice_frame), so that the normal is Pythagorean; the distance to the edge or the
/// vertex is a Pythagorean triple or quadruple in the units of the frame.
[[nodiscard]] TriangleQuery draw_lattice_tangent(Random& random);

/// Draws query number `index` of `Random` with the double nearest to the exact distance as its radius. The nearest
/// feature is a face, an edge or a vertex with equal probability, because faces are rare among random queries.
[[nodiscard]] TriangleQuery draw_query_at_contact(std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone::workloads
