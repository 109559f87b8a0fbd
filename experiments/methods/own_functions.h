// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/methods/add_methods.h"

namespace touchstone::methods {

/// Asks the functions that lie beside the prepared polygon: those of `exact`, `fast` or `filtered`. `counts`: nothing,
/// or what they count stages in.
template <class Prepared, class... Counts>
[[nodiscard]] PartialAnswer answer_of(const Ball& ball, QueryKind kind, const Prepared& polygon, Counts&... counts) {
  PartialAnswer found;
  switch (kind) {
    case QueryKind::Contact: found.contact = contact(ball, polygon, counts...); break;
    case QueryKind::Relation: found.relation = relation(ball, polygon, counts...); break;
    case QueryKind::PlaneSide: found.plane = plane_side(ball, polygon, counts...); break;
    case QueryKind::Foot: found.foot = foot(ball, polygon, counts...); break;
    case QueryKind::EdgesHit: found.edges_hit = edges_hit(ball, polygon, counts...); break;
    case QueryKind::Answer: found = PartialAnswer::of(answer(ball, polygon, counts...), ""); break;
  }
  return found;
}

/// The same about a moving ball.
template <class Prepared, class... Counts>
[[nodiscard]] PartialAnswer answer_of(const Motion& motion, const Prepared& polygon, Counts&... counts) {
  const FirstContact first = first_contact(motion, polygon, counts...);
  return PartialAnswer::of(first, answer(motion.ball, polygon).off_plane, "");
}

/// Functions that count nothing, as a method. `stage`: what --explain calls them.
template <class Prepared>
class PreparedOwn final : public PreparedMethod {
 public:
  PreparedOwn(const Polygon& polygon, std::string_view stage) : polygon_(polygon), stage_(stage) {}

  PartialAnswer ask(const Ball& ball, QueryKind kind) const override { return staged(answer_of(ball, kind, polygon_)); }
  std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    return staged(answer_of(motion, polygon_));
  }

 private:
  [[nodiscard]] PartialAnswer staged(PartialAnswer answer) const {
    answer.stage = stage_;
    return answer;
  }

  Prepared polygon_;
  std::string_view stage_;
};

template <class Prepared>
[[nodiscard]] std::unique_ptr<Method> own_method(const char* name, const char* stage, const char* summary,
                                                 Method::Kind kind = Method::Kind::Usual,
                                                 Method::PrepareMesh prepare_mesh = nullptr) {
  return std::make_unique<Method>(
      name, summary,
      [stage](const Polygon& polygon) { return std::make_unique<PreparedOwn<Prepared>>(polygon, stage); }, kind,
      std::move(prepare_mesh));
}

}  // namespace touchstone::methods
