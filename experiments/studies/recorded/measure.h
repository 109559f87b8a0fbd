// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
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

/// A build of Bullet that steps piles.
struct Simulation {
  std::string_view name;  ///< of the engine as a method
  std::string program;    ///< its path
};

/// Returns the builds that this program was built with, doubles before floats.
[[nodiscard]] const std::vector<Simulation>& simulations();

/// A question that Bullet's narrow phase asked, and the answer that it got.
struct Question {
  std::size_t triangle;
  Ball ball;
  double within_radius;  ///< the radius with the contact breaking threshold, as Bullet adds them
  bool within, contact;  ///< whether it found the triangle within that radius, and whether at a depth of at least 0
};

/// Steps a pile by 1/60 s so often, and returns every question about a ball and a triangle, in Bullet's order. The same
/// build of Bullet gives the same questions. Throws std::runtime_error, which says what happened, if the program fails.
[[nodiscard]] std::vector<Question> record(const Simulation& simulation, const Pile& pile, std::size_t steps);

}  // namespace touchstone::recorded
