// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/shapes/polygon.h"

namespace touchstone::exact {

/// The loops of a polygon with one coordinate left out.
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

/// Two edges that share a point which is not just the vertex where they follow each other; the same edge twice if its
/// ends coincide.
struct Meeting {
  std::size_t first, second;  // first <= second
};

/// A meeting among the edges [begin, end) of whole loops, if there is any. Exact; O(n log n) with n = end - begin.
///
/// A line sweeps the points in lexicographic order and keeps the edges that it crosses in order; as long as no
/// neighbours in that order meet, no edges meet (Shamos and Hoey). Source: [shamos1976].
[[nodiscard]] std::optional<Meeting> find_meeting(const PlanarLoops& loops, std::size_t begin, std::size_t end);

/// Is a vertex, on none of the edges [begin, end) of whole loops, inside them (even-odd)? Exact, linear.
[[nodiscard]] bool is_inside(const PlanarLoops& loops, std::size_t vertex, std::size_t begin, std::size_t end);

}  // namespace touchstone::exact
