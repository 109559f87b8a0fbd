// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/cases/key.h"
#include "experiments/cases/method.h"

// All comparisons of answers: key by key, as the contract defines them, and test by test, as the studies count them.
namespace touchstone::cases {

/// Returns whether two answers have the same value for a key, or both lack it. Numbers are compared by value, as JSON
/// has them: 0 = -0, and all numbers that are not finite are null.
[[nodiscard]] bool same_value(const Key& key, const PartialAnswer& a, const PartialAnswer& b);
/// Returns the keys that both answers have, with different values, in the order of the contract.
[[nodiscard]] std::vector<Key> differing_keys(const PartialAnswer& a, const PartialAnswer& b);

/// An expectation that an answer does not meet; the values are JSON.
struct Difference {
  std::string key, expected;
  std::optional<std::string> found;  ///< nothing if the answer lacks the key

  auto members() { return std::tie(key, expected, found); }
};
/// Returns it as a sentence: `relation: expected "touching", found "separate"`.
[[nodiscard]] std::string to_string(const Difference& difference);

/// Returns the expectations that an answer does not meet, in the order of the names of the keys. A key that the answer
/// lacks is not met; values are compared by `same_value`. A value that does not have the form of the contract meets
/// only an expectation with the same text.
[[nodiscard]] std::vector<Difference> differences(const StatedAnswer& expected, const StatedAnswer& answer);
[[nodiscard]] std::vector<Difference> differences(const StatedAnswer& expected, const PartialAnswer& answer);

/// The parts of an answer that studies compare: the contract's three tests, contact, and the relation.
enum class Test { Plane, Foot, Edges, Contact, Relation };
/// The tests that every study counts.
inline constexpr std::array kTests{Test::Plane, Test::Foot, Test::Edges, Test::Contact};

[[nodiscard]] std::string_view to_string(Test test);
/// Returns the key that the test compares.
[[nodiscard]] Key key_of(Test test);
/// Returns the query that yields the key of the test.
[[nodiscard]] QueryKind query_kind(Test test);

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
[[nodiscard]] std::optional<Outcome> compare(Test test, const PartialAnswer& answer, const PartialAnswer& truth,
                                             bool knows_boundary);

/// Returns whether the method reports the boundary in the simplest case: in the plane of a square, at the midpoint of
/// an edge.
[[nodiscard]] bool knows_boundary(const Method& method);

/// Returns whether the method lifts vertices onto the plane as the contract does, also by as little as rounding leaves
/// those of rotated loops off it. Asks it about balls off a corner of a square with one vertex 2^-50 off its plane, above
/// and below, for which a relative error of 2^-17 is harmless.
[[nodiscard]] bool lifts_vertices(const Method& method);

}  // namespace touchstone::cases
