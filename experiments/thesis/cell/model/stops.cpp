// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/stops.h"

#include <fmt/core.h>

#include "experiments/thesis/cell/model/cell_entry.h"

namespace touchstone::cell {

void check_stops(const Cell& cell) {
  for (const Joint& joint : cell.robot.joints) {
    const double stops = (joint.upper - joint.lower) / cell.step;
    if (stops > kMostStops)
      throw BadCell(fmt::format(
          "{}: step: at {:g} degrees a stop, joint \"{}\" would take {:.3g} stops from {:g} to {:g} degrees; at "
          "most {:g} are allowed",
          cell.file.string(), cell.step, joint.name, stops, joint.lower, joint.upper, kMostStops));
  }
}

}  // namespace touchstone::cell
