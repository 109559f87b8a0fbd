// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

/// Terms of the simulation of the cell.
namespace touchstone::kinematics {

/// The direction from which the sphere comes to the material. `SideWithoutShoulder` leaves the shoulder as at home.
enum class Approach { SideWithoutShoulder, Above, Side };

/// The rule for how far a joint moves.
enum class Until {
  Planned,  ///< by the whole number of steps nearest to the result of inverse kinematics, or to home
  Facing,   ///< by the whole number of steps after which the base faces a station best
  Contact,  ///< until the sphere touches its target
  Cleared,  ///< until the sphere has risen by the clearance
};
/// `planned`, `facing`, ...
[[nodiscard]] std::string_view to_string(Until until);

/// The reason why a simulation ended early.
enum class FailureCause {
  OutOfReach,  ///< inverse kinematics has no solution
  JointLimit,  ///< a joint would have to turn beyond its limits
  NoContact,   ///< the sphere does not touch its target, or steps skip the contact
  NotHeld,     ///< what the sphere touches is not between the fingers
  Misplaced,   ///< what the gripper would let go is too far from its place
  InTheWay,    ///< something touches what it should not
};
/// `out-of-reach`, `beyond-limits`, ...
[[nodiscard]] std::string_view to_string(FailureCause cause);

/// Thrown inside a simulation that cannot continue.
struct SimulationFailure : std::runtime_error {
  SimulationFailure(FailureCause why, const std::string& text) : std::runtime_error(text), cause(why) {}
  FailureCause cause;
};

}  // namespace touchstone::kinematics
