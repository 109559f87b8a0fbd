// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "experiments/cases/method.h"

namespace touchstone::cases {

/// What is compared: the contract's three tests, each by itself, and the final answer, with or without touching.
enum class Test { Plane, Foot, Edges, Contact, Relation };
/// Those that every study counts.
inline constexpr std::array kTests{Test::Plane, Test::Foot, Test::Edges, Test::Contact};

[[nodiscard]] std::string_view word(Test test);
[[nodiscard]] cases::Question question(Test test);

/// An answer beside the truth. `In` is the larger answer: the plane intersected, the foot not outside, an edge hit, a
/// contact.
enum class Outcome {
  Right,
  WronglyIn,
  WronglyOut,
  BoundaryMissed,  ///< foot: inside and boundary confused; relation: touching and overlapping
};

/// The one place where the studies compare answers. Nothing where the method has not answered that test.
///  - Plane: intersects or not. In front and behind count alike, since the thesis's normal, from the first three
///    vertices, swaps them.
///  - Foot: all three words, if the method knows them; a method without the word boundary is right on a boundary
///    whether it says inside or outside.
///  - Edges: the whole list. WronglyIn where an edge is listed that is not hit, else WronglyOut.
///  - Contact: yes or no.
///  - Relation: all three words.
[[nodiscard]] std::optional<Outcome> compare(Test test, const cases::PartialAnswer& answer,
                                             const cases::PartialAnswer& truth, bool knows_boundary);

/// Does the method say boundary in the plainest case: in the plane of a square, at the middle of an edge?
[[nodiscard]] bool knows_boundary(const cases::Method& method);

}  // namespace touchstone::cases
