// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/comparison.h"

#include <algorithm>
#include <vector>

namespace touchstone::cases {
namespace {

using Edges = std::vector<std::size_t>;

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

std::string_view word(Test test) {
  switch (test) {
    case Test::Plane: return "plane";
    case Test::Foot: return "foot";
    case Test::Edges: return "edges";
    case Test::Contact: return "contact";
    case Test::Relation: return "relation";
  }
  return "";
}

cases::QueryKind query_kind(Test test) {
  switch (test) {
    case Test::Plane: return cases::QueryKind::PlaneSide;
    case Test::Foot: return cases::QueryKind::Foot;
    case Test::Edges: return cases::QueryKind::EdgesHit;
    case Test::Relation: return cases::QueryKind::Relation;
    case Test::Contact: break;
  }
  return cases::QueryKind::Contact;
}

std::optional<Outcome> compare(Test test, const cases::PartialAnswer& answer, const cases::PartialAnswer& truth,
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

bool knows_boundary(const cases::Method& method) {
  const Polygon square({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  return method.prepare(square)->ask({{1, 0, 0}, 1}, cases::QueryKind::Foot).foot == PointLocation::Boundary;
}

}  // namespace touchstone::cases
