// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/method.h"

#include "experiments/methods/all.h"

namespace touchstone::methods {

PartialAnswer PartialAnswer::of(const Answer& answer, std::string_view stage) {
  return {.plane = answer.plane,
          .plane_tangent = answer.plane_tangent,
          .foot = answer.foot,
          .edges_hit = answer.edges_hit,
          .relation = answer.relation,
          .contact = answer.contact(),
          .nearest = answer.nearest,
          .point = answer.point,
          .distance = answer.distance,
          .off_plane = answer.off_plane,
          .stage = stage};
}

const std::vector<std::unique_ptr<Method>>& all_methods() {
  static const std::vector<std::unique_ptr<Method>> methods = [] {
    std::vector<std::unique_ptr<Method>> list;
    add_exact(list);
    add_fast(list);
    add_thesis(list);
    return list;
  }();
  return methods;
}

const Method* find_method(std::string_view name) {
  for (const auto& method : all_methods())
    if (method->name() == name) return method.get();
  return nullptr;
}

}  // namespace touchstone::methods
