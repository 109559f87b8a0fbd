// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/handling.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/thesis/cell/kinematics/layout.h"
#include "experiments/thesis/cell/simulation/triangle_distance.h"

namespace touchstone::cell {
namespace {

constexpr int kShifts = 16;  // of equal length, up to the play: fingers are thicker than one

/// Names the part of the gripper that material at a pose in the flange's frame touches; empty if none does.
std::string met_by_gripper(const Workcell& workcell, const Pose& in_flange) {
  for (const NamedTriangle& each : workcell.material()) {
    const Triangle triangle{in_flange * each.triangle.a, in_flange * each.triangle.b, in_flange * each.triangle.c};
    for (const NamedTriangle& finger : workcell.gripper())
      if (distance(triangle, finger.triangle).lower == 0) return workcell.names()[finger.owner];
  }
  return "";
}

/// Says why the gripper would not hold material at a pose in the flange's frame: on which side no finger is within the
/// play of Gripper::Hold. Empty if it would, or if the cell has no such condition.
std::string why_not_held(const Workcell& workcell, const Pose& in_flange) {
  const auto& hold = workcell.cell().gripper.hold;
  if (!hold) return "";
  if (const std::string met = met_by_gripper(workcell, in_flange); !met.empty()) return met + " touches it";
  for (const double side : {1.0, -1.0}) {
    const auto met = [&](int shifts) {
      Pose shifted = in_flange;
      shifted.translation += side * shifts * hold->play / kShifts * hold->along;
      return !met_by_gripper(workcell, shifted).empty();
    };
    bool stopped = false;
    for (int shifts = 1; shifts <= kShifts && !stopped; ++shifts) stopped = met(shifts);
    if (!stopped)
      return fmt::format("towards {}({:g}, {:g}, {:g}) of the hand no finger is within {:g} {}", side > 0 ? "" : "-",
                         hold->along.x(), hold->along.y(), hold->along.z(), hold->play, workcell.cell().unit.name);
  }
  return "";
}

}  // namespace

void Handling::come_upon(StationSlot slot, Approach approach, Order order) {
  const Workplace& at = workcell_->at(slot);
  target_ = slot;
  above_ = approach == Approach::Above;
  if (above_) {
    if (order == Order::BaseFirst) face(at);
    come_down(at);
    return;
  }
  if (order == Order::BaseFirst) turn_near(at);
  const double target = nearest_base(at.azimuth), radius = arm_->sphere.radius;
  const double beside = clockwise(target) ? at.left + radius : at.right - radius;
  const double height = std::max(at.top - kinematics::below_upper_face(radius), (at.bottom + at.top) / 2);
  const auto commands = workcell_->plane().inverse({std::sqrt(at.out * at.out + beside * beside), height + drop(at)});
  if (!commands) fail(FailureCause::OutOfReach, "the side of the material is out of reach");
  if (std::abs(commands->shoulder - arm_->home[kShoulder]) >= step_ / 2 && approach == Approach::SideWithoutShoulder)
    fail(FailureCause::OutOfReach, "the shoulder would have to move");
  move_to(kShoulder, commands->shoulder);
  move_to(kElbow, commands->elbow);
  move_until_contact(kBase, steps_to(kBase, target));
}

void Handling::come_down_by_elbow(StationSlot slot) {
  const Workplace& at = workcell_->at(slot);
  target_ = slot;
  above_ = true;
  const auto commands = commands_above(at);
  face(at);
  move_to(kShoulder, commands.shoulder);
  move_until_contact(kElbow, commands.elbow > angles_[kElbow]);
}

void Handling::come_down_again() {
  target_ = StationSlot::Machine;
  go_down();
}

void Handling::grip() {
  const StationSlot slot = *process.transfers.back().slot;
  const Pose flange = arm_->link_poses(angles_).back();
  const Pose held = within(inverse(flange), workcell_->at(slot).pose);
  if (sweep_ != nullptr)
    if (const std::string loose = why_not_held(*workcell_, held); !loose.empty())
      fail(FailureCause::NotHeld, fmt::format("{}: the gripper does not hold the material in the {}: {}",
                                              to_string(phase_), to_string(slot), loose));
  process.transfers.push_back({process.stops.size() - 1, std::nullopt, 0, 0, held});
  target_.reset();
}

void Handling::release(StationSlot slot) {
  const Pose flange = arm_->link_poses(angles_).back(), &place = workcell_->at(slot).pose;
  const Pose held = within(flange, *process.transfers.back().in_flange);
  const double shift = (place.translation - held.translation).norm(), turn = turn_between(held, place);
  const auto& tolerance = workcell_->cell().material.tolerance;
  if (sweep_ != nullptr && tolerance && (shift > tolerance->distance || turn > tolerance->degrees))
    fail(FailureCause::Misplaced,
         fmt::format("{}: the material would be let go {:.1f} {} and {:.1f} degrees from its place in the {}, which is "
                     "more than {:g} and {:g}",
                     to_string(phase_), shift, workcell_->cell().unit.name, turn, to_string(slot), tolerance->distance,
                     tolerance->degrees));
  if (sweep_ != nullptr)
    if (const std::string met = met_by_gripper(*workcell_, within(inverse(flange), place)); !met.empty())
      fail_at(
          fmt::format("{}: once the material lies in the {}, {} touches it", to_string(phase_), to_string(slot), met),
          kBase, 0, {met, "material"});
  process.transfers.push_back({process.stops.size() - 1, slot, shift, turn, {}});
  leaving_ = true;
}

void Handling::lift(Moved joint) {
  if (!lift_by(joint))
    fail(FailureCause::OutOfReach, fmt::format("{} {}: no lift within a quarter of a turn clears the material",
                                               to_string(phase_), arm_->chain.joints()[joint].name));
  left_behind();
}

void Handling::raise() {
  if (phase_ == Phase::ToHome) move_to(kElbow, carried_at_);
  move_to(kShoulder, arm_->home[kShoulder]);
  left_behind();
}

void Handling::go_home(const std::array<Moved, 3>& order) {
  for (const Moved joint : order) {
    if (steps_to(joint, arm_->home[joint]) == 0) continue;
    move_to(joint, arm_->home[joint]);
    left_behind();
  }
}

/// The base's command that faces a direction, within its limits where that can be, and as it is written if it is.
double Handling::nearest_base(double azimuth) const {
  const auto& joint = arm_->chain.joints()[kBase];
  for (const double turn : {0, 360, -360}) {
    const double command = workcell_->plane().base(azimuth + turn);
    if (command >= joint.lowest && command <= joint.highest) return command;
  }
  return workcell_->plane().base(azimuth);
}

/// The base, so that the arm comes upon a place from the side where it is now.
void Handling::turn_near(const Workplace& at) {
  const double target = nearest_base(at.azimuth),
               reach = 2 * arm_->sphere.radius + (at.left - at.right) + workcell_->cell().clearance;
  const double before = std::ceil(workloads::arc_tangent(reach, at.out) / step_) * step_;
  turn_base(target + (clockwise(target) ? before : -before) * sense(), Until::Planned);
}

void Handling::face(const Workplace& at) {
  const double target = nearest_base(at.azimuth);
  if (steps_to(kBase, target) != 0) turn_base(target, Until::Facing);
}

/// What inverse kinematics has for the sphere upon the upper face, or the edge that is nearest.
PlanarArm::Commands Handling::commands_above(const Workplace& at) {
  const double r = arm_->sphere.radius, beside = std::max({0.0, at.right, -at.left});
  const auto commands =
      workcell_->plane().inverse({at.out, at.top + drop(at) + (beside < r ? std::sqrt(r * r - beside * beside) : 0)});
  if (!commands) fail(FailureCause::OutOfReach, "the upper face of the material is out of reach");
  return *commands;
}

/// The elbow as planned, the base if it does not face the place yet, then the shoulder, towards where inverse
/// kinematics has it, and on if need be.
void Handling::come_down(const Workplace& at) {
  const auto commands = commands_above(at);
  move_to(kElbow, commands.elbow);
  carried_at_ = angles_[kElbow];
  face(at);
  shoulder_down_ = commands.shoulder;
  go_down();
}

/// True if it rises by the clearance within a quarter of a turn, and has been lifted.
bool Handling::lift_by(Moved joint) {
  const double from = arm_->sphere_at(angles_).center.z(), clearance = workcell_->cell().clearance;
  kinematics::Angles tried = angles_;
  const auto rise = [&](double degrees) {
    tried[joint] = angles_[joint] + degrees;
    return arm_->sphere_at(tried).center.z() - from;
  };
  const long up = rise(step_) > rise(-step_) ? 1 : -1;
  long steps = 0;
  while (rise(static_cast<double>(steps) * step_) < clearance) {
    steps += up;
    if (std::abs(static_cast<double>(steps)) * step_ > 90) return false;
  }
  double low = static_cast<double>(steps - up) * step_, high = static_cast<double>(steps) * step_;
  for (int i = 0; i < 60; ++i) (rise((low + high) / 2) < clearance ? low : high) = (low + high) / 2;
  go(joint, Until::Cleared, steps, high);
  return true;
}

}  // namespace touchstone::cell
