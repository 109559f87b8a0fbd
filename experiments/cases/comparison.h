// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "experiments/cases/method.h"

namespace touchstone::cases {

/// The parts of an answer that studies compare: the contract's three tests, contact, and the relation.
enum class Test { Plane, Foot, Edges, Contact, Relation };
/// The tests that every study counts.
inline constexpr std::array kTests{Test::Plane, Test::Foot, Test::Edges, Test::Contact};

[[nodiscard]] std::string_view word(Test test);
/// Returns the query that yields the key of the test.
[[nodiscard]] cases::QueryKind query_kind(Test test);

/// An answer compared with the truth. `In` is the larger answer: plane intersected, foot not outside, edge hit,
/// contact.
enum class Outcome {
  Right,
  WronglyIn,
  WronglyOut,
  BoundaryMissed,  ///< foot: confuses inside and boundary; relation: confuses touching and overlapping
};

/// Compares an answer with the truth, for all studies. Returns nothing if the method did not answer that test.
///  - Plane: intersects or not. In front and behind count alike, because the normal of the thesis, from the first three
///    vertices, swaps them.
///  - Foot: all three words, if the method distinguishes the boundary. Otherwise, on a boundary both inside and outside
///    are right.
///  - Edges: the whole list. WronglyIn if the answer lists an edge that is not hit, else WronglyOut.
///  - Contact: yes or no.
///  - Relation: all three words.
[[nodiscard]] std::optional<Outcome> compare(Test test, const cases::PartialAnswer& answer,
                                             const cases::PartialAnswer& truth, bool knows_boundary);

/// Returns whether the method reports the boundary in the simplest case: in the plane of a square, at the midpoint of
/// an edge.
[[nodiscard]] bool knows_boundary(const cases::Method& method);

}  // namespace touchstone::cases
