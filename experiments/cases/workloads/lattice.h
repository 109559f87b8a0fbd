// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace touchstone::workloads {

/// The bound of |x| and |y| in outlines: products of differences, and sums of thousands of such products, fit in 64
/// bits.
inline constexpr std::int64_t kLatticeRadius = std::int64_t{1} << 20;

/// A point, or the difference of two, in the plane of the integers.
struct LatticePoint {
  std::int64_t x, y;

  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
  friend LatticePoint operator+(LatticePoint a, LatticePoint b) { return {a.x + b.x, a.y + b.y}; }
  friend LatticePoint operator-(LatticePoint a, LatticePoint b) { return {a.x - b.x, a.y - b.y}; }
};

[[nodiscard]] inline std::int64_t cross(LatticePoint a, LatticePoint b) { return a.x * b.y - a.y * b.x; }
[[nodiscard]] inline std::int64_t dot(LatticePoint a, LatticePoint b) { return a.x * b.x + a.y * b.y; }

/// The vertices of a closed loop in order; an edge joins the last to the first.
using LatticeLoop = std::vector<LatticePoint>;

/// An outer loop with disjoint holes strictly inside it; no hole lies inside another.
struct Outline {
  LatticeLoop outer;
  std::vector<LatticeLoop> holes;
};

struct LatticeBox {
  LatticePoint low, high;

  /// The longer side.
  [[nodiscard]] std::int64_t size() const;
};

/// A vertex with its neighbours.
struct Corner {
  LatticePoint previous, here, next;
  bool region_on_left;  ///< of the edge from `here` to `next`

  /// Returns whether the interior angle of the region is less than 180 degrees here.
  [[nodiscard]] bool convex() const;
};

[[nodiscard]] LatticeBox bounding_box(const LatticeLoop& loop);
/// Returns twice the signed area; positive for a counterclockwise loop.
[[nodiscard]] std::int64_t twice_area(const LatticeLoop& loop);
/// Returns whether a simple loop bounds a convex region; straight runs are allowed.
[[nodiscard]] bool is_convex(const LatticeLoop& loop);

[[nodiscard]] std::size_t vertex_count(const Outline& outline);
/// Returns vertex `i` of the outline; the vertices of the outer loop precede those of the holes.
[[nodiscard]] Corner corner(const Outline& outline, std::size_t i);
/// Returns whether the point lies inside the outer loop and outside the holes (even-odd rule). A point of an edge may
/// count as either.
[[nodiscard]] bool contains(const Outline& outline, LatticePoint point);
/// Returns the distance from a point to the nearest edge, in doubles.
[[nodiscard]] double clearance(const Outline& outline, LatticePoint point);

}  // namespace touchstone::workloads
