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

#include "experiments/workloads/degrees.h"

namespace touchstone::cell {
namespace {

using kinematics::Approach;
using kinematics::SimulationFailure;

enum class Order { ElbowFirst, BaseFirst };

class ProcessSimulation {
 public:
  explicit ProcessSimulation(const Workcell& workcell)
      : workcell_(&workcell),
        arm_(&workcell.arm()),
        step_(workcell.cell().step),
        angles_(workcell.arm().home),
        turned_(angles_.size(), 0) {
    process.transfers.push_back({0, StationSlot::Storage, 0});
  }

  void start() { stop(std::nullopt, 0); }

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
    const auto commands =
        workcell_->plane().inverse({std::sqrt(at.out * at.out + beside * beside), (at.bottom + at.top) / 2});
    if (!commands) throw SimulationFailure(FailureCause::OutOfReach, "the side of the material is out of reach");
    if (std::abs(commands->shoulder - arm_->home[kShoulder]) >= step_ / 2 && approach == Approach::SideWithoutShoulder)
      throw SimulationFailure(FailureCause::OutOfReach, "the shoulder would have to move");
    move_to(kShoulder, commands->shoulder);
    move_to(kElbow, commands->elbow);
    move_until_contact(kBase, steps_to(kBase, target));
  }

  /// By the shoulder, else by the elbow.
  void lift() {
    if (!lift_by(kShoulder) && !lift_by(kElbow))
      throw SimulationFailure(FailureCause::OutOfReach, "no lift by shoulder or elbow clears the material");
    left_behind();
  }

