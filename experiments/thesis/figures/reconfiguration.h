// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/thesis/cell/area.h"
#include "experiments/thesis/cell/model/model.h"

/// Where the storage may stand, as `touchstone cell area` finds it.
namespace touchstone::figures {

/// Returns how the process ends with the storage at a place: touching the material `from the side` or `from above`, or
/// the cause of its failure.
[[nodiscard]] std::string_view outcome_of(const cell::Tried& place);

/// The cell's floor as a plan view shows it. All of it is chosen.
struct FloorPlan {
  double body;                  ///< radius of the circle in which the robot's first two links turn
  Eigen::AlignedBox2d storage;  ///< in the frame of its station, including the stand
  Eigen::AlignedBox2d machine;  ///< likewise
};
[[nodiscard]] FloorPlan floor_plan(const std::vector<cell::ModelPart>& parts);

/// From the first to the last of some places that complete, in their order.
struct Completing {
  std::size_t first, last;  ///< indices of places
};
/// Returns nothing if none completes.
[[nodiscard]] std::optional<Completing> completing(const std::vector<cell::Tried>& places);

/// Returns the places between these two that do not complete, with their outcomes: `405 to 415 mm (in-the-way), 570 mm
/// (in-the-way)`; an empty text if all complete. `where` is what differs between places.
[[nodiscard]] std::string gaps(const std::vector<cell::Tried>& places, const Completing& ends,
                               double cell::Tried::*where);

}  // namespace touchstone::figures
