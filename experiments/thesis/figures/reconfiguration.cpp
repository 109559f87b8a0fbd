// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/reconfiguration.h"

#include <fmt/core.h>

#include <algorithm>

namespace touchstone::figures {

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

std::optional<Completing> completing(const std::vector<cell::Tried>& places) {
  const auto completes = [](const cell::Tried& place) { return !place.cause; };
  const auto first = std::ranges::find_if(places, completes);
  if (first == places.end()) return std::nullopt;
  const auto last = std::find_if(places.rbegin(), places.rend(), completes).base() - 1;
  return Completing{static_cast<std::size_t>(first - places.begin()), static_cast<std::size_t>(last - places.begin())};
}

std::string gaps(const std::vector<cell::Tried>& places, const Completing& ends, double cell::Tried::*where) {
  std::string text;
  for (std::size_t i = ends.first; i < ends.last; ++i) {
    if (!places[i].cause) continue;
    const std::size_t first = i;
    while (places[i + 1].cause == places[first].cause) ++i;
    text += fmt::format("{}{:g}{} mm ({})", text.empty() ? "" : ", ", places[first].*where,
                        i > first ? fmt::format(" to {:g}", places[i].*where) : "", outcome_of(places[first]));
  }
  return text;
}

}  // namespace touchstone::figures
