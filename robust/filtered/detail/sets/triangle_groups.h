// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes/triangle.h"
#include "robust/filtered/triangle_set.h"

namespace touchstone::filtered {
namespace detail {

/// Eight triangles of a set, one per lane.
///
/// Coordinates are relative to the group's origin, in units of the group's radius: no vertex is farther than 1 from the
/// origin. They are stored as the nearest multiple of 1 / kSteps, in 16 bits: queries wait for memory rather than for
/// arithmetic. So the stored triangle differs from the given one by at most bounds::kLaneStored, and so do the
/// distances from the two.
struct TriangleGroup {
  static constexpr std::size_t kWidth = 8;
  static constexpr int kSteps = 32767;
  /// By how much less than 1 the vertices are from the origin, except for roundings.
  static constexpr double kSpare = 0x1p-40;
  /// The limit for the numbers of a scaled ball, below which no product of steps overflows.
  static constexpr double kReach = 0x1p40;
  /// The limit for the numbers of a ball and for origins, below which no difference of the two overflows.
  static constexpr double kLargest = 0x1p1000;

  using Steps = std::int16_t[kWidth];

  alignas(16) Steps vertices[3][3];  ///< by vertex and coordinate; those of missing triangles are 0

  double origin[4];  ///< followed by a 0, so that a ball's radius stays the same
  double scale;      ///< 1 / radius
  double reach;      ///< the limit for differences from the origin, and for radii; negative if nothing is prepared
};

/// Prepares one to eight triangles with finite vertices. Requires round to nearest, without flush-to-zero.
[[nodiscard]] TriangleGroup group_of(std::span<const Triangle> triangles);

}  // namespace detail

struct TriangleSet::Parts {
  Parts(std::span<const Triangle> given, Degenerate degenerate);

  std::vector<detail::TriangleGroup> groups;
  std::vector<Triangle> triangles;
};

/// Returns what was prepared. Requires a set that was not moved from.
[[nodiscard]] inline const TriangleSet::Parts& parts_of(const TriangleSet& set) { return *set.parts_; }

}  // namespace touchstone::filtered
