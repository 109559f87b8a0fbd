// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "robust/detail/exact_kernel.h"
#include "robust/exact/exact.h"

namespace touchstone::exact {

/// A polygon lifted onto its supporting plane.
///
/// The lift divides by n N_k (n vertices in the outer loop, k the dropped axis). To avoid divisions, all lengths are
/// multiplied by |n N_k|; if all loops lie on the plane, the factor is 1.
struct PreparedPolygon::Lifted {
  detail::Vector normal;
  detail::Number normal_squared;
  int dropped_axis;
  detail::Number scale;                  ///< > 0: what all lengths below are multiplied by
  std::vector<detail::Vector> vertices;  ///< lifted
  std::vector<std::size_t> next;
  double off_plane;

  /// Throws Rejected with `zero-normal` if there is no supporting plane.
  explicit Lifted(const Polygon& polygon);
  /// A degenerate triangle has the normal 0.
  explicit Lifted(const Triangle& triangle);
};

/// Returns what the polygon holds.
const PreparedPolygon::Lifted& lifted(const PreparedPolygon& polygon);

namespace detail {

using Lifted = PreparedPolygon::Lifted;

/// Locates a point of the supporting plane by counting the edges that a ray from it crosses, in the projection without
/// the dropped coordinate. `signs` reports, for each edge and its start:
///   above(i): the sign of the start's coordinate v minus the point's, v = (dropped axis + 2) mod 3;
///   side(i): +, 0, -: the point lies left of the edge's line, on it, or right of it, as seen from the front;
///   covers(i): whether a point on the edge's line lies on the edge.
template <class Signs>
PointLocation locate(const Lifted& polygon, const Signs& signs) {
  std::vector<kernel::Sign> above(polygon.vertices.size());
  for (std::size_t i = 0; i < above.size(); ++i) above[i] = signs.above(i);

  bool inside = false;
  for (std::size_t i = 0; i < above.size(); ++i) {
    const kernel::Sign start = above[i], end = above[polygon.next[i]];
    if (start * end == kernel::POSITIVE) continue;
    const kernel::Sign side = signs.side(i);
    if (side == kernel::ZERO) {
      if (signs.covers(i)) return PointLocation::Boundary;
      continue;
    }
    const bool upwards = start != kernel::POSITIVE && end == kernel::POSITIVE;
    const bool downwards = start == kernel::POSITIVE && end != kernel::POSITIVE;
    if ((upwards && side == kernel::POSITIVE) || (downwards && side == kernel::NEGATIVE)) inside = !inside;
  }
  return inside ? PointLocation::Inside : PointLocation::Outside;
}

/// Members of Answer.
struct Touched {
  Feature nearest;
  Eigen::Vector3d point, contact_normal;
  double depth;
};

/// Returns what the ball touches; nothing if it is separate. Requires the floating-point state of FloatingPointState.
[[nodiscard]] std::optional<Touched> touched(const Ball& ball, const PreparedPolygon& polygon);

}  // namespace detail
}  // namespace touchstone::exact
