// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/contact/answer.h"
#include "tests/robust/support/generators.h"
#include "tests/robust/support/moving.h"

namespace touchstone::contact_tests {

/// A case in small integers with its whole answer, derived by hand.
struct HandCase {
  Case given;  ///< its id says what is special
  Answer expected;
};

/// In a plane z = 0: nothing that decides is rounded in doubles. A right triangle, an L, a U, a square with a hole and
/// an island in it, a hole with a vertex that points inwards.
[[nodiscard]] const std::vector<HandCase>& hand_cases();

/// Off their planes, onto which they are lifted by doubles.
[[nodiscard]] const std::vector<HandCase>& lifted_cases();

/// The same with the coordinates turned: x to y, y to z, z to x, `times` times. Front and back stay.
[[nodiscard]] HandCase turned(HandCase original, int times);

/// A first contact in small integers, derived by hand.
struct MovingHandCase {
  MovingCase given;  ///< its id says what is special
  FirstContact expected;
};
[[nodiscard]] const std::vector<MovingHandCase>& moving_hand_cases();

}  // namespace touchstone::contact_tests