  void grip() {
    hand_over(std::nullopt);
    target_.reset();
  }
  void release(StationSlot slot) {
    hand_over(slot);
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
  /// Back by the base from what it has come upon from the side.
  void draw_aside() {
    if (above_) return;
    turn_near(workcell_->at(*target_));
    left_behind();
  }
  void lift_if_above() {
    if (above_) lift();
  }
  void come_down_again() {
    target_ = StationSlot::Machine;
    go_down();
  }

  Process process;

 private:
  [[nodiscard]] double sense() const { return workcell_->plane().base(1) - workcell_->plane().base(0); }
  [[nodiscard]] bool clockwise(double target) const { return (target - angles_[kBase]) * sense() < 0; }

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

  /// The elbow as planned, the base if it does not face the place yet, then the shoulder.
  void come_down(const Workplace& at) {
    const double r = arm_->sphere.radius, beside = std::max({0.0, at.right, -at.left});
    const auto commands =
        workcell_->plane().inverse({at.out, at.top + (beside < r ? std::sqrt(r * r - beside * beside) : 0)});
    if (!commands) throw SimulationFailure(FailureCause::OutOfReach, "the upper face of the material is out of reach");
    move_to(kElbow, commands->elbow);
    face(at);
    shoulder_down_ = commands->shoulder;
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
    if (const auto contact = kinematics::first_contact(way, radius, workcell_->at(*material).faces))
      throw SimulationFailure(FailureCause::InTheWay,
                              fmt::format("{}: after {:.2f} degrees the sphere touches the material in the {}",
                                          what(joint, degrees), contact->high, to_string(*material)));
  }

  /// Looks at the arm as it is. True if the sphere touches the target.
  bool stop(std::optional<Moved> joint, double turned) {
    const std::string obstacle_name = workcell_->touched_obstacle(angles_, obstacle(), process.balls);
    if (!obstacle_name.empty())
      throw SimulationFailure(FailureCause::InTheWay, joint ? fmt::format("{}: {}", what(*joint, turned), obstacle_name)
                                                            : "at home " + obstacle_name);
    const Ball sphere = arm_->sphere_at(angles_);
    const auto touched = target_ ? workcell_->touched(sphere, *target_) : std::nullopt;
    process.stops.push_back({process.moves.size(), angles_, sphere, target_, touched});
    return touched.has_value();
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
    const long from = turned_[joint], sign = steps < 0 ? -1 : 1;
    for (long i = sign; i != steps + sign; i += sign) {
      turn(joint, from, i);
      stop(joint, degrees(i));
    }
    const double left = std::abs(exact - degrees(steps));
    const double margin = until == Until::Cleared ? std::min(left, step_ - left) : step_ / 2 - left;
    process.moves.push_back({phase_, joint, until, degrees(steps), exact, margin, {}});
  }

  /// A move of at most so many steps, until the sphere touches the target.
  void move_until_contact(Moved joint, long most) {
    const auto contact =
        kinematics::first_contact(arc(joint, degrees(most)), arm_->sphere.radius, workcell_->at(*target_).faces);
    if (!contact)
      throw SimulationFailure(FailureCause::NoContact,
                              fmt::format("{}: the sphere does not touch the material in the {}",
                                          what(joint, degrees(most)), to_string(*target_)));
    const long sign = most < 0 ? -1 : 1, steps = sign * static_cast<long>(std::ceil(contact->high / step_));
    require_free_arc(joint, degrees(steps), obstacle());
    const long from = turned_[joint];
    for (long i = 0; i != steps;) {
      i += sign;
      turn(joint, from, i);
      if (!stop(joint, degrees(i))) continue;
      const double left = std::abs(degrees(i)) - contact->low;
      process.moves.push_back({phase_, joint, Until::Contact, degrees(i), std::copysign(contact->low, most),
                               std::min(left, step_ - left), contact});
      return;
    }
    throw SimulationFailure(FailureCause::NoContact,
                            fmt::format("{}: steps of {:g} degrees pass over the contact at {:.2f}",
                                        what(joint, degrees(steps)), step_, contact->high));
  }

  void left_behind() {
    target_.reset();
    leaving_ = false;
  }

  void hand_over(std::optional<StationSlot> to) {
    const auto from = process.transfers.back().slot;
    const Pose flange = arm_->link_poses(angles_).back();
    double shift = 0;
    if (from) {
      held_ = flange.rotation.transpose() * (workcell_->at(*from).pose.translation - flange.translation);
    } else {
      shift = (workcell_->at(*to).pose.translation - (flange.rotation * held_ + flange.translation)).norm();
    }
    process.transfers.push_back({process.stops.size() - 1, to, shift});
  }

  const Workcell* workcell_;
  const Arm* arm_;
  double step_;
  kinematics::Angles angles_;
  std::vector<long> turned_;  // from home, in steps
  Phase phase_ = Phase::ToStorage;
  std::optional<StationSlot> target_;  // what the sphere comes for or leaves
  bool leaving_ = false;
  bool above_ = false;                              // it has come from there
  double shoulder_down_ = 0;                        // the command that inverse kinematics has for the upper face
  Eigen::Vector3d held_ = Eigen::Vector3d::Zero();  // the material's origin in the flange's frame
};

/// A way of doing what there are several ways of.
struct Attempt {
  const char* name;
  std::function<void(ProcessSimulation&)> go;
};

/// Leaves it at the first attempt that comes out.
void first_of(const std::vector<Attempt>& attempts, ProcessSimulation& simulation) {
  std::string failures;
  FailureCause cause = FailureCause::OutOfReach;
  for (const Attempt& attempt : attempts) {
    ProcessSimulation tried = simulation;
    try {
      attempt.go(tried);
      simulation = std::move(tried);
      return;
    } catch (const SimulationFailure& failed) {
      cause = std::max(cause, failed.cause);
      failures += fmt::format("{}{}: {}", failures.empty() ? "" : "; ", attempt.name, failed.what());
    }
  }
  throw SimulationFailure(cause, failures);
}

Attempt upon(const char* name, StationSlot slot, Approach approach, Order order) {
  return {name, [=](ProcessSimulation& p) { p.come_upon(slot, approach, order); }};
}

void run(ProcessSimulation& simulation) {
  simulation.start();
  simulation.begin(Phase::ToStorage);
  first_of({upon("from the side", StationSlot::Storage, Approach::SideWithoutShoulder, Order::ElbowFirst),
            upon("from above", StationSlot::Storage, Approach::Above, Order::ElbowFirst),
            upon("from the side, shoulder moved", StationSlot::Storage, Approach::Side, Order::ElbowFirst),
            upon("from above, base first", StationSlot::Storage, Approach::Above, Order::BaseFirst),
            upon("from the side, base first", StationSlot::Storage, Approach::Side, Order::BaseFirst)},
           simulation);
  simulation.grip();

  simulation.begin(Phase::ToMachine);
  simulation.lift_if_above();
  first_of({upon("from above", StationSlot::Machine, Approach::Above, Order::ElbowFirst),
            upon("from above, base first", StationSlot::Machine, Approach::Above, Order::BaseFirst)},
           simulation);
  simulation.release(StationSlot::Machine);

  simulation.begin(Phase::Withdraw);
  simulation.lift();

  simulation.begin(Phase::ToPiece);
  simulation.come_down_again();
  simulation.grip();

  simulation.begin(Phase::BackToStorage);
  simulation.lift();
  first_of({upon("from above, base first", StationSlot::Storage, Approach::Above, Order::BaseFirst),
            upon("from the side, base first", StationSlot::Storage, Approach::Side, Order::BaseFirst),
            upon("from above", StationSlot::Storage, Approach::Above, Order::ElbowFirst),
            upon("from the side", StationSlot::Storage, Approach::Side, Order::ElbowFirst)},
           simulation);
  simulation.release(StationSlot::Storage);

  simulation.begin(Phase::ToHome);
  simulation.lift_if_above();
  first_of({{"base first",
             [](ProcessSimulation& p) {
               p.go_home({kBase, kElbow, kShoulder});
             }},
            {"shoulder first",
             [](ProcessSimulation& p) {
               p.draw_aside();
               p.go_home({kShoulder, kElbow, kBase});
             }},
            {"elbow first",
             [](ProcessSimulation& p) {
               p.draw_aside();
               p.go_home({kElbow, kShoulder, kBase});
             }}},
           simulation);
}

}  // namespace

std::string_view to_string(Phase phase) {
  constexpr std::array<std::string_view, kPhases> words{"to-storage", "to-machine",      "withdraw",
                                                        "to-piece",   "back-to-storage", "to-home"};
  return words[static_cast<std::size_t>(phase)];
}

Process simulate(const Workcell& workcell) {
  ProcessSimulation simulation(workcell);
  try {
    run(simulation);
  } catch (const SimulationFailure& failed) {
    simulation.process.failure = failed.what();
    simulation.process.cause = failed.cause;
  }
  return std::move(simulation.process);
}

}  // namespace touchstone::cell
