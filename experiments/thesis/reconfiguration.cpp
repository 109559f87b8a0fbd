// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/reconfiguration.h"

#include <algorithm>

namespace touchstone::thesis_figures {

std::string_view outcome_of(const cell::Tried& place) {
  if (place.cause) return to_string(*place.cause);
  return place.from_side ? "from the side" : "from above";
}

FloorPlan floor_plan(const std::vector<cell::ModelPart>& parts) {
  FloorPlan plan{0, {}, {}};
  for (const cell::ModelPart& part : parts)
    for (const cell::Face& face : part.faces.faces)
      for (std::size_t i = 0; i < face.polygon.vertex_count(); ++i) {
        const Eigen::Vector2d at = face.polygon.vertex(i).head<2>();
        if (part.carrier == cell::Carrier::Storage) plan.storage.extend(at);
        if (part.carrier == cell::Carrier::Machine) plan.machine.extend(at);
        if (part.carrier == cell::Carrier::Link && part.link <= 1) plan.body = std::max(plan.body, at.norm());
      }
  return plan;
}

Stretch longest_stretch(const std::vector<cell::Tried>& places) {
  Stretch best{1, 0};
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::size_t end = i;
    while (end < places.size() && !places[end].cause) ++end;
    if (end > i && (best.empty() || end - i > best.last - best.first + 1)) best = {i, end - 1};
    i = end;
  }
  return best;
}

}  // namespace touchstone::thesis_figures
