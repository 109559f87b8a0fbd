// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "robust/filtered/filtered.h"

namespace touchstone::tunnelling {

/// Ways are as long as the polygon's extent and are walked in 2^k equal steps, k = 0, ..., kMostLevel: at 2^k + 1
/// places.
inline constexpr std::size_t kMostLevel = 10;

/// The radii of the balls, as shares of the extent: 0, then 2^-12, 2^-10, ..., 2^-2.
inline constexpr std::array kRadii{0.0, 0x1p-12, 0x1p-10, 0x1p-8, 0x1p-6, 0x1p-4, 0x1p-2};

/// A rotated polygon and a straight way past or through it, as long as its extent except for rounding.
struct Pass {
  Polygon polygon;
  Eigen::Vector3d from, to;
  double extent;

  /// Returns the motion of the ball whose radius is this share of the extent.
  [[nodiscard]] Motion of(double radius) const { return {{from, radius * extent}, to}; }
};

/// Draws pass n: a function of its arguments. The polygon is of the family n mod 10; the way goes through a random
/// point of the box around the polygon, in any direction. Returns nothing if there is no such polygon.
[[nodiscard]] std::optional<Pass> draw_pass(std::size_t vertices, std::uint64_t seed, std::uint64_t n);

/// Returns the place of the ball after i of 2^level steps: its centre is rounded to doubles, as a simulation would.
[[nodiscard]] Ball place_of(const Motion& motion, std::size_t level, std::size_t i);

/// Returns whether the ball touches at one of the places of 2^level steps; asks until one touches.
[[nodiscard]] bool touches_at_steps(const Motion& motion, std::size_t level, const filtered::PreparedPolygon& polygon);

/// Returns the least level whose steps find a contact, or nothing if none up to kMostLevel does.
[[nodiscard]] std::optional<std::size_t> first_level_that_touches(const Motion& motion,
                                                                  const filtered::PreparedPolygon& polygon);

}  // namespace touchstone::tunnelling
