// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/studies/recorded/pile.h"

namespace touchstone::recorded {

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
