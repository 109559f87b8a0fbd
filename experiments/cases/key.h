// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/cases/method.h"

namespace touchstone::cases {

/// The keys of answers, in the order in which verdicts have them.
enum class Key {
  Plane,
  PlaneTangent,
  Foot,
  EdgesHit,
  Relation,
  Contact,
  First,
  Time,
  Momentary,
  Feature,
  Nearest,
  Point,
  Distance,
  OffPlane
};
inline constexpr std::array kKeys{Key::Plane,   Key::PlaneTangent, Key::Foot,     Key::EdgesHit,  Key::Relation,
                                  Key::Contact, Key::First,        Key::Time,     Key::Momentary, Key::Feature,
                                  Key::Nearest, Key::Point,        Key::Distance, Key::OffPlane};
/// The keys of an answer about a ball at a place, in the order of the contract.
inline constexpr std::array kStaticKeys{Key::Plane,   Key::PlaneTangent, Key::Foot,  Key::EdgesHit, Key::Relation,
                                        Key::Contact, Key::Nearest,      Key::Point, Key::Distance, Key::OffPlane};
/// The keys of an answer about a moving ball, in the order of the contract.
inline constexpr std::array kMovingKeys{Key::Contact, Key::First, Key::Time,    Key::Momentary,
                                        Key::Feature, Key::Point, Key::OffPlane};

/// Returns the key as JSON has it: `plane`, ..., `off_plane`.
[[nodiscard]] std::string_view to_string(Key key);
/// Returns the key of that word, if there is one.
[[nodiscard]] std::optional<Key> find_key(std::string_view word);

/// Calls `visit` with the member of PartialAnswer that holds the key.
template <class Visit>
decltype(auto) visit_key(Key key, const Visit& visit) {
  switch (key) {
    case Key::Plane: return visit(&PartialAnswer::plane);
    case Key::PlaneTangent: return visit(&PartialAnswer::plane_tangent);
    case Key::Foot: return visit(&PartialAnswer::foot);
    case Key::EdgesHit: return visit(&PartialAnswer::edges_hit);
    case Key::Relation: return visit(&PartialAnswer::relation);
    case Key::Contact: return visit(&PartialAnswer::contact);
    case Key::First: return visit(&PartialAnswer::first);
    case Key::Time: return visit(&PartialAnswer::time);
    case Key::Momentary: return visit(&PartialAnswer::momentary);
    case Key::Feature: return visit(&PartialAnswer::feature);
    case Key::Nearest: return visit(&PartialAnswer::nearest);
    case Key::Point: return visit(&PartialAnswer::point);
    case Key::Distance: return visit(&PartialAnswer::distance);
    case Key::OffPlane: break;
  }
  return visit(&PartialAnswer::off_plane);
}

[[nodiscard]] bool has(const PartialAnswer& answer, Key key);
/// Returns whether the key is absent because the contract calls it `null`, given `first`: there is no contact, or, for
/// `momentary`, the first contact is not on the way.
[[nodiscard]] bool is_null(const PartialAnswer& answer, Key key);
/// Returns an answer with only these keys of `answer`.
[[nodiscard]] PartialAnswer only(const PartialAnswer& answer, const std::vector<Key>& keys);

}  // namespace touchstone::cases
