// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/handling.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/thesis/cell/kinematics/layout.h"
#include "experiments/thesis/cell/simulation/triangle_distance.h"

namespace touchstone::cell {
namespace {

constexpr int kMostTries = 8;
constexpr int kMostDescents = 10'000;
constexpr double kRoundingOfHeight = 1e-13;  // of a height: what angles of that precision are off
constexpr double kLanded = 2e-12;            // of the arm's reach: what is let go is no further from what it lies on
constexpr double kSinksIn = 1e-9;    // of the arm's reach: so far the sphere sinks into what it comes straight down on
constexpr double kMostTurn = 10;     // degrees of a joint between two stops straight up or down
constexpr double kMostParts = 1000;  // of a way straight up or down: more are needed only where the joints jump
constexpr std::array kSharesOfClearance{1.0, 0.5, 0.25};  // of the clearance, above a place

/// Names the part of the open gripper that material at a pose in the flange's frame touches; empty if none does.
std::string met_by_gripper(const Workcell& workcell, const Pose& in_flange) {
  std::vector<NamedTriangle> gripper = workcell.gripper();
  for (const auto& finger : workcell.fingers()) gripper.insert(gripper.end(), finger.begin(), finger.end());
  constexpr double kTouch = std::numeric_limits<double>::min();
  const DistanceOfTrees met = distance(workcell.material_tree(), in_flange, TriangleTree(std::move(gripper)), kTouch);
  return met.lower < kTouch ? workcell.names()[met.other] : "";
}

}  // namespace

void Handling::come_upon(StationSlot slot, Approach approach) {
  const Workplace& at = workcell_->at(slot);
  target_ = slot;
  above_ = approach == Approach::Above || approach == Approach::AboveBaseFirst;
  if (above_) {
    if (approach == Approach::AboveBaseFirst) face(at);
    come_down(at);
    return;
  }
  const double target = nearest_base(at.facing), radius = arm_->sphere.radius;
  const double beside = clockwise(target) ? at.left + radius : at.right - radius;
  const double height = std::max(at.top - kinematics::below_upper_face(radius), (at.bottom + at.top) / 2);
  // There the centre is as far ahead as the place, and `beside` the plane that faces it.
  const double out = std::sqrt(at.out * at.out + beside * (2 * workcell_->plane().beside() + beside));
  const auto commands = workcell_->plane().inverse({out, height + drop(at)});
  if (!commands) fail(FailureCause::OutOfReach, "the side of the material is out of reach");
  if (std::abs(commands->shoulder - arm_->home[kShoulder]) >= step_ / 2 && approach == Approach::Side)
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

void Handling::find_to_above(StationSlot slot) {
  const Workplace& at = workcell_->at(slot);
  target_ = slot;
  above_ = true;
  kinematics::Angles over = angles_;
  over[kBase] = nearest_base(at.facing);
  std::string why = "no place above the material is within reach";
  for (const double share : kSharesOfClearance) {
    const auto commands = workcell_->plane().inverse({at.out, height_above(at) + share * workcell_->cell().clearance});
    if (!commands) continue;
    over[kShoulder] = commands->shoulder, over[kElbow] = commands->elbow;
    try {
      arm_->chain.require_reachable(over);
    } catch (const std::out_of_range& beyond) {
      why = beyond.what();
      continue;
    }
    find_to(over);
    return;
  }
  fail(FailureCause::OutOfReach, fmt::format("{}: {}", to_string(phase_), why));
}

void Handling::come_straight_down(StationSlot slot) {
  target_ = slot;
  const double touching = kSinksIn * workcell_->plane().furthest();
  const Ball from = arm_->sphere_at(angles_);
  double way = 0, gap = touching;
  for (int tries = 0; tries < kMostDescents && gap > 0 && way < from.center.z(); ++tries) {
    gap = found_in(slot)->gap({from.center - Eigen::Vector3d(0, 0, way), from.radius});
    way += std::max(gap, touching);
  }
  go_straight(Until::Contact, -way, angles_up(-way));
  if (!process.stops.back().touched)
    fail(FailureCause::NoContact, fmt::format("{} straight down: the sphere does not touch the material in the {}",
                                              to_string(phase_), to_string(slot)));
}

void Handling::go_straight_up(double share) {
  const double rise = share * workcell_->cell().clearance;
  go_straight(Until::Raised, rise, angles_up(rise));
  left_behind();
}

void Handling::grip() {
  const StationSlot slot = *state().slot;
  const Pose flange = arm_->link_poses(angles_).back();
  MaterialTransfer held{process.stops.size() - 1, std::nullopt, 0, 0, within(inverse(flange), state().lies->pose)};
  if (matter_ && workcell_->cell().gripper.fingers) {
    const auto closed = close_upon(*workcell_, *held.in_flange);
    if (const auto* why_not = std::get_if<std::string>(&closed))
      fail(FailureCause::NotHeld, fmt::format("{}: the gripper does not hold the material in the {}: {}",
                                              to_string(phase_), to_string(slot), *why_not));
    held.grip = std::get<Grip>(closed);
    require_free_fingers(*held.grip, "closes");
  }
  process.transfers.push_back(std::move(held));
  target_.reset();
}

/// Fails if a finger touches something that stands, on its way between open and closed.
void Handling::require_free_fingers(const Grip& grip, const char* what) {
  const Pose flange = arm_->link_poses(angles_).back();
  for (std::size_t i = 0; i < grip.fingers.size(); ++i) {
    const auto& fingers = *workcell_->cell().gripper.fingers;
    const StraightWay met =
        until_touch(TriangleTree(workcell_->fingers()[i]), flange, flange.rotation * fingers.shift(i, 1),
                    grip.fingers[i].way, workcell_->standing());
    ++process.queries;
    if (!met.touches) continue;
    const std::string finger = "gripper/" + fingers.parts[i].name, other = workcell_->names()[met.other];
    fail_at(fmt::format("{}: {} touches {} when it {}", to_string(phase_), finger, other, what), kBase, 0,
            {finger, other});
  }
}

/// The angles at stops straight up, or down, from where the hand is, a 100th of its reach apart or less. If the joints
/// turn alike between all stops, the way between two of them bends by less than half of its length.
std::vector<kinematics::Angles> Handling::angles_up(double rise) {
  const Eigen::Vector3d from = arm_->sphere_at(angles_).center;
  const double out = std::sqrt(from.x() * from.x() + from.y() * from.y());
  const double reach = workcell_->plane().furthest();
  double parts = std::abs(rise) / (reach / 100);
  if (const auto end = workcell_->plane().inverse({out, from.z() + rise}); end && rise != 0) {
    const double turned = (std::abs(end->shoulder - angles_[kShoulder]) + std::abs(end->elbow - angles_[kElbow])) *
                          (std::numbers::pi / 180);
    parts = std::max(parts, 4 * reach * turned * turned / std::abs(rise));
  }
  const auto count = static_cast<int>(std::ceil(std::min(parts, kMostParts)));
  std::vector<kinematics::Angles> all;
  for (int i = 1; i <= count; ++i) {
    const auto commands = workcell_->plane().inverse({out, from.z() + rise * i / count});
    kinematics::Angles next = all.empty() ? angles_ : all.back();
    const bool near = commands && std::abs(commands->shoulder - next[kShoulder]) < kMostTurn &&
                      std::abs(commands->elbow - next[kElbow]) < kMostTurn;
    const char* const where = rise < 0 ? "down" : "up";
    if (!near)
      fail(FailureCause::OutOfReach, fmt::format("{}: the arm cannot go straight {}", to_string(phase_), where));
    next[kShoulder] = commands->shoulder, next[kElbow] = commands->elbow;
    try {
      arm_->chain.require_reachable(next);
    } catch (const std::out_of_range& beyond) {
      fail(FailureCause::JointLimit, fmt::format("{} straight {}: {}", to_string(phase_), where, beyond.what()));
    }
    all.push_back(next);
  }
  return all;
}

/// Lowers what is held straight down until it touches what is below it.
Landing Handling::land() {
  if (!workcell_->plane().keeps_level())
    fail(FailureCause::Misplaced,
         fmt::format("{}: the hand does not stay level, so that it cannot lower the material straight down",
                     to_string(phase_)));
  const auto held_at = [&](const kinematics::Angles& angles) {
    return within(arm_->link_poses(angles).back(), *state().in_flange);
  };
  const Pose from = held_at(angles_);
  const touchstone::Box material = workcell_->material_tree().whole();
  const double most = from.translation.z() + (material.high - material.low).norm();
  const StraightWay down =
      until_touch(workcell_->material_tree(), from, -Eigen::Vector3d::UnitZ(), most, workcell_->standing());
  // Angles are rounded: where the hand ends it is measured again, and stays a little higher if need be.
  double way = down.way;
  for (int tries = 0; tries < kMostTries; ++tries) {
    const auto angles = angles_up(-way);
    const Pose there = angles.empty() ? from : held_at(angles.back());
    const DistanceOfTrees left = distance(workcell_->material_tree(), there, workcell_->standing(), most);
    process.queries += 2;
    if (left.lower > 0 || angles.empty()) {
      if (left.upper > kLanded * workcell_->plane().furthest())
        fail(FailureCause::Misplaced,
             fmt::format("{}: on its way down the material slides along {}, too closely to land", to_string(phase_),
                         workcell_->names()[left.other]));
      if (!angles.empty()) go_straight(Until::Landed, -way, angles);
      return {way, left.upper, workcell_->names()[left.other]};
    }
    way -= left.upper + kRoundingOfHeight * most;
  }
  fail(FailureCause::OutOfReach,
       fmt::format("{}: the arm's angles are too coarse to put the material down", to_string(phase_)));
}

void Handling::release(StationSlot slot) {
  const Pose& place = workcell_->at(slot).material->pose;
  const auto put = [&](const Lying& lies, const Pose& held, const std::optional<Landing>& landing) {
    process.transfers.push_back({process.stops.size() - 1,
                                 slot,
                                 (place.translation - held.translation).norm(),
                                 turn_between(held, place),
                                 {},
                                 lies,
                                 {},
                                 landing});
    leaving_ = true;
  };
  if (!matter_) {
    put(workcell_->at(slot).material, within(arm_->link_poses(angles_).back(), *state().in_flange), {});
    return;
  }
  begin(slot == StationSlot::Machine ? Phase::Withdraw : Phase::ToHome);
  const std::size_t first = process.stops.size() - 1;
  const Landing landing = land();
  const Pose flange = arm_->link_poses(angles_).back(), held = within(flange, *state().in_flange);
  const auto& tolerance = workcell_->cell().material.tolerance;
  const double shift = (place.translation - held.translation).norm(), turn = turn_between(held, place);
  if (tolerance && (shift > tolerance->distance || turn > tolerance->degrees))
    fail(FailureCause::Misplaced,
         fmt::format("{}: the material would be let go {:.1f} {} and {:.1f} degrees from its place in the {}, which is "
                     "more than {:g} and {:g}",
                     to_string(phase_), shift, workcell_->cell().unit.name, turn, to_string(slot), tolerance->distance,
                     tolerance->degrees));
  if (state().grip) require_free_fingers(*state().grip, "opens");
  if (const std::string met = met_by_gripper(*workcell_, *state().in_flange); !met.empty())
    fail_at(fmt::format("{}: once the material lies in the {}, {} touches it", to_string(phase_), to_string(slot), met),
            kBase, 0, {met, "material"});
  put(workcell_->lay(held), held, landing);
  std::vector<kinematics::Angles> back;
  for (std::size_t i = process.stops.size() - 1; i-- > first;) back.push_back(process.stops[i].commanded);
  if (!back.empty()) go_straight(Until::Raised, landing.way, back);
}

void Handling::lift(Moved joint) {
  if (!lift_by(joint))
    fail(FailureCause::OutOfReach, fmt::format("{} {}: no lift within a quarter of a turn clears the material",
                                               to_string(phase_), arm_->chain.joints()[joint].name));
  left_behind();
}

void Handling::raise() {
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
double Handling::nearest_base(double direction) const {
  const auto& joint = arm_->chain.joints()[kBase];
  for (const double turn : {0, 360, -360}) {
    const double command = workcell_->plane().base(direction + turn);
    if (command >= joint.lowest && command <= joint.highest) return command;
  }
  return workcell_->plane().base(direction);
}

void Handling::face(const Workplace& at) {
  const double target = nearest_base(at.facing);
  if (steps_to(kBase, target) != 0) turn_base(target, Until::Facing);
}

/// The height of the sphere upon the upper face, or the edge that is nearest.
double Handling::height_above(const Workplace& at) const {
  const double r = arm_->sphere.radius, beside = std::max({0.0, at.right, -at.left});
  return at.top + drop(at) + (beside < r ? std::sqrt(r * r - beside * beside) : 0);
}

/// What inverse kinematics has for that.
PlanarArm::Commands Handling::commands_above(const Workplace& at) {
  const auto commands = workcell_->plane().inverse({at.out, height_above(at)});
  if (!commands) fail(FailureCause::OutOfReach, "the upper face of the material is out of reach");
  return *commands;
}

/// The elbow as planned, the base if it does not face the place yet, then the shoulder, towards where inverse
/// kinematics has it, and on if need be.
void Handling::come_down(const Workplace& at) {
  const auto commands = commands_above(at);
  move_to(kElbow, commands.elbow);
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
