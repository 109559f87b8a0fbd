// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cell/kinematics/simulated_path.h"
#include "experiments/cell/model/model.h"

/// The feasible places of the storage, found by simulating the path from home by the storage to the machine, once per
/// place.
namespace touchstone::thesis_figures {

/// The outcome with the storage at a place.
enum class Outcome {
  FromSide,   ///< the way completes, touching the material from the side
  FromAbove,  ///< the way completes, touching the material from above
  OnRobot,    ///< seen from above, the storage would stand in the circle in which the robot's body turns
  OnMachine,  ///< seen from above, the storage would stand in the machine
  OutOfReach,
  JointLimit,
  InTheWay,  ///< the sphere touches an obstacle on a move that should be free
  Nothing,   ///< the sphere misses what it should touch, steps skip the contact, or no lift clears the material
};
[[nodiscard]] std::string_view to_string(Outcome outcome);
[[nodiscard]] constexpr bool completes(Outcome outcome) {
  return outcome == Outcome::FromSide || outcome == Outcome::FromAbove;
}

/// The cell's floor as a plan view shows it. All of it is chosen.
struct FloorPlan {
  double body;                  ///< radius of the circle in which the robot's first two links turn
  Eigen::AlignedBox2d storage;  ///< in the frame of its station, including the stand
  Eigen::AlignedBox2d machine;  ///< likewise
  /// Returns the least radius at which the storage is clear of the body.
  [[nodiscard]] double least_radius() const { return body - storage.min().x(); }
};
[[nodiscard]] FloorPlan floor_plan(const std::vector<cell::ModelPart>& parts);

/// A place of the storage, and its outcome.
struct StoragePosition {
  double angle, radius, height;
  Outcome outcome;
  std::string failure;  ///< in words, with the exceeded number; empty if the way completes
};
/// Tries a place: checks the floor plan first, then simulates, testing the sphere alone.
[[nodiscard]] StoragePosition try_position(const kinematics::Layout& layout, const FloorPlan& plan, double angle,
                                           double radius, double height);

/// A contiguous run of places that complete.
struct Stretch {
  std::size_t first, last;  ///< indices of places
  [[nodiscard]] bool empty() const { return first > last; }
};
/// Returns the longest run, the first of equal ones.
[[nodiscard]] Stretch longest_stretch(const std::vector<StoragePosition>& places);

}  // namespace touchstone::thesis_figures
