// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/moving_arm.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "experiments/thesis/cell/simulation/overlap.h"
#include "experiments/thesis/cell/simulation/sweep.h"
#include "experiments/thesis/cell/simulation/way.h"

namespace touchstone::cell {

std::optional<std::size_t> Driver::touched(const Ball& ball, const Lying& material) const {
  auto& faces = faces_[material];
  if (faces.empty())
    for (const Polygon& face : polygons_of(material->faces)) faces.push_back(method_.prepare(face));
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (faces[i]->ask(ball, cases::QueryKind::Contact).contact.value_or(false)) return i;
  return std::nullopt;
}

MovingArm::MovingArm(const Workcell& workcell, const Sweep& sweep, const Driver* driver)
    : workcell_(&workcell),
      sweep_(&sweep),
      matter_(!sweep.sphere_alone()),
      driver_(driver),
      arm_(&workcell.arm()),
      step_(workcell.cell().step),
      angles_(workcell.arm().home),
      counted_from_(angles_),
      turned_(angles_.size(), 0) {
  process.transfers.push_back({0, StationSlot::Storage, 0, 0, {}, workcell.at(StationSlot::Storage).material});
}

void MovingArm::start() {
  const Ball sphere = arm_->sphere_at(angles_);
  std::optional<Hindrance> found;
  std::string met;
  if (const auto touched = workcell_->scene().touched(sphere); !touched.empty())
    met = workcell_->scene().name(touched.front().object);
  else if (state().lies->touched(sphere))
    met = "the material in the storage";
  if (!met.empty()) found = {0, "the sphere touches " + met, {met}};
  if (!found && matter_) found = overlap_of_things(*workcell_);
  if (!found && matter_) found = sweep_->at_rest(angles_, state(), process.queries);
  if (!found && matter_) found = nested_at_home(*workcell_);
  if (found) fail_at("at home " + found->what, kBase, 0, found->parts);
  stop();
}

bool MovingArm::went_further_than(const MovingArm& other) const {
  const auto reached = [](const MovingArm& arm) {
    return std::tuple(arm.process.transfers.size(), arm.phase_, arm.process.moves.size(), arm.process.stops.size());
  };
  return reached(*this) > reached(other);
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

/// Whether the material is in the way of the sphere: not what it comes upon or leaves.
bool MovingArm::is_obstacle() const { return state().slot && state().slot != target_; }

/// What else the sphere must not touch on a whole move: not even what it comes for, virtual or not.
Lying MovingArm::kept_from() const {
  if (target_ && !leaving_) return found_in(*target_);
  return is_obstacle() ? state().lies : nullptr;
}

void MovingArm::require_free_arc(Moved joint, double degrees, const Lying& material) {
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
    require_none(kinematics::first_contact(way, radius, material->faces), [&](std::size_t) {
      return fmt::format("the material in the {}",
                         to_string(target_ && is_virtual(*target_) ? *target_ : *state().slot));
    });
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
  if (!matter_) return;
  const auto hindrance = sweep_->along(angles_, joint, degrees(steps), state(), process.queries);
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
  angles_[joint] = counted_from_[joint] + static_cast<double>(turned_[joint]) * step_;
}

void MovingArm::go(Moved joint, Until until, long steps, double exact) {
  require_free_arc(joint, degrees(steps), kept_from());
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
  const Lying& found = found_in(*target_);
  return driver_ != nullptr ? driver_->touched(sphere, found) : found->touched(sphere);
}

/// Returns how many of the given steps the driving method lets the joint move.
long MovingArm::driven_steps(Moved joint, long most) {
  kinematics::Angles tried = angles_;
  for (long i = 0; i != most;) {
    i += most < 0 ? -1 : 1;
    tried[joint] = counted_from_[joint] + degrees(turned_[joint] + i);
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
  const auto contact =
      kinematics::first_contact(arc(joint, degrees(most)), arm_->sphere.radius, found_in(*target_)->faces);
  if (!contact && driver_ == nullptr)
    fail(FailureCause::NoContact, fmt::format("{}: the sphere does not touch the material in the {}",
                                              what(joint, degrees(most)), to_string(*target_)));
  const long sign = most < 0 ? -1 : 1;
  const long right = contact ? sign * static_cast<long>(std::ceil(contact->high / step_)) : 0;
  const long steps = driver_ != nullptr ? driven_steps(joint, most) : right;
  require_free_arc(joint, degrees(steps), is_obstacle() ? state().lies : nullptr);
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
    wrong = {{}, found_in(*target_)->gap(process.stops.back().sphere)};
    if (contact) wrong->early = std::abs(degrees(right)) - std::abs(degrees(steps));
  }
  const double exact = contact ? contact->low : std::abs(degrees(steps)), left = std::abs(degrees(steps)) - exact;
  process.moves.push_back({phase_, joint, Until::Contact, degrees(steps), std::copysign(exact, most),
                           std::min(left, step_ - left), contact, wrong});
}

void MovingArm::go_straight(Until until, double rise, const std::vector<kinematics::Angles>& way) {
  const Lying other = is_obstacle() ? state().lies : nullptr;
  for (const kinematics::Angles& next : way) {
    if (const auto met =
            sweep_->along(angles_, step_between(angles_, next), state(), process.queries, {true, false, other.get()}))
      fail_at(fmt::format("{} straight {}: {}", to_string(phase_), rise < 0 ? "down" : "up", met->what), kBase, 0,
              met->parts);
    angles_ = next;
    stop();
  }
  process.moves.push_back({phase_, kShoulder, until, 0, 0, 0, {}, {}, rise});
}

void MovingArm::find_to(const kinematics::Angles& to) {
  const Lying other = kept_from();
  const auto test = [&](const kinematics::Angles& from, const kinematics::Angles& end) {
    return sweep_->is_clear(from, step_between(from, end), state(), process.queries, {false, false, other.get()});
  };
  const Way way = find_way(*workcell_, angles_, to, test);
  for (const kinematics::Angles& end : way.ends) {
    const Step step = step_between(angles_, end);
    std::optional<Hindrance> met;
    if (!way.found && &end == &way.ends.back())
      met = sweep_->along(angles_, step, state(), process.queries, {false, false, other.get()});
    const double whole = met ? met->degrees : std::abs(step.degrees);
    const kinematics::Angles from = angles_;
    for (long i = 1; static_cast<double>(i) * step_ < whole; ++i) {
      angles_ = step.after(from, static_cast<double>(i) * step_);
      stop();
    }
    if (met) {
      angles_ = step.after(from, whole);
      fail_at(fmt::format("{} {} {:+.2f} with the other joints: after {:.2f} degrees {}", to_string(phase_),
                          arm_->chain.joints()[step.joint].name, step.degrees, met->degrees, met->what),
              kBase, 0, met->parts);
    }
    angles_ = end;
    if (step.degrees == 0) continue;
    stop();
    process.moves.push_back({phase_, step.joint, Until::Through, step.degrees, step.degrees, 0, {}, {}});
  }
  in_order_ = false;
  counted_from_ = angles_;
  turned_.assign(angles_.size(), 0);
}

void MovingArm::left_behind() {
  target_.reset();
  leaving_ = false;
}

}  // namespace touchstone::cell
