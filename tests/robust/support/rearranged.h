// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "geometry/contact/answer.h"
#include "geometry/shapes/triangle.h"
#include "tests/robust/support/generators.h"

namespace touchstone::contact_tests {

/// The outer loop, then the holes.
[[nodiscard]] std::vector<Loop> loops_of(const Polygon& polygon);
[[nodiscard]] Polygon polygon_of(const std::vector<Loop>& loops);
[[nodiscard]] Polygon polygon_of(const Triangle& triangle);
/// The first three vertices.
[[nodiscard]] Triangle triangle_of(const Polygon& polygon);
/// The largest difference between two vertices in one coordinate, from below: measured from vertex 0.
[[nodiscard]] double extent(const Polygon& polygon);

using PointMap = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;
/// The mirror image in a coordinate plane.
[[nodiscard]] PointMap mirror_along(int axis);
[[nodiscard]] Polygon moved(const Polygon& polygon, const PointMap& map);
/// The ball's centre moves too; its radius stays.
[[nodiscard]] Case moved(const Case& original, const PointMap& map);

/// Times 2^exponent, the radius too.
[[nodiscard]] Case scaled(const Case& original, int exponent);
/// Is every number of the scaled case finite, and exactly that multiple?
[[nodiscard]] bool scales_exactly(const Case& original, int exponent);
/// The same answer with its lengths times 2^exponent.
[[nodiscard]] Answer scaled(Answer answer, int exponent);

/// The numbers of a polygon's vertices, loop by loop.
using Order = std::vector<std::vector<std::size_t>>;
[[nodiscard]] Order order_of(const Polygon& polygon);

/// The same polygon with its vertices told in another order.
struct Reordered {
  Reordered(const Polygon& original, const Order& order);

  Polygon polygon;
  std::vector<std::size_t> old_vertex;  ///< number in the original polygon
  std::vector<std::size_t> old_edge;

  /// The answer in the numbers of the original polygon, hit edges ascending.
  [[nodiscard]] Answer in_old_numbers(Answer answer) const;
  /// The place of an edge or vertex of the original polygon in this one.
  [[nodiscard]] std::size_t place(Feature original) const;
};

/// Starts the outer loop at each of its vertices in turn; the holes, and the order of the holes, turn along.
/// `reverse(l)` says whether loop l is told backwards.
[[nodiscard]] std::vector<Reordered> all_starts(const Polygon& polygon,
                                                const std::function<bool(std::size_t)>& reverse);

}  // namespace touchstone::contact_tests
