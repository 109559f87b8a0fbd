// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/comparison.h"

#include <algorithm>
#include <cmath>

namespace touchstone::cases {
namespace {

using Edges = std::vector<std::size_t>;

template <class Value>
bool same(const Value& a, const Value& b) {
  return a == b;
}
bool same(double a, double b) { return same_number(a, b) || (!std::isfinite(a) && !std::isfinite(b)); }
bool same(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}

/// Returns whether the answer has the expected value of a key that both have.
bool meets(const std::string& name, const StatedAnswer& expected, const StatedAnswer& answer) {
  const auto key = find_key(name);
  if (key && has(expected.values, *key) && has(answer.values, *key))
    return same_value(*key, expected.values, answer.values);
  return expected.texts.at(name) == answer.texts.at(name);
}

Outcome compare_yes(bool answer, bool truth) {
  if (answer == truth) return Outcome::Right;
  return answer ? Outcome::WronglyIn : Outcome::WronglyOut;
}

Outcome compare_feet(PointLocation answer, PointLocation truth, bool knows_boundary) {
  if (answer == truth || (truth == PointLocation::Boundary && !knows_boundary)) return Outcome::Right;
  const Outcome closed = compare_yes(answer != PointLocation::Outside, truth != PointLocation::Outside);
  return closed == Outcome::Right ? Outcome::BoundaryMissed : closed;
}

Outcome compare_relations(Relation answer, Relation truth) {
  if (answer == truth) return Outcome::Right;
  const Outcome contact = compare_yes(answer != Relation::Separate, truth != Relation::Separate);
  return contact == Outcome::Right ? Outcome::BoundaryMissed : contact;
}

/// Compares lists of edges, both ascending.
Outcome compare_edges(const Edges& answer, const Edges& truth) {
  if (answer == truth) return Outcome::Right;
  const bool none_too_many = std::includes(truth.begin(), truth.end(), answer.begin(), answer.end());
  return none_too_many ? Outcome::WronglyOut : Outcome::WronglyIn;
}

}  // namespace

bool same_value(const Key& key, const PartialAnswer& a, const PartialAnswer& b) {
  if (!has(a, key) || !has(b, key)) return has(a, key) == has(b, key);
  return key.visit([&](auto member) { return same(*(a.*member), *(b.*member)); });
}

std::vector<Key> differing_keys(const PartialAnswer& a, const PartialAnswer& b) {
  std::vector<Key> keys;
  for (const Key& key : kKeys)
    if (has(a, key) && has(b, key) && !same_value(key, a, b)) keys.push_back(key);
  return keys;
}

std::string to_string(const Difference& difference) {
  const auto& [key, expected, found] = difference;
  return key + ": expected " + expected + (found ? ", found " + *found : ", not given");
}

std::vector<Difference> differences(const StatedAnswer& expected, const StatedAnswer& answer) {
  std::vector<Difference> found;
  for (const auto& [name, text] : expected.texts) {
    const auto given = answer.texts.find(name);
    if (name == "error" && text == "true" && given != answer.texts.end()) continue;
    if (given == answer.texts.end())
      found.push_back({name, text, std::nullopt});
    else if (!meets(name, expected, answer))
      found.push_back({name, text, given->second});
  }
  return found;
}

std::vector<Difference> differences(const StatedAnswer& expected, const PartialAnswer& answer) {
  return differences(expected, stated(answer));
}

std::string_view to_string(Test test) {
  switch (test) {
    case Test::Plane: return "plane";
    case Test::Foot: return "foot";
    case Test::Edges: return "edges";
    case Test::Contact: return "contact";
    case Test::Relation: return "relation";
  }
  return "";
}

Key key_of(Test test) {
  switch (test) {
    case Test::Plane: return key_of(&PartialAnswer::plane);
    case Test::Foot: return key_of(&PartialAnswer::foot);
    case Test::Edges: return key_of(&PartialAnswer::edges_hit);
    case Test::Relation: return key_of(&PartialAnswer::relation);
    case Test::Contact: break;
  }
  return key_of(&PartialAnswer::contact);
}

QueryKind query_kind(Test test) {
  switch (test) {
    case Test::Plane: return QueryKind::PlaneSide;
    case Test::Foot: return QueryKind::Foot;
    case Test::Edges: return QueryKind::EdgesHit;
    case Test::Relation: return QueryKind::Relation;
    case Test::Contact: break;
  }
  return QueryKind::Contact;
}

std::optional<Outcome> compare(Test test, const PartialAnswer& answer, const PartialAnswer& truth,
                               bool knows_boundary) {
  switch (test) {
    case Test::Plane:
      if (!answer.plane) break;
      return compare_yes(*answer.plane == PlaneSide::Intersects, *truth.plane == PlaneSide::Intersects);
    case Test::Foot:
      if (!answer.foot) break;
      return compare_feet(*answer.foot, *truth.foot, knows_boundary);
    case Test::Edges:
      if (!answer.edges_hit) break;
      return compare_edges(*answer.edges_hit, *truth.edges_hit);
    case Test::Contact:
      if (!answer.contact) break;
      return compare_yes(*answer.contact, *truth.contact);
    case Test::Relation:
      if (!answer.relation) break;
      return compare_relations(*answer.relation, *truth.relation);
  }
  return std::nullopt;
}

bool knows_boundary(const Method& method) {
  const Polygon square({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  return method.prepare(square)->ask({{1, 0, 0}, 1}, QueryKind::Foot).foot == PointLocation::Boundary;
}

bool lifts_vertices(const Method& method) {
  const Polygon square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0x1p-50}, {0, 1, 0}});  // the corner at zero is lifted by -2^-52
  const auto prepared = method.prepare(square);
  constexpr double kOut = 0x1p-39;
  const double radius = kOut * std::sqrt(3.0);
  const auto contact_at = [&](double height, double share) {
    return prepared->ask({{-kOut, -kOut, height}, radius * share}, QueryKind::Contact).contact;
  };
  // Below, only the lifted corner is within this radius; above, only the one as given.
  return contact_at(-kOut, 1 - 0x1p-16).value_or(true) && !contact_at(kOut, 1 + 0x1p-16).value_or(false);
}

}  // namespace touchstone::cases
