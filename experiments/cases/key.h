// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/cases/method.h"
#include "geometry/shapes/rejection.h"

// The keys of answers. Names, comparison, reading and writing of JSON follow from one table, `kKeys`, and from the
// types of the members of PartialAnswer.
namespace touchstone::cases {

/// The member of PartialAnswer that holds a key.
template <class Value>
using Member = std::optional<Value> PartialAnswer::*;
using AnyMember = std::variant<Member<PlaneSide>, Member<bool>, Member<PointLocation>, Member<std::vector<std::size_t>>,
                               Member<Relation>, Member<FirstContactKind>, Member<std::size_t>, Member<double>,
                               Member<Feature>, Member<Eigen::Vector3d>>;

/// A key of answers.
struct Key {
  std::string_view name;  ///< as JSON has it
  AnyMember member;

  /// Returns whether its numbers denote their nearest doubles; numbers of other keys are indices.
  [[nodiscard]] constexpr bool holds_doubles() const {
    return std::holds_alternative<Member<double>>(member) || std::holds_alternative<Member<Eigen::Vector3d>>(member);
  }
  /// Calls `visit` with the member.
  template <class Visit>
  decltype(auto) visit(const Visit& visit) const {
    return std::visit(visit, member);
  }
  friend constexpr bool operator==(const Key& a, const Key& b) { return a.member == b.member; }
};

/// All keys, in the order in which verdicts have them.
inline constexpr std::array kKeys{
    Key{"plane", &PartialAnswer::plane},       Key{"plane_tangent", &PartialAnswer::plane_tangent},
    Key{"foot", &PartialAnswer::foot},         Key{"edges_hit", &PartialAnswer::edges_hit},
    Key{"touched", &PartialAnswer::touched},   Key{"relation", &PartialAnswer::relation},
    Key{"contact", &PartialAnswer::contact},   Key{"first", &PartialAnswer::first},
    Key{"time", &PartialAnswer::time},         Key{"momentary", &PartialAnswer::momentary},
    Key{"face", &PartialAnswer::face},         Key{"feature", &PartialAnswer::feature},
    Key{"nearest", &PartialAnswer::nearest},   Key{"point", &PartialAnswer::point},
    Key{"distance", &PartialAnswer::distance}, Key{"contact_normal", &PartialAnswer::contact_normal},
    Key{"depth", &PartialAnswer::depth},       Key{"off_plane", &PartialAnswer::off_plane}};

/// Returns the key that a member holds.
template <class Value>
[[nodiscard]] constexpr Key key_of(Member<Value> member) {
  return *std::ranges::find(kKeys, AnyMember(member), &Key::member);
}
/// Returns the key of that name, if there is one.
[[nodiscard]] constexpr std::optional<Key> find_key(std::string_view name) {
  const auto found = std::ranges::find(kKeys, name, &Key::name);
  return found == kKeys.end() ? std::nullopt : std::optional(*found);
}

[[nodiscard]] inline bool has(const PartialAnswer& answer, const Key& key) {
  return key.visit([&](auto member) { return (answer.*member).has_value(); });
}
/// Returns whether the key is absent because the contract calls it `null`, given `first`: there is no contact, or, for
/// `momentary`, the first contact is not on the way.
[[nodiscard]] bool is_null(const PartialAnswer& answer, const Key& key);
/// Returns an answer with only these keys of `answer`.
[[nodiscard]] PartialAnswer only(const PartialAnswer& answer, const std::vector<Key>& keys);

/// An answer or a rejection as a line of JSON states it: the expectation of a case, or a verdict.
struct StatedAnswer {
  PartialAnswer values;  ///< the keys whose value has the form of the contract; null stands for an infinite number
  /// Every stated key of an answer, and `error` and `message`: its value as JSON, with numbers in the shortest form
  /// that reads back as the same double. A value of the contract's form is written as verdicts write it.
  std::map<std::string, std::string> texts;

  [[nodiscard]] bool rejects() const { return texts.contains("error"); }
};

/// Returns the statement of a method. Numbers beyond the finite doubles become null, -0 becomes 0.
[[nodiscard]] StatedAnswer stated(const PartialAnswer& answer);
[[nodiscard]] StatedAnswer stated(const Rejection& rejection);

}  // namespace touchstone::cases
