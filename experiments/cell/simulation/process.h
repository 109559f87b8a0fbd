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
#include "experiments/cell/simulation/workcell.h"

namespace touchstone::cell {

/// What the arm is about: the whole process, in order.
enum class Phase {
  ToStorage,      ///< from home until the sphere touches the material, which is gripped then
  ToMachine,      ///< lifted, and brought down until the sphere touches the virtual material, where it is placed then
  Withdraw,       ///< up, out of the way; then it is milled
  ToPiece,        ///< down again until the sphere touches the material, which is gripped then
  BackToStorage,  ///< until the sphere touches the virtual material in its slot, where it is placed then
  ToHome,
};
inline constexpr std::size_t kPhases = 6;
/// `to-storage`, `to-machine`, ...
[[nodiscard]] std::string_view word(Phase phase);

/// How far a joint is moved.
enum class Until {
  Planned,  ///< by the whole number of steps nearest to what inverse kinematics, or home, asks for
  Facing,   ///< by the whole number of steps with which the base faces a place best
  Contact,  ///< until the sphere touches what it comes for
  Cleared,  ///< until the sphere has risen by the clearance
};
[[nodiscard]] std::string_view word(Until until);

/// One move of one joint, as it came out.
struct Move {
  Phase phase;
  Moved joint;
  Until until;
  double degrees;  ///< a whole number of steps
  double exact;    ///< what was not rounded to steps; of Contact the angle at which it begins
  double margin;   ///< degrees that `exact` may change by before `degrees` does
  std::optional<kinematics::FirstContact> contact;  ///< of Contact: certified
};

/// A moment at which the arm is looked at: home, and after every step.
struct Stop {
  std::size_t move;  ///< its number; that of the first one for the stop before it
  kinematics::Angles commanded;
  Ball sphere;
  std::optional<Place> target;         ///< where what the sphere comes for, or leaves, is
  std::optional<std::size_t> touched;  ///< the lowest face of the target that it touches
};

/// Where the material is from a stop on, the numbers of stops ascending.
struct Custody {
  std::size_t stop;
  std::optional<Place> place;  ///< none: the gripper has it
  double shift;  ///< of its frame's origin, from where the gripper held it to where it is put; 0 where it is gripped
};

/// Why a process ended before its end; where several ways were tried, the last in this order of their causes.
enum class Cause {
  OutOfReach,    ///< inverse kinematics has no angles, or no lift clears the material
  BeyondLimits,  ///< a joint would have to turn further than it can
  NoContact,     ///< the sphere does not touch what it comes for, or steps over it
  InTheWay,      ///< sphere or arm come upon something else
};
/// `out-of-reach`, `beyond-limits`, ...
[[nodiscard]] std::string_view word(Cause cause);

struct Process {
  std::vector<Move> moves;
  std::vector<Stop> stops;
  std::vector<Custody> custody;  ///< the first is 0, in storage
  std::string failure;           ///< why it ended before its end; what was done until then stands above
  std::optional<Cause> cause;    ///< set where there is a failure
  std::uint64_t balls = 0;       ///< asked of the obstacles: the sphere's, and those that cover the arm
};

/// Runs the process: home, storage, grip, lift, machine, place, milling, pick, storage, home.
///
/// One rule for every angle, radius and height of the storage, and every robot: of several ways the first that comes
/// out. The material in storage is come upon from the side where the shoulder can stay as it is at home; else from
/// above; else from the side; else, by either, with the base turned first. From above: the elbow goes where inverse
/// kinematics has it for the sphere on the upper face, the base turns to face the place, the shoulder goes down until
/// the sphere touches. From the side: shoulder and elbow go where inverse kinematics has them for half the height of
/// the material, and the base turns until the sphere touches. At the machine it is from above. On the way back the base
/// turns first, and home is reached base first, else shoulder or elbow first, once the base has drawn aside. What was
/// come upon from above is left by a lift of the shoulder, or where that does not clear it, of the elbow.
///
/// Guarantees
///  (1) at every stop the sphere touches no obstacle, nor, unless it comes for it or leaves it, the material, and no
///      ball of the covers touches any: exactly;
///  (2) nor does the sphere touch an obstacle anywhere between stops: certified by first_contact;
///  (3) a move until contact ends at the first stop at which the sphere touches a face of what it comes for, exactly;
///      the certified contact lies within the last step.
/// What is gripped moves with the flange and is no obstacle, nor is it asked of any. Where (1) or (2) cannot be kept,
/// or a step passes over a contact, `failure` says which move, after how many degrees, and what is in the way.
[[nodiscard]] Process perform(const Workcell& workcell);

}  // namespace touchstone::cell
