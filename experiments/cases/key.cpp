// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/key.h"

#include <algorithm>

namespace touchstone::cases {

std::string_view to_string(Key key) {
  switch (key) {
    case Key::Plane: return "plane";
    case Key::PlaneTangent: return "plane_tangent";
    case Key::Foot: return "foot";
    case Key::EdgesHit: return "edges_hit";
    case Key::Relation: return "relation";
    case Key::Contact: return "contact";
    case Key::First: return "first";
    case Key::Time: return "time";
    case Key::Momentary: return "momentary";
    case Key::Feature: return "feature";
    case Key::Nearest: return "nearest";
    case Key::Point: return "point";
    case Key::Distance: return "distance";
    case Key::OffPlane: return "off_plane";
  }
  return "";
}

std::optional<Key> find_key(std::string_view text) {
  const auto found = std::ranges::find(kKeys, text, [](Key key) { return to_string(key); });
  if (found == kKeys.end()) return std::nullopt;
  return *found;
}

bool has(const PartialAnswer& answer, Key key) {
  return visit_key(key, [&](auto member) { return (answer.*member).has_value(); });
}

bool is_null(const PartialAnswer& answer, Key key) {
  if (!answer.first || has(answer, key)) return false;
  if (key == Key::Momentary) return *answer.first != FirstContactKind::Way;
  return *answer.first == FirstContactKind::None && (key == Key::Feature || key == Key::Point);
}

PartialAnswer only(const PartialAnswer& answer, const std::vector<Key>& keys) {
  PartialAnswer some;
  for (const Key key : keys) visit_key(key, [&](auto member) { some.*member = answer.*member; });
  return some;
}

}  // namespace touchstone::cases
