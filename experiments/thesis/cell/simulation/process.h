// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/thesis/cell/first_contact/first_contact.h"
#include "experiments/thesis/cell/kinematics/chain.h"
#include "experiments/thesis/cell/simulation/grip.h"
#include "experiments/thesis/cell/simulation/workcell.h"

namespace touchstone::cell {

/// How the sphere comes to the material in the thesis's order of moves. `Side` leaves the shoulder as at home.
enum class Approach { Side, Above, SideByShoulder, AboveBaseFirst };

/// The rule for how far a joint moves.
enum class Until {
  Planned,  ///< by the whole number of steps nearest to the result of inverse kinematics, or to home
  Facing,   ///< by the whole number of steps after which the base faces a station best
  Contact,  ///< until the sphere touches its target
  Cleared,  ///< until the sphere has risen by the clearance
  Landed,   ///< straight down, until the underside of what is held touches what is below it
  Raised,   ///< straight up again
  Through,  ///< to the next point of a way that was found, all joints at the same time
};
/// `planned`, `facing`, ...
[[nodiscard]] std::string_view to_string(Until until);

/// The reason why a simulation ended early.
enum class FailureCause {
  OutOfReach,  ///< inverse kinematics has no solution
  JointLimit,  ///< a joint would have to turn beyond its limits
  NoContact,   ///< the sphere does not touch its target, or steps skip the contact
  NotHeld,     ///< the fingers do not hold what the sphere touches
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

/// The phases of the whole process, in order.
enum class Phase {
  ToStorage,      ///< from home until the sphere touches the material, which is then gripped
  ToMachine,      ///< lifted, and lowered until the sphere touches the virtual material
  Withdraw,       ///< down until it lands, let go, and up, out of the way; then the material is milled
  ToPiece,        ///< down again until the sphere touches the material, which is then gripped
  BackToStorage,  ///< until the sphere touches the virtual material in its slot
  ToHome,         ///< down until it lands, let go, and home
};
inline constexpr std::size_t kPhases = 6;
/// `to-storage`, `to-machine`, ...
[[nodiscard]] std::string_view to_string(Phase phase);

/// A stop at which the method that drives the robot says contact, or at which it should have.
struct WrongStop {
  /// By how many degrees it is before the stop of the exact answer, negative if behind it; empty if the exact answer
  /// has no contact on the move.
  std::optional<double> early;
  double gap;  ///< between the sphere and the material, or its virtual copy; 0 if they touch
};

/// One completed move: of one joint or, straight or by a way that was found, of several together.
struct Move {
  Phase phase;
  Moved joint;  ///< the one that turns furthest; the shoulder if it is straight
  Until until;
  double degrees;  ///< a whole number of steps, except for Through; 0 if it is straight
  double exact;    ///< the angle before rounding to steps; for Contact, the angle at which contact begins
  double margin;   ///< degrees by which `exact` may change before `degrees` does
  /// For Contact of one joint: certified; empty without contact on the move.
  std::optional<kinematics::FirstContact> contact;
  std::optional<WrongStop> wrong;  ///< if the driving method is not the exact answer, and errs
  double rise = 0;                 ///< of the hand, if it is straight up, or down (negative)
};

/// A moment at which the arm is tested: at home, and after every step.
struct Stop {
  std::size_t move;  ///< the number of the move; that of the first move for the stop before it
  kinematics::Angles commanded;
  Ball sphere;
  std::optional<StationSlot> target;   ///< of the material, real or virtual, that the sphere approaches or leaves
  std::optional<std::size_t> touched;  ///< the lowest face of the target that it touches, by whatever drives the robot
};

/// How the material was put down.
struct Landing {
  double way;           ///< by which it was lowered
  double gap;           ///< at most, between it and what it lies on
  std::string support;  ///< what it lies on, as in ModelPart, or the floor
};

/// The place of the material from a stop on; numbers of stops are ascending.
struct MaterialTransfer {
  std::size_t stop;
  std::optional<StationSlot> slot;  ///< none while the gripper holds it
  double shift;  ///< of its frame's origin from its place, where the gripper lets it go; 0 when gripped
  double turn;   ///< degrees, the same
  std::optional<Pose> in_flange;        ///< where the gripper holds it
  Lying lies = {};                      ///< where it lies in the cell, if the gripper does not hold it
  std::optional<Grip> grip = {};        ///< how fingers hold it; none if it sticks to the gripper
  std::optional<Landing> landing = {};  ///< how it was put down; none if the sphere alone is tested
};

/// A thing that moves: the moving parts of the arm with the gripper, the held material, and the virtual sphere.
enum class Mover { Arm, Held, Sphere };
inline constexpr std::array kMovers{Mover::Arm, Mover::Held, Mover::Sphere};
/// `arm`, `held material`, `sphere`
[[nodiscard]] std::string_view to_string(Mover mover);

/// A mover in a virtual object, as zone_triggers finds it.
struct Trigger {
  std::size_t zone;  ///< index in Cell::zones
  Mover mover;
  std::string part;    ///< of the mover, which comes in first
  std::size_t after;   ///< it comes in after this stop,
  double degrees;      ///< and the joint's way from there; 0 for what is in at that stop
  std::size_t until;   ///< from this stop on it is outside; the last stop if it stays in
  Eigen::Vector3d at;  ///< the sphere's centre when it comes in
};

/// Where a process ends early.
struct Stuck {
  std::string reason;              ///< one sentence
  kinematics::Angles commanded;    ///< of the arm when parts touch, or when it stops
  std::vector<std::string> parts;  ///< that touch, as in Hindrance; empty for another reason
};

struct Process {
  std::vector<Move> moves;
  std::vector<Stop> stops;
  std::vector<MaterialTransfer> transfers;  ///< the first is at stop 0, in storage
  /// Why it ended early, a sentence of the approach that went furthest. The members above hold everything until then.
  std::string failure;
  std::optional<Stuck> stuck;         ///< if there is a failure: what it says, and where
  std::optional<FailureCause> cause;  ///< if there is a failure; OutOfReach also if no lift clears the material
  std::vector<std::string> refused;   ///< if there is a failure: why, a sentence for every approach
  std::vector<Trigger> triggers;      ///< by stop
  std::uint64_t queries = 0;          ///< the number of distances that were measured for obstacles

