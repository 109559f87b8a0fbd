// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/shapes/polygon.h"

namespace touchstone::exact::detail {

/// @{
/// Returns whether the point p lies to the left of (1), on (0) or to the right of (-1) the directed line from a to b;
/// whether a plane holds all four points. Exact for finite doubles. Requires round to nearest, without flush-to-zero.
[[nodiscard]] int orientation(double ax, double ay, double bx, double by, double px, double py);
[[nodiscard]] bool coplanar(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                            const Eigen::Vector3d& d);
/// @}

/// Returns the axis of the largest component of the outer loop's Newell normal, the lowest on a tie, decided exactly;
/// nothing if the normal is zero. Cost: linear.
[[nodiscard]] std::optional<int> dropped_axis(const Polygon& polygon);

/// The loops of a polygon, projected by dropping one coordinate.
class PlanarLoops {
 public:
  struct Point {
    double x, y;
    friend auto operator<=>(const Point&, const Point&) = default;  // by x, then by y  NOLINT(modernize-use-nullptr)
    friend bool operator==(const Point&, const Point&) = default;
  };

  PlanarLoops(const Polygon& polygon, int dropped_axis);

  [[nodiscard]] const Point& operator[](std::size_t i) const { return points_[i]; }
  [[nodiscard]] std::size_t next(std::size_t i) const { return polygon_->next(i); }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return polygon_->previous(i); }

 private:
  const Polygon* polygon_;
  std::vector<Point> points_;
};

/// Two edges of loops that would cross even if the loops were moved by a little.
struct Meeting {
  enum class Kind {
    Point,     ///< the ends of an edge coincide; `first` and `second` are that edge
    Crossing,  ///< two edges cross, or two loops cross where a vertex of one is a point of the other
    Overlap    ///< two edges share more than a point
  } kind;
  std::size_t first, second;  // first <= second
};

/// Returns a meeting among the edges [begin, end) of whole loops, if there is one. Loops that touch in a vertex without
/// crossing there do not meet. Exact. Cost: O(n log n) with n = end - begin.
///
/// A line sweeps over the points in lexicographic order and keeps the edges that it crosses in order. The first edges
/// that cross between vertices are neighbours in that order before (Shamos and Hoey). At each vertex, the directions of
/// all edges that run through that point tell whether loops cross or overlap there. Source: [shamos1976].
[[nodiscard]] std::optional<Meeting> find_meeting(const PlanarLoops& loops, std::size_t begin, std::size_t end);

/// Returns whether an edge, near its start, is inside the loops with edges [begin, end), by the even-odd rule. Requires
/// that it overlaps none of these edges. Exact. Cost: linear.
[[nodiscard]] bool begins_inside(const PlanarLoops& loops, std::size_t edge, std::size_t begin, std::size_t end);

}  // namespace touchstone::exact::detail
