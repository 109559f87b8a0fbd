// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "experiments/cell/kinematics/layout.h"

namespace touchstone::kinematics {

/// The assumptions of the solution. All of them are chosen.
struct Assumptions {
  double sphere_distance = 85, sphere_radius = 6, side = 40;  ///< as in Layout
};

/// Returns the layout for a coupling and a home pose in which every captioned angle of both cases results half a degree
/// from the next. The places of storage and machine, the gap and the clearance follow; radii and heights of the storage
/// generally differ between the cases. Returns nothing if the sphere would have to be behind the base's axis, or the
/// arm would have to sink when it should be lifted. Does not check for obstacles; `simulate` does.
[[nodiscard]] std::optional<Layout> solve_layout(Coupling coupling, const LinkAngles& home,
                                                 const Assumptions& assumptions = {});

/// Returns, ascending, the leans from -60 to 60 degrees for which the solved layout has one height of the storage in
/// both cases, for a coupling and a forearm's elevation at home.
[[nodiscard]] std::vector<double> leans_of_one_height(Coupling coupling, double elevation,
                                                      const Assumptions& assumptions = {});

/// Returns the layout that the project uses. The forearm is horizontal at home, as in the table of its lengths, and
/// keeps its elevation while the shoulder turns. The lean is the one that gives the storage one height in both cases.
/// Every length and the lean are rounded to a tenth. Only the storage's angle and radius then differ between the cases.
[[nodiscard]] Layout chosen_layout();

}  // namespace touchstone::kinematics
