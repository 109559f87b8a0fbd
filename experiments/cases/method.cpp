// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/method.h"

#include <cmath>

#include "experiments/cases/key.h"

namespace touchstone::cases {

Question with_radius(Question question, double radius) {
  auto* motion = std::get_if<Motion>(&question);
  (motion ? motion->ball : std::get<Ball>(question)).radius = radius;
  return question;
}

PartialAnswer PartialAnswer::of(const Answer& answer, std::string_view stage) {
  PartialAnswer all;
  all.plane = answer.plane;
  all.plane_tangent = answer.plane_tangent;
  all.foot = answer.foot;
  all.edges_hit = answer.edges_hit;
  all.relation = answer.relation;
  all.contact = answer.contact();
  all.nearest = answer.nearest;
  all.point = answer.point;
  all.distance = answer.distance;
  all.contact_normal = answer.contact_normal;
  all.depth = answer.depth;
  all.off_plane = answer.off_plane;
  all.stage = stage;
  return all;
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
    answer.contact_normal = first.contact_normal;
    answer.depth = first.depth;
  }
  answer.off_plane = off_plane;
  answer.stage = stage;
  return answer;
}

PartialAnswer PartialAnswer::of_mesh(PartialAnswer of_face, std::size_t face, std::vector<std::size_t> touched) {
  of_face.plane.reset();
  of_face.plane_tangent.reset();
  of_face.foot.reset();
  of_face.edges_hit.reset();
  of_face.off_plane.reset();
  // A moving ball that touches none has no first face.
  if (!of_face.time || std::isfinite(*of_face.time)) of_face.face = face;
  of_face.touched = std::move(touched);
  return of_face;
}

std::optional<PartialAnswer> PreparedMethod::ask_moving(const Motion&) const { return std::nullopt; }

std::optional<PartialAnswer> PreparedMethod::answer(const Question& question) const {
  if (const auto* motion = std::get_if<Motion>(&question)) return ask_moving(*motion);
  return ask(std::get<Ball>(question), QueryKind::Answer);
}

bool is_null(const PartialAnswer& answer, const Key& key) {
  if (!answer.first || has(answer, key)) return false;
  if (key == key_of(&PartialAnswer::momentary)) return *answer.first != FirstContactKind::Way;
  if (*answer.first != FirstContactKind::None) return false;
  if (key == key_of(&PartialAnswer::face)) return answer.touched.has_value();
  return key == key_of(&PartialAnswer::feature) || key == key_of(&PartialAnswer::point) ||
         key == key_of(&PartialAnswer::contact_normal) || key == key_of(&PartialAnswer::depth);
}

PartialAnswer only(const PartialAnswer& answer, const std::vector<Key>& keys) {
  PartialAnswer some;
  for (const Key& key : keys) key.visit([&](auto member) { some.*member = answer.*member; });
  return some;
}

}  // namespace touchstone::cases
