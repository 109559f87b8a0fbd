// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/method.h"

namespace touchstone::cases {

PartialAnswer PartialAnswer::of(const Answer& answer, std::string_view stage) {
  return {.plane = answer.plane,
          .plane_tangent = answer.plane_tangent,
          .foot = answer.foot,
          .edges_hit = answer.edges_hit,
          .relation = answer.relation,
          .contact = answer.contact(),
          .first = {},
          .time = {},
          .momentary = {},
          .feature = {},
          .nearest = answer.nearest,
          .point = answer.point,
          .distance = answer.distance,
          .off_plane = answer.off_plane,
          .unsure = false,
          .stage = stage};
}

PartialAnswer PartialAnswer::of(const FirstContact& first, double off_plane, std::string_view stage) {
  PartialAnswer answer;
  answer.contact = first.contact();
  answer.first = first.kind;
  answer.time = first.time;
  if (first.kind == FirstContactKind::Way) answer.momentary = first.momentary;
  if (first.contact()) {
    answer.feature = first.feature;
    answer.point = first.point;
  }
  answer.off_plane = off_plane;
  answer.stage = stage;
  return answer;
}

std::optional<PartialAnswer> PreparedMethod::ask_moving(const Motion&) const { return std::nullopt; }

}  // namespace touchstone::cases
