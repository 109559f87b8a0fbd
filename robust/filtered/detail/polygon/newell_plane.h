// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/numbers/lane_vector.h"
#include "robust/filtered/detail/numbers/length_unit.h"
#include "robust/filtered/detail/numbers/vector3.h"

namespace touchstone::filtered::detail {

/// A vertex in a frame's unit of length: x, y, z, and 0.
struct ScaledVertex {
  double coordinates[4];
};

/// Returns a frame's unit of length: no vertex is farther than 1/4 from vertex 0 in any coordinate.
[[nodiscard]] LengthUnit frame_unit(const Polygon& polygon);

/// Returns the vertices in this unit; nothing if that loses a bit. Requires round to nearest, and subnormal
/// numbers.
[[nodiscard]] std::optional<std::vector<ScaledVertex>> scaled_vertices(const Polygon& polygon, const LengthUnit& unit);

/// Sums over the vertices p_i of a loop, from vertex 0, in double-doubles.
struct NewellSums {
  DoubleDouble normal[3];    ///< the Newell normal: the sum of p_i x p_(i + 1)
  double error[3];           ///< bounds of the normal's errors, except what underflows
  DoubleDouble vertices[3];  ///< the sum of p_i
};

inline namespace TOUCHSTONE_TARGET {

/// Returns the sums over the first `count` vertices. The remainders that error-free sums leave bound the errors.
///
/// With u = 2^-53, a difference's rest is at most u of it. So a product is known to 8 u^2 of itself with a rest of at
/// most 4 u; the sums of rests lose at most 15 u^2 of both products and u^2 of a partial sum. Together with the
/// remainders, 32 u^2 of products and partial sums bound what is lost, except what underflows: 2^-1069 a product.
/// Requires at least three and at most EdgeTree::kMostEdges vertices within 1/2 of vertex 0 in each coordinate, and
/// round to nearest.
inline NewellSums newell_sums(const ScaledVertex* vertices, std::size_t count) {
  const Pack zero = all_lanes(0), origin = load(vertices[0].coordinates);
  PackPair sum{zero, zero}, normal{zero, zero};
  Pack remainders = zero, magnitudes = zero;
  Pack here = load(vertices[1].coordinates);
  for (std::size_t i = 1; i < count; ++i) {
    const Pack next = i + 1 < count ? load(vertices[i + 1].coordinates) : origin;
    // p x edge is p x (p + edge), and edges are short, so the terms are small.
    const PackPair p = two_difference(here, origin), edge = two_difference(next, here);
    here = next;

    const auto next_of = [](const PackPair& v) { return PackPair(next_of_three(v.high), next_of_three(v.low)); };
    const auto previous_of = [](const PackPair& v) {
      return PackPair(previous_of_three(v.high), previous_of_three(v.low));
    };
    const PackPair first = unnormalised_product(next_of(p), previous_of(edge));
    const PackPair second = unnormalised_product(previous_of(p), next_of(edge));
    const PackPair term = two_difference(first.high, second.high);
    const PackPair high = two_sum(normal.high, term.high);
    const PackPair low = two_sum(normal.low, high.low + (term.low + (first.low - second.low)));
    normal = {high.high, low.high};
    remainders = remainders + magnitude(low.low);
    magnitudes = magnitudes + (magnitude(first.high) + magnitude(second.high)) + magnitude(high.high);

    const PackPair partial = two_sum(sum.high, p.high);
    sum = {partial.high, sum.low + (partial.low + p.low)};
  }
  // At most 2^27 terms were added to these sums: rounding made them smaller by less than 2^-20.
  const Pack error = all_lanes(1 + 0x1p-20) * (remainders + all_lanes(0x1p-101) * magnitudes);
  const PackPair rounded_normal = two_sum(normal.high, normal.low), rounded_sum = two_sum(sum.high, sum.low);

  NewellSums result;
  double high[kLanes], low[kLanes], errors[kLanes];
  const auto keep = [&](const PackPair& lanes, DoubleDouble(&kept)[3]) {
    store(high, lanes.high);
    store(low, lanes.low);
    for (int axis = 0; axis < 3; ++axis) kept[axis] = {high[axis], low[axis]};
  };
  keep(rounded_normal, result.normal);
  keep(rounded_sum, result.vertices);
  store(errors, error);
  for (int axis = 0; axis < 3; ++axis) result.error[axis] = errors[axis];
  return result;
}

}  // namespace TOUCHSTONE_TARGET

/// The supporting plane of a polygon in double-doubles, without integers of any size.
struct NewellPlane {
  /// The most by which `normal` may differ from the exact one, in units of its largest component.
  static constexpr double kError = 0x1p-60;

  Vector3<DoubleDouble> normal;  ///< the Newell normal of the outer loop, each component to kError of the largest one
  Vector3<DoubleDouble> mean;    ///< the mean of the outer loop's vertices, from vertex 0
  int dropped_axis;              ///< as in the contract: the first axis with the largest component of the normal
  /// Whether `normal` and `dropped_axis` are as described, and the normal is larger than kSmallest. If not, exact
  /// arithmetic must tell.
  bool certain;

  /// The plane of a loop with these sums. Requires round to nearest.
  NewellPlane(const NewellSums& sums, std::span<const ScaledVertex> loop);

  /// The smallest largest component of a normal in a frame: squares of it and of smaller ones do not underflow.
  static constexpr double kSmallest = 0x1p-400;
  /// Takes a normal that was rounded from exact numbers. Then the plane is certain, unless the normal is too small.
  void take_exact(const Vector3<DoubleDouble>& rounded_normal, int exact_dropped_axis);
};

/// Returns the axis of the largest component of a loop's Newell normal, the lowest on a tie, decided in integers of
/// fixed width; nothing if a coordinate from vertex 0 is not a multiple of 2^-127.
///
/// Requires at most EdgeTree::kMostEdges vertices, within 1/4 of vertex 0 in each coordinate, and round to nearest.
/// Cost: linear; 10 ns per vertex if all coordinates from vertex 0 are multiples of 2^-63, else 0.2 us.
[[nodiscard]] std::optional<int> exact_dropped_axis(std::span<const ScaledVertex> loop);

}  // namespace touchstone::filtered::detail
