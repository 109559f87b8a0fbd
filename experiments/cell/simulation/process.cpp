// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/simulation/process.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/cell/kinematics/layout.h"
#include "experiments/cell/simulation/driver.h"
#include "experiments/cell/simulation/hold.h"
#include "experiments/workloads/degrees.h"

namespace touchstone::cell {
namespace {

using kinematics::Approach;
using kinematics::SimulationFailure;

enum class Order { ElbowFirst, BaseFirst };

class ProcessSimulation {
 public:
  /// Without a sweep the sphere alone is tested; without a driver the exact answer says when it touches.
  ProcessSimulation(const Workcell& workcell, const Sweep* sweep, const Driver* driver)
      : workcell_(&workcell),
        sweep_(sweep),
        driver_(driver),
        arm_(&workcell.arm()),
        step_(workcell.cell().step),
        angles_(workcell.arm().home),
        turned_(angles_.size(), 0) {
    process.transfers.push_back({0, StationSlot::Storage, 0, 0, {}});
  }

  void start() {
    const auto objects = workcell_->in_the_way(obstacle(), false);
    const Ball sphere = arm_->sphere_at(angles_);
    const scene::Scene& scene = workcell_->scene();
    std::string fault;
    if (scene.touches(sphere, objects))
      fault = "the sphere touches " + scene.name(scene.touched(sphere, objects).front().object);
    if (fault.empty() && sweep_ != nullptr) fault = workcell_->overlap_of_stations();
    if (fault.empty() && sweep_ != nullptr) fault = sweep_->at_rest(angles_, load(), process.queries);
    if (!fault.empty()) throw SimulationFailure(FailureCause::InTheWay, "at home " + fault);
    stop();
  }

  void begin(Phase phase) { phase_ = phase; }

  /// Until the sphere touches the material there, or its virtual copy.
  void come_upon(StationSlot slot, Approach approach, Order order) {
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
    if (!commands) throw SimulationFailure(FailureCause::OutOfReach, "the side of the material is out of reach");
    if (std::abs(commands->shoulder - arm_->home[kShoulder]) >= step_ / 2 && approach == Approach::SideWithoutShoulder)
      throw SimulationFailure(FailureCause::OutOfReach, "the shoulder would have to move");
    move_to(kShoulder, commands->shoulder);
    move_to(kElbow, commands->elbow);
    move_until_contact(kBase, steps_to(kBase, target));
  }

  /// By one joint, until the sphere has risen by the clearance.
  void lift(Moved joint) {
    if (!lift_by(joint))
      throw SimulationFailure(FailureCause::OutOfReach,
                              fmt::format("{} {}: no lift within a quarter of a turn clears the material",
                                          to_string(phase_), arm_->chain.joints()[joint].name));
    left_behind();
  }
  /// Up to the height at which the material was carried to the machine: the shoulder as at home, the elbow as there.
  void raise() {
    if (phase_ == Phase::ToHome) move_to(kElbow, carried_at_);
    move_to(kShoulder, arm_->home[kShoulder]);
    left_behind();
  }
  [[nodiscard]] bool is_above() const { return above_; }

  /// Onto the material there, or its virtual copy, by the elbow, once the base faces it and the shoulder is as planned.
  void come_down_by_elbow(StationSlot slot) {
    const Workplace& at = workcell_->at(slot);
    target_ = slot;
    above_ = true;
    const auto commands = commands_above(at);
    face(at);
    move_to(kShoulder, commands.shoulder);
    const bool up = commands.elbow > angles_[kElbow];
    const double room = std::min(180.0, arm_->chain.room(angles_, kElbow, up));
    move_until_contact(kElbow, (up ? 1 : -1) * static_cast<long>(room / step_));
  }

