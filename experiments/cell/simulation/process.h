// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cell/first_contact/first_contact.h"
#include "experiments/cell/kinematics/chain.h"
#include "experiments/cell/kinematics/simulation_terms.h"
#include "experiments/cell/simulation/workcell.h"

namespace touchstone::cell {

/// The phases of the whole process, in order.
enum class Phase {
  ToStorage,      ///< from home until the sphere touches the material, which is then gripped
  ToMachine,      ///< lifted, and lowered until the sphere touches the virtual material, where it is then placed
  Withdraw,       ///< up, out of the way; then the material is milled
  ToPiece,        ///< down again until the sphere touches the material, which is then gripped
  BackToStorage,  ///< until the sphere touches the virtual material in its slot, where it is then placed
  ToHome,
};
inline constexpr std::size_t kPhases = 6;
/// `to-storage`, `to-machine`, ...
[[nodiscard]] std::string_view to_string(Phase phase);

using kinematics::FailureCause;
using kinematics::Until;

/// One completed move of one joint.
struct Move {
  Phase phase;
  Moved joint;
  Until until;
  double degrees;  ///< a whole number of steps
  double exact;    ///< the angle before rounding to steps; for Contact, the angle at which contact begins
  double margin;   ///< degrees by which `exact` may change before `degrees` does
  std::optional<kinematics::FirstContact> contact;  ///< for Contact: certified
};

/// A moment at which the arm is tested: at home, and after every step.
struct Stop {
  std::size_t move;  ///< the number of the move; that of the first move for the stop before it
  kinematics::Angles commanded;
  Ball sphere;
  std::optional<StationSlot> target;   ///< of the material, real or virtual, that the sphere approaches or leaves
  std::optional<std::size_t> touched;  ///< the lowest face of the target that it touches
};

/// The place of the material from a stop on; numbers of stops are ascending.
struct MaterialTransfer {
  std::size_t stop;
  std::optional<StationSlot> slot;  ///< none while the gripper holds it
  double shift;  ///< of its frame's origin, from its place in the gripper to where it is put; 0 when gripped
};

struct Process {
  std::vector<Move> moves;
  std::vector<Stop> stops;
  std::vector<MaterialTransfer> transfers;  ///< the first is at stop 0, in storage
  std::string failure;                      ///< why it ended early; the members above hold everything until then
  /// Set if there is a failure; if several approaches failed, the last of their causes in the order of FailureCause.
  /// OutOfReach also if no lift clears the material.
  std::optional<FailureCause> cause;
  std::uint64_t balls = 0;  ///< the number of obstacle queries: of the sphere, and of the balls that cover the arm
};

/// Runs the process: home, storage, grip, lift, machine, place, milling, pick, storage, home.
///
/// One rule covers every angle, radius and height of the storage, and every robot: the first of several approaches that
/// succeeds. The material in storage is approached from the side with the shoulder as it is at home; else from above;
/// else from the side; else by either, with the base turned first. From above: the elbow moves to the angle that
/// inverse kinematics gives for the sphere on the upper face, the base turns to face the place, the shoulder moves down
/// until the sphere touches. From the side: shoulder and elbow move to the angles that inverse kinematics gives for
/// half the height of the material, and the base turns until the sphere touches. The machine is approached from above.
/// On the way back the base turns first. Home is reached base first, else shoulder or elbow first after the base has
/// turned aside. Material approached from above is left by a lift of the shoulder or, if that does not clear it, of the
/// elbow.
///
/// Guarantees
///  (1) at every stop, exactly, the sphere touches no obstacle and, unless it approaches or leaves it, not the
///      material, and no ball of the covers touches any;
///  (2) the sphere touches no obstacle between stops either: certified by first_contact;
///  (3) a move until contact ends at the first stop at which the sphere, exactly, touches a face of its target; the
///      certified contact lies within the last step.
/// Gripped material moves with the flange; it does not count as an obstacle and is not tested against obstacles. If (1)
/// or (2) cannot be kept, or a step skips a contact, `failure` names the move, the angle in degrees, and the obstacle.
[[nodiscard]] Process simulate(const Workcell& workcell);

}  // namespace touchstone::cell
