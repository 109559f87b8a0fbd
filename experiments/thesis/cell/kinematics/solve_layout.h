// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "experiments/thesis/cell/kinematics/layout.h"

namespace touchstone::kinematics {

/// The assumptions of the solution. All of them are chosen.
struct Assumptions {
  double sphere_distance = 65, sphere_radius = 6, side = 40, drop = 2.5;  ///< as in Layout
};

/// How the arm's links move while others turn.
struct Linkage {
  Coupling coupling;
  Hand hand;
};

/// Returns the layout for a linkage and a home pose in which every captioned angle of both cases results half a degree
/// from the next. The places of storage and machine, the gap and the clearance follow; radii and heights of the storage
/// generally differ between the cases. Returns nothing if the sphere would have to be behind the base's axis, or the
/// arm would have to sink when it should be lifted. Does not check for obstacles; `simulate` does.
[[nodiscard]] std::optional<Layout> solve_layout(const Linkage& linkage, const LinkAngles& home,
                                                 const Assumptions& assumptions = {});

/// Returns, ascending, the leans from -60 to 60 degrees for which the solved layout has one height of the storage in
/// both cases, for a linkage and a forearm's elevation at home.
[[nodiscard]] std::vector<double> leans_of_one_height(const Linkage& linkage, double elevation,
                                                      const Assumptions& assumptions = {});

/// The elevation of the forearm at home that the project uses. With the forearm level the hand, on its way from home to
/// the storage, would go through the place at the machine: at -25 degrees it passes in front of it.
inline constexpr double kChosenElevation = -25;

/// Returns the layout that the project uses: a level hand, a forearm that keeps its elevation while the shoulder turns,
/// and the lean that gives the storage one height in both cases. Every length and the lean are rounded to a tenth. Only
/// the storage's angle and radius then differ between the cases.
[[nodiscard]] Layout chosen_layout();

/// Returns the same with the wrist locked and the forearm level at home, as in the table of its lengths. What the hand
/// carries is then tilted and goes through the vice; the sphere alone does not know.
[[nodiscard]] Layout locked_layout();

}  // namespace touchstone::kinematics
