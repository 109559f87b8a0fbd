// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/methods/method.h"
#include "experiments/workloads/workload.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::near_edge {

/// What a ball is moved across, double by double.
enum class Threshold {
  Face,        ///< the radius across the distance to the polygon, the nearest feature being its face
  Edge,        ///< the same, an edge
  Vertex,      ///< the same, a vertex
  Tangent,     ///< the same, where that distance is exactly a double; the nearest feature is any
  FootEdge,    ///< the centre, along one axis, so that its foot crosses an edge; ample radius
  FootVertex,  ///< the same, past a vertex
};

[[nodiscard]] std::string_view word(Threshold threshold);
/// Is the radius moved (else the centre)?
[[nodiscard]] bool moves_radius(Threshold threshold);

/// What is sampled apart from the rest.
struct Stratum {
  workloads::Family family;
  workloads::Placement placement;
  Threshold threshold;
};

/// All of them; exactly tangent balls need the lattice.
[[nodiscard]] const std::vector<Stratum>& all_strata();
[[nodiscard]] const std::vector<Threshold>& all_thresholds();

/// How far balls are moved, in doubles, ascending: every double from -8 to 8, then powers of 4 up to 2^32.
[[nodiscard]] const std::vector<std::int64_t>& all_offsets();

/// A polygon, and balls across a threshold: one an offset.
///
/// Radius: offset 0 is the double nearest to the exact distance, larger radii are positive.
/// Foot: offset 0 is the last centre whose foot is not outside; offset 1, the next double, is outside.
struct Crossing {
  Polygon polygon;
  std::vector<Ball> balls;
  std::vector<methods::PartialAnswer> truths;  ///< of each ball: plane, foot, edges_hit, contact; by `exact`
};

/// Sample number `n` of a stratum: a function of (stratum, seed, n) alone. Nothing where none was found.
[[nodiscard]] std::optional<Crossing> draw_crossing(std::size_t stratum, std::uint64_t seed, std::uint64_t n);

}  // namespace touchstone::near_edge
