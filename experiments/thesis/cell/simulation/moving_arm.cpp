// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/moving_arm.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "experiments/thesis/cell/simulation/sweep.h"

namespace touchstone::cell {
namespace {

std::size_t index(StationSlot slot, bool virtual_copy) {
  return 2 * static_cast<std::size_t>(slot) + (virtual_copy ? 1 : 0);
}

}  // namespace

Driver::Driver(const Workcell& workcell, const cases::Method& method) {
  for (const StationSlot slot : {StationSlot::Storage, StationSlot::Machine})
    for (const bool copy : {false, true}) {
      const scene::Faces& faces = copy ? workcell.at(slot).virtual_faces : workcell.at(slot).faces;
      for (const Polygon& face : polygons_of(faces)) faces_[index(slot, copy)].push_back(method.prepare(face));
    }
}

std::optional<std::size_t> Driver::touched(const Ball& ball, StationSlot slot, bool virtual_copy) const {
  const auto& faces = faces_[index(slot, virtual_copy)];
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (faces[i]->ask(ball, cases::QueryKind::Contact).contact.value_or(false)) return i;
  return std::nullopt;
}

MovingArm::MovingArm(const Workcell& workcell, const Sweep* sweep, const Driver* driver)
    : workcell_(&workcell),
      sweep_(sweep),
      driver_(driver),
      arm_(&workcell.arm()),
      step_(workcell.cell().step),
      angles_(workcell.arm().home),
      turned_(angles_.size(), 0) {
  process.transfers.push_back({0, StationSlot::Storage, 0, 0, {}});
}

void MovingArm::start() {
  const auto objects = workcell_->in_the_way(obstacle(), false);
  const Ball sphere = arm_->sphere_at(angles_);
  const scene::Scene& scene = workcell_->scene();
  std::optional<Hindrance> found;
  if (scene.touches(sphere, objects)) {
    const std::string met = scene.name(scene.touched(sphere, objects).front().object);
    found = {0, "the sphere touches " + met, {met}};
  }
  if (!found && sweep_ != nullptr) found = overlap_of_things(*workcell_);
  if (!found && sweep_ != nullptr) found = sweep_->at_rest(angles_, load(), process.queries);
  if (found) fail_at("at home " + found->what, kBase, 0, found->parts);
  stop();
}

bool MovingArm::went_further_than(const MovingArm& other) const {
  return std::pair(process.moves.size(), process.stops.size()) >
         std::pair(other.process.moves.size(), other.process.stops.size());
}

bool MovingArm::was_misled() const {
  return std::ranges::any_of(process.moves, [](const Move& move) { return move.wrong.has_value(); });
}

void MovingArm::fail(FailureCause cause, const std::string& reason) {
  process.stuck = {reason, angles_, {}};
  throw SimulationFailure(cause, reason);
}

void MovingArm::fail_at(const std::string& reason, Moved joint, double degrees, std::vector<std::string> parts) {
  process.stuck = {reason, angles_, std::move(parts)};
  process.stuck->commanded[joint] += degrees;
  throw SimulationFailure(FailureCause::InTheWay, reason);
}

const scene::Faces& MovingArm::faces_of(StationSlot slot) const {
  return is_virtual(slot) ? workcell_->at(slot).virtual_faces : workcell_->at(slot).faces;
}

long MovingArm::steps_to(Moved joint, double command) const { return std::lround((command - angles_[joint]) / step_); }

void MovingArm::turn_base(double command, Until until) {
  go(kBase, until, steps_to(kBase, command), command - angles_[kBase]);
}

void MovingArm::move_to(Moved joint, double command) {
  if (steps_to(joint, command) != 0) go(joint, Until::Planned, steps_to(joint, command), command - angles_[joint]);
}

std::string MovingArm::what(Moved joint, double degrees) const {
  return fmt::format("{} {} {:+g}", to_string(phase_), arm_->chain.joints()[joint].name, degrees);
}

kinematics::Arc MovingArm::arc(Moved joint, double degrees) {
  try {
    return arm_->chain.arc(angles_, joint, degrees, arm_->sphere.center);
  } catch (const std::out_of_range& beyond) {
    fail(FailureCause::JointLimit, fmt::format("{}: {}", what(joint, degrees), beyond.what()));
  }
}

/// The material that is in the way of the arm: not what it comes upon or leaves.
Workcell::Material MovingArm::obstacle() const {
  const auto slot = process.transfers.back().slot;
  return slot == target_ ? std::nullopt : slot;
}

Sweep::Load MovingArm::load() const {
  const MaterialTransfer& last = process.transfers.back();
  return {last.in_flange, last.slot};
}

void MovingArm::require_free_arc(Moved joint, double degrees, Workcell::Material material) {
  const kinematics::Arc way = arc(joint, degrees);
  const double radius = arm_->sphere.radius;
  const auto require_none = [&](const auto& contact, const auto& name_of) {
    if (!contact) return;
    const std::string name = name_of(contact->face);
    fail_at(fmt::format("{}: after {:.2f} degrees the sphere touches {}", what(joint, degrees), contact->high, name),
            joint, std::copysign(contact->high, degrees), {name});
  };
  require_none(kinematics::first_contact(way, radius, workcell_->obstacles().faces),
               [&](std::size_t face) { return workcell_->obstacles().owners[face]; });
  if (material)
    require_none(kinematics::first_contact(way, radius, faces_of(*material)),
                 [&](std::size_t) { return fmt::format("the material in the {}", to_string(*material)); });
}

/// Records the arm as it is. True if the sphere touches the target.
bool MovingArm::stop() {
  ++process.queries;
  const Ball sphere = arm_->sphere_at(angles_);
  const auto touched = believed(sphere);
  process.stops.push_back({process.moves.size(), angles_, sphere, target_, touched});
  return touched.has_value();
}

/// Stops up to where the arm, the gripper or what it holds would touch something, if they do, and says so.
void MovingArm::require_free_matter(Moved joint, long steps) {
  if (sweep_ == nullptr) return;
  const auto hindrance = sweep_->along(angles_, joint, degrees(steps), load(), process.queries);
  if (!hindrance) return;
  const long from = turned_[joint], sign = steps < 0 ? -1 : 1;
  long whole = 0;
  for (long i = 1; static_cast<double>(i) * step_ <= hindrance->degrees; ++i) {
    turn(joint, from, sign * i);
    stop();
    whole = i;
  }
  fail_at(fmt::format("{}: after {:.2f} degrees {}", what(joint, degrees(steps)), hindrance->degrees, hindrance->what),
          joint, static_cast<double>(sign) * (hindrance->degrees - degrees(whole)), hindrance->parts);
}

/// Turns the joint to `steps` from where it was: angles do not add up roundings.
void MovingArm::turn(Moved joint, long from, long steps) {
  turned_[joint] = from + steps;
  angles_[joint] = arm_->home[joint] + static_cast<double>(turned_[joint]) * step_;
}

void MovingArm::go(Moved joint, Until until, long steps, double exact) {
  require_free_arc(joint, degrees(steps), leaving_ ? obstacle() : target_ ? target_ : obstacle());
  require_free_matter(joint, steps);
  const long from = turned_[joint], sign = steps < 0 ? -1 : 1;
  for (long i = sign; i != steps + sign; i += sign) {
    turn(joint, from, i);
    stop();
  }
  const double left = std::abs(exact - degrees(steps));
  const double margin = until == Until::Cleared ? std::min(left, step_ - left) : step_ / 2 - left;
  process.moves.push_back({phase_, joint, until, degrees(steps), exact, margin, {}, {}});
}

/// What the sphere touches of its target, by whom the robot believes.
std::optional<std::size_t> MovingArm::believed(const Ball& sphere) const {
  if (!target_) return std::nullopt;
  return driver_ != nullptr ? driver_->touched(sphere, *target_, is_virtual(*target_))
                            : workcell_->touched(sphere, *target_, is_virtual(*target_));
}

/// Returns how many of the given steps the driving method lets the joint move.
long MovingArm::driven_steps(Moved joint, long most) {
  kinematics::Angles tried = angles_;
  for (long i = 0; i != most;) {
    i += most < 0 ? -1 : 1;
    tried[joint] = arm_->home[joint] + degrees(turned_[joint] + i);
    if (believed(arm_->sphere_at(tried))) return i;
  }
  fail(FailureCause::NoContact,
       fmt::format("{}: the method that drives says contact with the material in the {} nowhere",
                   what(joint, degrees(most)), to_string(*target_)));
}

void MovingArm::move_until_contact(Moved joint, bool up) {
  const double room = std::min(180.0, arm_->chain.room(angles_, joint, up));
  move_until_contact(joint, (up ? 1 : -1) * static_cast<long>(room / step_));
}

void MovingArm::move_until_contact(Moved joint, long most) {
  const auto contact = kinematics::first_contact(arc(joint, degrees(most)), arm_->sphere.radius, faces_of(*target_));
  if (!contact && driver_ == nullptr)
    fail(FailureCause::NoContact, fmt::format("{}: the sphere does not touch the material in the {}",
                                              what(joint, degrees(most)), to_string(*target_)));
  const long sign = most < 0 ? -1 : 1;
  const long right = contact ? sign * static_cast<long>(std::ceil(contact->high / step_)) : 0;
  const long steps = driver_ != nullptr ? driven_steps(joint, most) : right;
  require_free_arc(joint, degrees(steps), obstacle());
  require_free_matter(joint, steps);
  const long from = turned_[joint];
  bool touches = false;
  for (long i = 0; i != steps && !touches;) {
    i += sign;
    turn(joint, from, i);
    touches = stop();
  }
  if (!touches)
    fail(FailureCause::NoContact, fmt::format("{}: steps of {:g} degrees pass over the contact at {:.2f}",
                                              what(joint, degrees(steps)), step_, contact->high));
  std::optional<WrongStop> wrong;
  if (steps != right) {
    wrong = {{}, workcell_->gap(process.stops.back().sphere, *target_, is_virtual(*target_))};
    if (contact) wrong->early = std::abs(degrees(right)) - std::abs(degrees(steps));
  }
  const double exact = contact ? contact->low : std::abs(degrees(steps)), left = std::abs(degrees(steps)) - exact;
  process.moves.push_back({phase_, joint, Until::Contact, degrees(steps), std::copysign(exact, most),
                           std::min(left, step_ - left), contact, wrong});
}

void MovingArm::left_behind() {
  target_.reset();
  leaving_ = false;
}

}  // namespace touchstone::cell
