// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cell/kinematics/rehearsal.h"

/// Where the storage may stand: rehearsals of the way from home by the storage to the machine, one a place.
namespace touchstone::thesis_figures {

/// What comes out with the storage at a place.
enum class Outcome {
  FromSide,   ///< it completes, the material touched from the side
  FromAbove,  ///< it completes, the material touched from above
  OutOfReach,
  JointLimit,
  InTheWay,   ///< the sphere touches something on a move that should be free
  Nothing,    ///< the sphere touches nothing where it should, or steps pass over it, or nothing lifts it clear
};
[[nodiscard]] std::string_view word(Outcome outcome);
[[nodiscard]] constexpr bool completes(Outcome outcome) {
  return outcome == Outcome::FromSide || outcome == Outcome::FromAbove;
}
/// By the moves, or by what the last way that was tried failed of.
[[nodiscard]] Outcome outcome_of(const kinematics::Rehearsal& rehearsal);

/// A storage somewhere.
struct Place {
  double angle, radius, height;
  Outcome outcome;
  std::string failure;  ///< as the rehearsal has it
};
[[nodiscard]] Place try_place(const kinematics::Layout& layout, double angle, double radius, double height);

/// An unbroken run of places that complete.
struct Run {
  std::size_t first, last;  ///< among the places
};
/// The longest, the first of equal ones; nothing completes: first > last.
[[nodiscard]] Run longest_run(const std::vector<Place>& places);

}  // namespace touchstone::thesis_figures
