// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust/filtered/filtered.h"

#include "experiments/methods/add_methods.h"
#include "robust/filtered/motion.h"

namespace touchstone::methods {
namespace {

class PreparedFiltered final : public PreparedMethod {
 public:
  explicit PreparedFiltered(const Polygon& polygon) : polygon_(polygon) {}

  PartialAnswer ask(const Ball& ball, QueryKind kind) const override {
    filtered::StageCounts counts;
    PartialAnswer answer;
    switch (kind) {
      case QueryKind::Contact: answer.contact = filtered::contact(ball, polygon_, counts); break;
      case QueryKind::Relation: answer.relation = filtered::relation(ball, polygon_, counts); break;
      case QueryKind::PlaneSide: answer.plane = filtered::plane_side(ball, polygon_, counts); break;
      case QueryKind::Foot: answer.foot = filtered::foot(ball, polygon_, counts); break;
      case QueryKind::EdgesHit: answer.edges_hit = filtered::edges_hit(ball, polygon_, counts); break;
      case QueryKind::Answer: answer = PartialAnswer::of(filtered::answer(ball, polygon_, counts), ""); break;
    }
    answer.stage = to_string(counts.last());
    return answer;
  }

  std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    filtered::StageCounts counts;
    const FirstContact first = filtered::first_contact(motion, polygon_, counts);
    return PartialAnswer::of(first, filtered::answer(motion.ball, polygon_).off_plane, to_string(counts.last()));
  }

 private:
  filtered::PreparedPolygon polygon_;
};

class Filtered final : public Method {
 public:
  std::string_view name() const override { return "filtered"; }
  std::string_view summary() const override {
    return "certified: the answers of exact, at the cost of fast except near the boundary";
  }
  std::unique_ptr<PreparedMethod> prepare(const Polygon& polygon) const override {
    return std::make_unique<PreparedFiltered>(polygon);
  }
};

}  // namespace

void add_filtered(MethodList& list) { list.push_back(std::make_unique<Filtered>()); }

}  // namespace touchstone::methods
