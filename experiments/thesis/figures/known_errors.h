// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/thesis/figures/outlines.h"

/// The known errors of the thesis's method except for its angle sum, each measured on one outline. All functions depend
/// on their arguments only; the truth is `filtered`. Cost: some microseconds per sample.
namespace touchstone::figures {

/// The distance up to which points outside the middle of an edge count as inside.
struct FactorReach {
  std::size_t edge;
  double length;
  double factor;
  double reach;  ///< to 1e-12 of the length
};
/// Measures it for every edge and the factors 0.99, 0.9999 and 1.
[[nodiscard]] std::vector<FactorReach> measure_factor_reach(const Outline& outline);
/// Returns length / (2 tan(90 degrees x factor)): the distance for a convex outline, at a single visible edge.
[[nodiscard]] double derived_factor_reach(double length, double factor);

/// The results for points of edges rounded to floats, with the outline scaled to a width of 1000 and turned at random.
struct NotNumbers {
  std::uint64_t samples = 0;
  std::uint64_t in_floats = 0, in_doubles = 0;  ///< u.v / |u||v| beyond -1, so that its arc cosine is NaN
  std::uint64_t called_outside = 0;  ///< the number of those in floats that the method in floats calls outside
  std::uint64_t misses = 0;          ///< the number of those at which it misses the contact of a ball of radius 1
};
[[nodiscard]] NotNumbers measure_not_numbers(const Outline& outline, std::uint64_t samples, std::uint64_t seed);

/// The results for balls that touch in exactly one point.
struct Touching {
  std::uint64_t samples = 0;
  std::uint64_t missed = 0;         ///< by the original method
  std::uint64_t missed_signed = 0;  ///< with signed angles, which add no area to the outline
  std::uint64_t missed_closed = 0;  ///< by the original method, but touching counts as contact
};
enum class Touched { Face, Edge, Vertex };
/// Requires an outline whose corners are whole numbers below 2^20, its edges 8 or longer and along the axes.
[[nodiscard]] Touching measure_touching(const Outline& outline, Touched what, std::uint64_t samples,
                                        std::uint64_t seed);

/// The results for the outline started with an additional vertex in the middle of its first edge, which changes only N.
struct Collinear {
  std::uint64_t contacts = 0;
  std::uint64_t missed = 0;         ///< by the original method
  std::uint64_t missed_newell = 0;  ///< with the Newell normal
};
[[nodiscard]] Collinear measure_collinear(const Outline& outline, std::uint64_t samples, std::uint64_t seed);

/// The results for the outline and balls around it, tilted and moved by `offset` along every axis, all rounded to
/// doubles; the truth is for the rounded input.
struct FarAway {
  double offset;
  std::uint64_t samples = 0;
  /// Wrong answers of the method with signed angles (without them it would be wrong in the gap anyway), in doubles and
  /// in floats, and of `fast`.
  std::array<std::uint64_t, 3> wrong{};
};
[[nodiscard]] FarAway measure_far_away(const Outline& outline, double offset, std::uint64_t samples,
                                       std::uint64_t seed);

/// The errors of feet Q = C - s N of balls near a polygon anywhere in space, compared with the correctly rounded ones,
/// if the exact foot is inside.
struct FootErrors {
  std::uint64_t samples = 0;
  double in_doubles = 0, in_floats = 0;  ///< the largest distance, in the unit of the polygon
};
/// Draws balls with centres at random points of the polygon's bounding box enlarged by the radius.
[[nodiscard]] FootErrors measure_foot_errors(const Polygon& polygon, double radius, std::uint64_t samples,
                                             std::uint64_t seed);

/// The positions of balls along edges, for every edge and the balls of a flowchart whose foot is outside.
struct EdgePlaces {
  std::uint64_t pairs = 0;
  std::uint64_t before = 0, beside = 0, beyond = 0;  ///< t clamped to the start; within; clamped to the end
  std::array<std::uint64_t, 2> wrong{};  ///< edge tests of `thesis` and `thesis-float` that differ from the exact ones
};
[[nodiscard]] EdgePlaces measure_edge_places(const Outline& outline, double radius, std::uint64_t balls,
                                             std::uint64_t seed);

}  // namespace touchstone::figures
