// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "experiments/cell/kinematics/layout.h"

namespace touchstone::kinematics {

/// What is assumed before anything is solved for. All of it is chosen.
struct Assumptions {
  double sphere_distance = 85, sphere_radius = 6, side = 40;  ///< as in Layout
};

/// The layout for a coupling and a home pose in which every captioned angle of both cases comes out half a degree from
/// the next: the places of storage and machine, the gap and the clearance follow; radii and heights of the storage
/// differ between the cases, in general. None where the sphere would have to be behind the base's axis, or the arm to
/// sink where it is to be lifted. That nothing is in the way is for rehearse to say.
[[nodiscard]] std::optional<Layout> solve_layout(Coupling coupling, const LinkAngles& home,
                                                 const Assumptions& assumptions = {});

/// The leans, from -60 to 60 degrees, with which the solved layout has one height of the storage in both cases, for a
/// coupling and a forearm's elevation at home; ascending.
[[nodiscard]] std::vector<double> leans_of_one_height(Coupling coupling, double elevation,
                                                      const Assumptions& assumptions = {});

/// The layout that the project uses. The forearm is horizontal at home, as in the table of its lengths, and keeps its
/// elevation while the shoulder turns; the lean is the one of one height of the storage in both cases; every length and
/// the lean are rounded to a tenth. What differs between the cases is then the storage's angle and radius.
[[nodiscard]] Layout chosen_layout();

}  // namespace touchstone::kinematics