  /// Returns the last transfer before a stop: where the material is when the arm arrives there.
  [[nodiscard]] const MaterialTransfer& holding(std::size_t stop) const;
  /// Returns the sum of a joint's moves in a phase.
  [[nodiscard]] double turned(Moved joint, Phase phase) const;
  /// Returns the sum of a joint's moves up to the machine.
  [[nodiscard]] double net(Moved joint) const {
    return turned(joint, Phase::ToStorage) + turned(joint, Phase::ToMachine);
  }
};

/// A turn from a stop to the next: of one joint or several, each evenly.
struct Step {
  Moved joint;               ///< that turns furthest; the base if none turns
  double degrees;            ///< by which it does
  std::array<double, 3> by;  ///< by which each of those does that move

  /// Returns the angles once `joint` has turned by `degrees`, without a sign.
  [[nodiscard]] kinematics::Angles after(kinematics::Angles from, double turned) const;
};
[[nodiscard]] Step step_of(Moved joint, double degrees);
[[nodiscard]] Step step_between(const kinematics::Angles& from, const kinematics::Angles& to);
[[nodiscard]] inline Step step_between(const Stop& from, const Stop& to) {
  return step_between(from.commanded, to.commanded);
}

/// How much of the process is simulated, and by which tests.
struct Rule {
  Phase last = Phase::ToHome;  ///< the process ends after this phase
  /// The thesis's rule: nothing but the virtual sphere is tested. The arm, the gripper and what it holds go through
  /// everything, and whatever the sphere touches is gripped.
  bool sphere_alone = false;
  /// The method whose answer about the faces of the target stops the robot; null for the exact answer.
  const cases::Method* drive = nullptr;
  /// Whether ways are found where the thesis's order of moves fails. A method that drives keeps to that order.
  bool finds_ways = true;
};

/// Runs the process: home, storage, grip, lift, machine, place, milling, pick, storage, home.
///
/// One rule covers every angle, radius and height of the storage, and every robot. The robot comes to each place, and
/// home, in the thesis's order of moves or, where that fails, by a way that is found.
///
/// In the thesis's order every move turns one joint by whole steps. The material in storage is approached from the side
/// with the shoulder as it is at home; else from above; else from the side; else from above with the base turned first.
/// From above: the elbow moves to the angle that inverse kinematics gives for the sphere on the upper face, the base
/// turns to face the place, the shoulder moves down until the sphere touches. From the side: shoulder and elbow move to
/// the angles that inverse kinematics gives for a point a little below the height of the upper face (below_upper_face),
/// and the base turns until the sphere touches. The machine is approached from above. At an empty slot the sphere comes
/// upon the virtual material. On the way back the shoulder rises to where it is at home, the base turns, and shoulder
/// or elbow lowers. Home is reached by base, shoulder or elbow first. What was gripped or let go from above is left by
/// a lift of the shoulder or of the elbow.
///
/// A way that is found (find_way) begins with the hand straight up by the clearance or, if that is not free, half or a
/// quarter of it; leads to as much above the next place as is within reach; and ends straight down, until the sphere
/// touches, or at home. What follows is by such ways, too. If that does not complete, all is tried by such ways alone.
///
/// Guarantees
///  (1) at every angle of every move the sphere touches no obstacle and, unless it approaches or leaves it, not the
///      material: certified by first_contact for moves of one joint, else by Sweep;
///  (2) at every angle of every move the arm, the gripper and what it holds touch nothing, as Sweep defines it;
///  (3) unless a method drives, a move until contact ends at the first stop at which the sphere, exactly, touches a
///      face of its target; for a move of one joint the certified contact lies within the last step;
///  (4) both fingers touch what is gripped, on opposite faces (close_upon), and on their way they touch nothing else;
///  (5) what is let go lies on what stopped it on its way down: at most 2e-12 of the arm's reach from it, never in it.
///      It is within the tolerance of its place (Material::Tolerance), and stays where it lies until it is gripped;
///  (6) no two things that stand overlap, and none lies in the arm at home, or the arm in it (sweep.h).
/// With `sphere_alone`, (1) and (3) only, and what is let go is in its place at once. Virtual objects stop nothing,
/// unless the file says so: then the process ends where something comes into one (zone_triggers). If one of them cannot
/// be kept, or a step skips a contact, `failure` says why: it names the move, the angle in degrees, and the obstacle.
/// Moves, stops and `failure` are then those of the approach that went furthest, up to there: that handed the material
/// over most often, or is in the latest phase; `refused` has those of every approach.
[[nodiscard]] Process simulate(const Workcell& workcell, const Rule& rule = {});

}  // namespace touchstone::cell