  void grip() {
    const StationSlot slot = *process.transfers.back().slot;
    const Pose flange = arm_->link_poses(angles_).back();
    const Pose held = within(inverse(flange), workcell_->at(slot).pose);
    if (sweep_ != nullptr)
      if (const std::string loose = why_not_held(*workcell_, held); !loose.empty())
        throw SimulationFailure(FailureCause::NotHeld,
                                fmt::format("{}: the gripper does not hold the material in the {}: {}",
                                            to_string(phase_), to_string(slot), loose));
    process.transfers.push_back({process.stops.size() - 1, std::nullopt, 0, 0, held});
    target_.reset();
  }
  void release(StationSlot slot) {
    const Pose flange = arm_->link_poses(angles_).back(), &place = workcell_->at(slot).pose;
    const Pose held = within(flange, *process.transfers.back().in_flange);
    const double shift = (place.translation - held.translation).norm(), turn = turn_between(held, place);
    const auto& tolerance = workcell_->cell().material.tolerance;
    if (sweep_ != nullptr && tolerance && (shift > tolerance->distance || turn > tolerance->degrees))
      throw SimulationFailure(
          FailureCause::Misplaced,
          fmt::format(
              "{}: the material would be let go {:.1f} {} and {:.1f} degrees from its place in the {}, which is "
              "more than {:g} and {:g}",
              to_string(phase_), shift, workcell_->cell().unit.name, turn, to_string(slot), tolerance->distance,
              tolerance->degrees));
    if (sweep_ != nullptr)
      if (const std::string met = met_by_gripper(*workcell_, within(inverse(flange), place)); !met.empty())
        throw SimulationFailure(FailureCause::InTheWay,
                                fmt::format("{}: once the material lies in the {}, {} touches it", to_string(phase_),
                                            to_string(slot), met));
    process.transfers.push_back({process.stops.size() - 1, slot, shift, turn, {}});
    leaving_ = true;
  }

  /// The joints in that order.
  void go_home(const std::array<Moved, 3>& order) {
    for (const Moved joint : order) {
      if (steps_to(joint, arm_->home[joint]) == 0) continue;
      move_to(joint, arm_->home[joint]);
      left_behind();
    }
  }
  void come_down_again() {
    target_ = StationSlot::Machine;
    go_down();
  }

  [[nodiscard]] bool went_further_than(const ProcessSimulation& other) const {
    return std::pair(process.moves.size(), process.stops.size()) >
           std::pair(other.process.moves.size(), other.process.stops.size());
  }
  [[nodiscard]] bool was_misled() const {
    return std::ranges::any_of(process.moves, [](const Move& move) { return move.wrong.has_value(); });
  }

  Process process;

 private:
  [[nodiscard]] double sense() const { return workcell_->plane().base(1) - workcell_->plane().base(0); }
  [[nodiscard]] bool clockwise(double target) const { return (target - angles_[kBase]) * sense() < 0; }

  /// Whether the sphere would find the virtual material in a slot, not the material itself.
  [[nodiscard]] bool is_virtual(StationSlot slot) const { return process.transfers.back().slot != slot; }
  [[nodiscard]] const scene::Faces& faces_of(StationSlot slot) const {
    return is_virtual(slot) ? workcell_->at(slot).virtual_faces : workcell_->at(slot).faces;
  }
  [[nodiscard]] double drop(const Workplace& at) const { return is_virtual(*target_) ? at.drop : 0; }

  /// The base's command that faces a direction, within its limits where that can be, and as it is written if it is.
  [[nodiscard]] double nearest_base(double azimuth) const {
    const auto& joint = arm_->chain.joints()[kBase];
    for (const double turn : {0, 360, -360}) {
      const double command = workcell_->plane().base(azimuth + turn);
      if (command >= joint.lowest && command <= joint.highest) return command;
    }
    return workcell_->plane().base(azimuth);
  }

  [[nodiscard]] long steps_to(Moved joint, double command) const {
    return std::lround((command - angles_[joint]) / step_);
  }

  void turn_base(double command, Until until) { go(kBase, until, steps_to(kBase, command), command - angles_[kBase]); }
  void move_to(Moved joint, double command) {
    if (steps_to(joint, command) != 0) go(joint, Until::Planned, steps_to(joint, command), command - angles_[joint]);
  }

  /// The base, so that the arm comes upon a place from the side where it is now.
  void turn_near(const Workplace& at) {
    const double target = nearest_base(at.azimuth),
                 reach = 2 * arm_->sphere.radius + (at.left - at.right) + workcell_->cell().clearance;
    const double before = std::ceil(workloads::arc_tangent(reach, at.out) / step_) * step_;
    turn_base(target + (clockwise(target) ? before : -before) * sense(), Until::Planned);
  }

  void face(const Workplace& at) {
    const double target = nearest_base(at.azimuth);
    if (steps_to(kBase, target) != 0) turn_base(target, Until::Facing);
  }

