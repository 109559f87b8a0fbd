// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust/exact/exact.h"

#include "experiments/methods/add_methods.h"
#include "robust/exact/motion.h"

namespace touchstone::methods {
namespace {

class PreparedExact final : public PreparedMethod {
 public:
  explicit PreparedExact(const Polygon& polygon) : polygon_(polygon) {}

  PartialAnswer ask(const Ball& ball, QueryKind kind) const override {
    PartialAnswer answer;
    switch (kind) {
      case QueryKind::Contact: answer.contact = exact::contact(ball, polygon_); break;
      case QueryKind::Relation: answer.relation = exact::relation(ball, polygon_); break;
      case QueryKind::PlaneSide: answer.plane = exact::plane_side(ball, polygon_); break;
      case QueryKind::Foot: answer.foot = exact::foot(ball, polygon_); break;
      case QueryKind::EdgesHit: answer.edges_hit = exact::edges_hit(ball, polygon_); break;
      case QueryKind::Answer: answer = PartialAnswer::of(exact::answer(ball, polygon_), ""); break;
    }
    answer.stage = "exact";
    return answer;
  }

  std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    return PartialAnswer::of(exact::first_contact(motion, polygon_), exact::answer(motion.ball, polygon_).off_plane,
                             "exact");
  }

 private:
  exact::PreparedPolygon polygon_;
};

class Exact final : public Method {
 public:
  std::string_view name() const override { return "exact"; }
  std::string_view summary() const override {
    return "the truth: CGAL exact arithmetic, correctly rounded point and distance";
  }
  bool slow() const override { return true; }
  std::unique_ptr<PreparedMethod> prepare(const Polygon& polygon) const override {
    return std::make_unique<PreparedExact>(polygon);
  }
};

}  // namespace

void add_exact(MethodList& list) { list.push_back(std::make_unique<Exact>()); }

}  // namespace touchstone::methods
