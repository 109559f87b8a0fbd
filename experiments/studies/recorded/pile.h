// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::recorded {

/// Balls above uneven ground, before the first step. Every number is a float, so that both of Bullet's builds hold the
/// same pile.
struct Pile {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<Ball> balls;

  [[nodiscard]] Triangle triangle(std::size_t i) const {
    const auto& [a, b, c] = triangles[i];
    return {vertices[a], vertices[b], vertices[c]};
  }
};

/// Draws pile number `index`: a bowl of triangles with sides of about 1, rough by up to half of that, and balls of
/// radius 1/4 to 5/8 that fall into it. A function of (seed, index, balls) alone.
[[nodiscard]] Pile draw_pile(std::uint64_t seed, std::uint64_t index, std::size_t balls);

}  // namespace touchstone::recorded