  /// What inverse kinematics has for the sphere upon the upper face, or the edge that is nearest.
  [[nodiscard]] PlanarArm::Commands commands_above(const Workplace& at) const {
    const double r = arm_->sphere.radius, beside = std::max({0.0, at.right, -at.left});
    const auto commands =
        workcell_->plane().inverse({at.out, at.top + drop(at) + (beside < r ? std::sqrt(r * r - beside * beside) : 0)});
    if (!commands) throw SimulationFailure(FailureCause::OutOfReach, "the upper face of the material is out of reach");
    return *commands;
  }

  /// The elbow as planned, the base if it does not face the place yet, then the shoulder.
  void come_down(const Workplace& at) {
    const auto commands = commands_above(at);
    move_to(kElbow, commands.elbow);
    carried_at_ = angles_[kElbow];
    face(at);
    shoulder_down_ = commands.shoulder;
    go_down();
  }

  /// True if it rises by the clearance within a quarter of a turn, and has been lifted.
  bool lift_by(Moved joint) {
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

  /// The shoulder, towards where inverse kinematics has it for the last place, and on if need be.
  void go_down() {
    const bool up = shoulder_down_ > angles_[kShoulder];
    const double room = std::min(180.0, arm_->chain.room(angles_, kShoulder, up));
    move_until_contact(kShoulder, (up ? 1 : -1) * static_cast<long>(room / step_));
  }

  [[nodiscard]] std::string what(Moved joint, double degrees) const {
    return fmt::format("{} {} {:+g}", to_string(phase_), arm_->chain.joints()[joint].name, degrees);
  }

  [[nodiscard]] kinematics::Arc arc(Moved joint, double degrees) const {
    try {
      return arm_->chain.arc(angles_, joint, degrees, arm_->sphere.center);
    } catch (const std::out_of_range& beyond) {
      throw SimulationFailure(FailureCause::JointLimit, fmt::format("{}: {}", what(joint, degrees), beyond.what()));
    }
  }

  /// The material that is in the way of the arm: not what it comes upon or leaves.
  [[nodiscard]] Workcell::Material obstacle() const {
    const auto slot = process.transfers.back().slot;
    return slot == target_ ? std::nullopt : slot;
  }

  void require_free_arc(Moved joint, double degrees, std::optional<StationSlot> material) const {
    const kinematics::Arc way = arc(joint, degrees);
    const double radius = arm_->sphere.radius;
    if (const auto contact = kinematics::first_contact(way, radius, workcell_->obstacles().faces))
      throw SimulationFailure(FailureCause::InTheWay,
                              fmt::format("{}: after {:.2f} degrees the sphere touches {}", what(joint, degrees),
                                          contact->high, workcell_->obstacles().owners[contact->face]));
    if (!material) return;
    if (const auto contact = kinematics::first_contact(way, radius, faces_of(*material)))
      throw SimulationFailure(FailureCause::InTheWay,
                              fmt::format("{}: after {:.2f} degrees the sphere touches the material in the {}",
                                          what(joint, degrees), contact->high, to_string(*material)));
  }

  /// Records the arm as it is. True if the sphere touches the target.
  bool stop() {
    ++process.queries;
    const Ball sphere = arm_->sphere_at(angles_);
    const auto touched = believed(sphere);
    process.stops.push_back({process.moves.size(), angles_, sphere, target_, touched});
    return touched.has_value();
  }

  [[nodiscard]] Sweep::Load load() const {
    const MaterialTransfer& last = process.transfers.back();
    return {last.in_flange, last.slot};
  }

  /// Stops up to where the arm, the gripper or what it holds would touch something, if they do, and says so.
  void require_free_matter(Moved joint, long steps) {
    if (sweep_ == nullptr) return;
    const auto hindrance = sweep_->along(angles_, joint, degrees(steps), load(), process.queries);
    if (!hindrance) return;
    const long from = turned_[joint], sign = steps < 0 ? -1 : 1;
    for (long i = 1; static_cast<double>(i) * step_ <= hindrance->degrees; ++i) {
      turn(joint, from, sign * i);
      stop();
    }
    throw SimulationFailure(
        FailureCause::InTheWay,
        fmt::format("{}: after {:.2f} degrees {}", what(joint, degrees(steps)), hindrance->degrees, hindrance->what));
  }

  /// So many steps from where the joint was: angles do not add up roundings.
  void turn(Moved joint, long from, long steps) {
    turned_[joint] = from + steps;
    angles_[joint] = arm_->home[joint] + static_cast<double>(turned_[joint]) * step_;
  }
  [[nodiscard]] double degrees(long steps) const { return static_cast<double>(steps) * step_; }

  /// A whole move, which meets nothing: not even what it comes for, virtual or not.
  void go(Moved joint, Until until, long steps, double exact) {
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
  [[nodiscard]] std::optional<std::size_t> believed(const Ball& sphere) const {
    if (!target_) return std::nullopt;
    return driver_ != nullptr ? driver_->touched(sphere, *target_, is_virtual(*target_))
                              : workcell_->touched(sphere, *target_, is_virtual(*target_));
  }

  /// How many steps of at most so many the driving method lets the joint move.
  [[nodiscard]] long driven_steps(Moved joint, long most) const {
    kinematics::Angles tried = angles_;
    for (long i = 0; i != most;) {
      i += most < 0 ? -1 : 1;
      tried[joint] = arm_->home[joint] + degrees(turned_[joint] + i);
      if (believed(arm_->sphere_at(tried))) return i;
    }
    throw SimulationFailure(FailureCause::NoContact,
                            fmt::format("{}: the method that drives says contact with the material in the {} nowhere",
                                        what(joint, degrees(most)), to_string(*target_)));
  }

  /// A move of at most so many steps, until the sphere touches the target.
  void move_until_contact(Moved joint, long most) {
    const auto contact = kinematics::first_contact(arc(joint, degrees(most)), arm_->sphere.radius, faces_of(*target_));
    if (!contact && driver_ == nullptr)
      throw SimulationFailure(FailureCause::NoContact,
                              fmt::format("{}: the sphere does not touch the material in the {}",
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
      throw SimulationFailure(FailureCause::NoContact,
                              fmt::format("{}: steps of {:g} degrees pass over the contact at {:.2f}",
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

  void left_behind() {
    target_.reset();
    leaving_ = false;
  }

  const Workcell* workcell_;
  const Sweep* sweep_;
  const Driver* driver_;
  const Arm* arm_;
  double step_;
  kinematics::Angles angles_;
  std::vector<long> turned_;  // from home, in steps
  Phase phase_ = Phase::ToStorage;
  std::optional<StationSlot> target_;  // what the sphere comes for or leaves
  bool leaving_ = false;
  bool above_ = false;        // it has come from there
  double carried_at_ = 0;     // the elbow's command on the way to the place last come down upon
  double shoulder_down_ = 0;  // the command that inverse kinematics has for the upper face
};

/// A way of doing what there are several ways of.
struct Attempt {
  const char* name;
  std::function<void(ProcessSimulation&)> go;
};

/// Leaves it at the first attempt that comes out, or at the one that went furthest. No other is made after a wrong
/// stop: the robot does not know of it.
void first_of(const std::vector<Attempt>& attempts, ProcessSimulation& simulation) {
  std::string failures;
  FailureCause cause = FailureCause::OutOfReach;
  ProcessSimulation furthest = simulation;
  for (const Attempt& attempt : attempts) {
    ProcessSimulation tried = simulation;
    try {
      attempt.go(tried);
      simulation = std::move(tried);
      return;
    } catch (const SimulationFailure& failed) {
      cause = std::max(cause, failed.cause);
      failures += fmt::format("{}{}: {}", failures.empty() ? "" : "; ", attempt.name, failed.what());
      if (tried.went_further_than(furthest)) furthest = std::move(tried);
      if (furthest.was_misled()) break;
    }
  }
  simulation = std::move(furthest);
  throw SimulationFailure(cause, failures);
}

void lift(ProcessSimulation& simulation) {
  first_of({{"lift by the shoulder", [](ProcessSimulation& p) { p.lift(kShoulder); }},
            {"lift by the elbow", [](ProcessSimulation& p) { p.lift(kElbow); }}},
           simulation);
}

/// With the material that has just been touched in storage, to the machine.
void load(ProcessSimulation& simulation) {
  simulation.grip();
  simulation.begin(Phase::ToMachine);
  if (simulation.is_above()) lift(simulation);
  const auto onto = [](Order order) {
    return [order](ProcessSimulation& p) {
      p.come_upon(StationSlot::Machine, Approach::Above, order);
      p.release(StationSlot::Machine);
    };
  };
  first_of({{"from above", onto(Order::ElbowFirst)}, {"from above, base first", onto(Order::BaseFirst)}}, simulation);
}

void go_home(ProcessSimulation& simulation) {
  simulation.begin(Phase::ToHome);
  lift(simulation);
  const auto by = [](std::array<Moved, 3> order, bool raised) {
    return [order, raised](ProcessSimulation& p) {
      if (raised) p.raise();
      p.go_home(order);
    };
  };
  first_of({{"base first", by({kBase, kElbow, kShoulder}, false)},
            {"shoulder first", by({kShoulder, kElbow, kBase}, false)},
            {"elbow first", by({kElbow, kShoulder, kBase}, false)},
            {"raised, base first", by({kBase, kShoulder, kElbow}, true)}},
           simulation);
}

void run(ProcessSimulation& simulation, Phase last) {
  simulation.start();
  simulation.begin(Phase::ToStorage);
  const auto fetch = [last](Approach approach, Order order) {
    return [=](ProcessSimulation& p) {
      p.come_upon(StationSlot::Storage, approach, order);
      if (last > Phase::ToStorage) load(p);
    };
  };
  first_of({{"from the side", fetch(Approach::SideWithoutShoulder, Order::ElbowFirst)},
            {"from above", fetch(Approach::Above, Order::ElbowFirst)},
            {"from the side, shoulder moved", fetch(Approach::Side, Order::ElbowFirst)},
            {"from above, base first", fetch(Approach::Above, Order::BaseFirst)},
            {"from the side, base first", fetch(Approach::Side, Order::BaseFirst)}},
           simulation);
  if (last <= Phase::ToMachine) return;

  simulation.begin(Phase::Withdraw);
  lift(simulation);
  if (last == Phase::Withdraw) return;

  simulation.begin(Phase::ToPiece);
  simulation.come_down_again();
  simulation.grip();
  if (last == Phase::ToPiece) return;

  simulation.begin(Phase::BackToStorage);
  const auto bring = [last](bool raised, bool by_shoulder) {
    return [=](ProcessSimulation& p) {
      if (raised)
        p.raise();
      else
        lift(p);
      if (by_shoulder)
        p.come_upon(StationSlot::Storage, Approach::Above, Order::BaseFirst);
      else
        p.come_down_by_elbow(StationSlot::Storage);
      p.release(StationSlot::Storage);
      if (last == Phase::ToHome) go_home(p);
    };
  };
  first_of({{"raised, from above by the shoulder", bring(true, true)},
            {"raised, from above by the elbow", bring(true, false)},
            {"lifted, from above by the shoulder", bring(false, true)},
            {"lifted, from above by the elbow", bring(false, false)}},
           simulation);
}

}  // namespace

std::string_view to_string(Phase phase) {
  constexpr std::array<std::string_view, kPhases> words{"to-storage", "to-machine",      "withdraw",
                                                        "to-piece",   "back-to-storage", "to-home"};
  return words[static_cast<std::size_t>(phase)];
}

const MaterialTransfer& Process::holding(std::size_t stop) const {
  const MaterialTransfer* last = &transfers.front();
  for (const MaterialTransfer& transfer : transfers)
    if (transfer.stop < stop) last = &transfer;
  return *last;
}

double Process::turned(Moved joint, Phase phase) const {
  double sum = 0;
  for (const Move& move : moves)
    if (move.joint == joint && move.phase == phase) sum += move.degrees;
  return sum;
}

Process simulate(const Workcell& workcell, const Rule& rule) {
  std::optional<Sweep> sweep;
  if (!rule.sphere_alone) sweep.emplace(workcell);
  std::optional<Driver> driver;
  if (rule.drive != nullptr) driver.emplace(workcell, *rule.drive);
  ProcessSimulation simulation(workcell, sweep ? &*sweep : nullptr, driver ? &*driver : nullptr);
  try {
    run(simulation, rule.last);
  } catch (const SimulationFailure& failed) {
    simulation.process.failure = failed.what();
    simulation.process.cause = failed.cause;
  }
  return std::move(simulation.process);
}

}  // namespace touchstone::cell
