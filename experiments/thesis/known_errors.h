// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/studies/stability/outlines.h"

/// The known errors of the thesis's method but for its angle sum, each measured on one outline. Functions of their
/// arguments; truth is `filtered`. Cost: some microseconds a sample.
namespace touchstone::thesis_figures {

/// How far outside the middle of an edge a point still counts as inside.
struct FactorReach {
  std::size_t edge;
  double length;
  double factor;
  double reach;  ///< to 1e-12 of the length
};
/// For every edge and the factors 0.99, 0.9999 and 1.
[[nodiscard]] std::vector<FactorReach> measure_factor_reach(const stability::Outline& outline);
/// length / (2 tan(90 degrees x factor)): that of an outline that is convex, at an edge seen alone.
[[nodiscard]] double derived_factor_reach(double length, double factor);

/// Points of edges rounded to floats, the outline made 1000 wide and turned at random.
struct NotNumbers {
  std::uint64_t samples = 0;
  std::uint64_t in_floats = 0, in_doubles = 0;  ///< u.v / |u||v| beyond -1, so that its arc cosine is NaN
  std::uint64_t called_outside = 0;             ///< of those in floats, by the method in floats
  std::uint64_t misses = 0;                     ///< of those, balls of radius 1 there that it finds no contact of
};
[[nodiscard]] NotNumbers measure_not_numbers(const stability::Outline& outline, std::uint64_t samples,
                                             std::uint64_t seed);

/// Balls that touch in one point, exactly.
struct Touching {
  std::uint64_t samples = 0;
  std::uint64_t missed = 0;         ///< by the method as it is
  std::uint64_t missed_signed = 0;  ///< with signed angles, which take in nothing beside the outline
  std::uint64_t missed_closed = 0;  ///< as it is, but touching counts
};
enum class Touched { Face, Edge, Vertex };
/// Requires an outline whose corners are whole numbers below 2^20, its edges 8 or longer and along the axes.
[[nodiscard]] Touching measure_touching(const stability::Outline& outline, Touched what, std::uint64_t samples,
                                        std::uint64_t seed);

/// The outline begun with a further vertex in the middle of its first edge: nothing is changed but N.
struct Collinear {
  std::uint64_t contacts = 0;
  std::uint64_t missed = 0;         ///< by the method as it is
  std::uint64_t missed_newell = 0;  ///< with the Newell normal
};
[[nodiscard]] Collinear measure_collinear(const stability::Outline& outline, std::uint64_t samples, std::uint64_t seed);

/// The outline and balls about it, tilted and moved by `offset` along every axis, all rounded to doubles; truth is
/// about these.
struct FarAway {
  double offset;
  std::uint64_t samples = 0;
  /// Answers of the method with signed angles, which alone would err in the gap anyway: in doubles and in floats; and
  /// of `fast`.
  std::array<std::uint64_t, 3> wrong{};
};
[[nodiscard]] FarAway measure_far_away(const stability::Outline& outline, double offset, std::uint64_t samples,
                                       std::uint64_t seed);

/// Feet Q = C - s N of balls about a polygon anywhere in space, beside those rounded correctly; where the exact foot is
/// inside.
struct FootErrors {
  std::uint64_t samples = 0;
  double in_doubles = 0, in_floats = 0;  ///< the largest distance, in the unit of the polygon
};
/// Balls: centres at random points of the polygon's bounding box enlarged by the radius.
[[nodiscard]] FootErrors measure_foot_errors(const Polygon& polygon, double radius, std::uint64_t samples,
                                             std::uint64_t seed);

/// Where a ball is along an edge, for every edge and the balls of a flowchart whose foot is outside.
struct EdgePlaces {
  std::uint64_t pairs = 0;
  std::uint64_t before = 0, beside = 0, beyond = 0;  ///< t clamped to the start; within; clamped to the end
  std::array<std::uint64_t, 2> wrong{};              ///< edge tests of `thesis`, `thesis-float` unlike the exact ones
};
[[nodiscard]] EdgePlaces measure_edge_places(const stability::Outline& outline, double radius, std::uint64_t balls,
                                             std::uint64_t seed);

}  // namespace touchstone::thesis_figures
