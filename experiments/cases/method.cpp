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
          .nearest = answer.nearest,
          .point = answer.point,
          .distance = answer.distance,
          .off_plane = answer.off_plane,
          .unsure = false,
          .stage = stage};
}

}  // namespace touchstone::cases
