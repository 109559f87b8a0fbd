// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/cases/method.h"
#include "geometry/contact/fast.h"
#include "geometry/contact/fast_motion.h"

namespace touchstone::methods {

/// The code of `fast` over one Scalar, as a method. Scalars that fast.cpp does not instantiate need
/// fast_motion_definitions.h.
template <class Scalar>
class PreparedFast final : public PreparedMethod {
 public:
  PreparedFast(const Polygon& polygon, std::string_view stage) : polygon_(polygon), stage_(stage) {}

  PartialAnswer ask(const Ball& ball, QueryKind kind) const override {
    PartialAnswer answer;
    switch (kind) {
      case QueryKind::Contact: answer.contact = fast::contact(ball, polygon_); break;
      case QueryKind::Relation: answer.relation = fast::relation(ball, polygon_); break;
      case QueryKind::PlaneSide: answer.plane = fast::plane_side(ball, polygon_); break;
      case QueryKind::Foot: answer.foot = fast::foot(ball, polygon_); break;
      case QueryKind::EdgesHit: answer.edges_hit = fast::edges_hit(ball, polygon_); break;
      case QueryKind::Answer: answer = PartialAnswer::of(fast::answer(ball, polygon_), ""); break;
    }
    answer.stage = stage_;
    return answer;
  }

  std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    return PartialAnswer::of(fast::first_contact(motion, polygon_), fast::answer(motion.ball, polygon_).off_plane,
                             stage_);
  }

 private:
  fast::PreparedPolygon<Scalar> polygon_;
  std::string_view stage_;
};

/// `stage` names the scalar.
template <class Scalar>
class Fast final : public Method {
 public:
  Fast(std::string_view name, std::string_view stage, std::string_view summary)
      : name_(name), stage_(stage), summary_(summary) {}
  std::string_view name() const override { return name_; }
  std::string_view summary() const override { return summary_; }
  std::unique_ptr<PreparedMethod> prepare(const Polygon& polygon) const override {
    return std::make_unique<PreparedFast<Scalar>>(polygon, stage_);
  }

 private:
  std::string_view name_, stage_, summary_;
};

}  // namespace touchstone::methods
