// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cell/kinematics/rehearsal.h"
#include "experiments/cell/model/model.h"

/// Where the storage may stand: rehearsals of the way from home by the storage to the machine, one a place.
namespace touchstone::thesis_figures {

/// What comes out with the storage at a place.
enum class Outcome {
  FromSide,   ///< it completes, the material touched from the side
  FromAbove,  ///< it completes, the material touched from above
  OnRobot,    ///< seen from above, the storage would stand in the circle in which the robot's body turns
  OnMachine,  ///< seen from above, the storage would stand in the machine
  OutOfReach,
  JointLimit,
  InTheWay,  ///< the sphere touches something on a move that should be free
  Nothing,   ///< the sphere touches nothing where it should, or steps pass over it, or nothing lifts it clear
};
[[nodiscard]] std::string_view word(Outcome outcome);
[[nodiscard]] constexpr bool completes(Outcome outcome) {
  return outcome == Outcome::FromSide || outcome == Outcome::FromAbove;
}

/// The cell's floor: what a plan view shows. All of it is chosen.
struct FloorPlan {
  double body;                  ///< radius of the circle in which the robot's first two links turn
  Eigen::AlignedBox2d storage;  ///< in the frame of its station, stand included
  Eigen::AlignedBox2d machine;  ///< likewise
  /// The least radius at which the storage is clear of the body.
  [[nodiscard]] double least_radius() const { return body - storage.min().x(); }
};
[[nodiscard]] FloorPlan floor_plan(const std::vector<cell::ModelPart>& parts);

/// A storage somewhere.
struct Place {
  double angle, radius, height;
  Outcome outcome;
  std::string failure;  ///< in words, with the number that is exceeded; empty where it completes
};
/// The floor plan comes first, then the rehearsal, which asks about the sphere alone.
[[nodiscard]] Place try_place(const kinematics::Layout& layout, const FloorPlan& plan, double angle, double radius,
                              double height);

/// An unbroken run of places that complete.
struct Stretch {
  std::size_t first, last;  ///< among the places
  [[nodiscard]] bool empty() const { return first > last; }
};
/// The longest, the first of equal ones.
[[nodiscard]] Stretch longest_stretch(const std::vector<Place>& places);

}  // namespace touchstone::thesis_figures
