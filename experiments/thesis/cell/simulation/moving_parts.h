// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/thesis/cell/simulation/cycle_time.h"
#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/triangle_distance.h"

namespace touchstone::cell {

/// A part of a mover, in the frame of a link.
struct MovingPart {
  Mover mover;
  std::string name;
  std::size_t link;
  TriangleTree triangles;
  double radius;  ///< of the sphere; 0 for other parts

  /// Whether it is there while the material is where a transfer has put it.
  [[nodiscard]] bool is_there(const MaterialTransfer& state) const { return mover != Mover::Held || !state.slot; }
  /// Returns its pose with the arm at these links. Requires that it is there.
  [[nodiscard]] Pose pose(const std::vector<Pose>& links, const MaterialTransfer& state) const;
  /// Returns a ball around it at a pose.
  [[nodiscard]] Ball around(const Pose& pose) const;
  /// Returns its distance from triangles that stand, as `distance` of two trees.
  [[nodiscard]] DistanceBounds distance_from(const TriangleTree& still, const Pose& pose, double cutoff) const;
};

/// Returns the moving parts of the arm, the gripper, the material and the virtual sphere; with `foot` also those of the
/// robot's foot, which does not move.
[[nodiscard]] std::vector<MovingPart> moving_parts(const Workcell& workcell, bool foot = false);
/// Returns triangles by their owners.
[[nodiscard]] std::vector<std::vector<NamedTriangle>> by_owner(const std::vector<NamedTriangle>& triangles);

/// A stretch of a run in which the material stays where it is.
struct Stretch {
  std::size_t first, last;  ///< stops
  const MaterialTransfer* state;
};
/// Returns the stretches of a run, which must outlive them; none without a stop.
[[nodiscard]] std::vector<Stretch> stretches_of(const Process& process);

/// The way between two stops.
struct WayBetween {
  StepOfJoint step;
  std::vector<double> moved;  ///< that no point of a part moves further, by part; 0 for what is not there
};
[[nodiscard]] WayBetween way_between(const Arm& arm, const std::vector<MovingPart>& parts, const Stop& from,
                                     const Stop& to, const std::vector<Pose>& links, const MaterialTransfer& state);

}  // namespace touchstone::cell
