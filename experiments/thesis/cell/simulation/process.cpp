// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/process.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/simulation/handling.h"
#include "experiments/thesis/cell/simulation/zone_triggers.h"

namespace touchstone::cell {

std::string_view to_string(Until until) {
  constexpr std::array<std::string_view, 4> words{"planned", "facing", "contact", "cleared"};
  return words[static_cast<std::size_t>(until)];
}

std::string_view to_string(FailureCause cause) {
  constexpr std::array<std::string_view, 6> words{"out-of-reach", "beyond-limits", "no-contact",
                                                  "not-held",     "misplaced",     "in-the-way"};
  return words[static_cast<std::size_t>(cause)];
}

namespace {

/// A way of doing what there are several ways of.
struct Attempt {
  const char* name;
  std::function<void(Handling&)> go;
};

/// Leaves it at the first attempt that succeeds, or at the one that went furthest. No other is made after a wrong
/// stop: the robot does not know of it.
void first_of(const std::vector<Attempt>& attempts, Handling& robot) {
  std::string failures;
  FailureCause cause = FailureCause::OutOfReach;
  Handling furthest = robot;
  for (const Attempt& attempt : attempts) {
    Handling tried = robot;
    try {
      attempt.go(tried);
      robot = std::move(tried);
      return;
    } catch (const SimulationFailure& failed) {
      cause = std::max(cause, failed.cause);
      failures += fmt::format("{}{}: {}", failures.empty() ? "" : "; ", attempt.name, failed.what());
      if (!furthest.process.stuck || tried.went_further_than(furthest)) furthest = std::move(tried);
      if (furthest.was_misled()) break;
    }
  }
  robot = std::move(furthest);
  throw SimulationFailure(cause, failures);
}

void lift(Handling& robot) {
  first_of({{"lift by the shoulder", [](Handling& p) { p.lift(kShoulder); }},
            {"lift by the elbow", [](Handling& p) { p.lift(kElbow); }}},
           robot);
}

/// With the material that has just been touched in storage, to the machine.
void load(Handling& robot) {
  robot.grip();
  robot.begin(Phase::ToMachine);
  if (robot.is_above()) lift(robot);
  const auto onto = [](Order order) {
    return [order](Handling& p) {
      p.come_upon(StationSlot::Machine, Approach::Above, order);
      p.release(StationSlot::Machine);
    };
  };
  first_of({{"from above", onto(Order::ElbowFirst)}, {"from above, base first", onto(Order::BaseFirst)}}, robot);
}

void go_home(Handling& robot) {
  robot.begin(Phase::ToHome);
  lift(robot);
  const auto by = [](std::array<Moved, 3> order, bool raised) {
    return [order, raised](Handling& p) {
      if (raised) p.raise();
      p.go_home(order);
    };
  };
  first_of({{"base first", by({kBase, kElbow, kShoulder}, false)},
            {"shoulder first", by({kShoulder, kElbow, kBase}, false)},
            {"elbow first", by({kElbow, kShoulder, kBase}, false)},
            {"raised, base first", by({kBase, kShoulder, kElbow}, true)}},
           robot);
}

void run(Handling& robot, Phase last) {
  robot.start();
  robot.begin(Phase::ToStorage);
  const auto fetch = [last](Approach approach, Order order) {
    return [=](Handling& p) {
      p.come_upon(StationSlot::Storage, approach, order);
      if (last > Phase::ToStorage) load(p);
    };
  };
  first_of({{"from the side", fetch(Approach::SideWithoutShoulder, Order::ElbowFirst)},
            {"from above", fetch(Approach::Above, Order::ElbowFirst)},
            {"from the side, shoulder moved", fetch(Approach::Side, Order::ElbowFirst)},
            {"from above, base first", fetch(Approach::Above, Order::BaseFirst)},
            {"from the side, base first", fetch(Approach::Side, Order::BaseFirst)}},
           robot);
  if (last <= Phase::ToMachine) return;

  robot.begin(Phase::Withdraw);
  lift(robot);
  if (last == Phase::Withdraw) return;

  robot.begin(Phase::ToPiece);
  robot.come_down_again();
  robot.grip();
  if (last == Phase::ToPiece) return;

  robot.begin(Phase::BackToStorage);
  const auto bring = [last](bool raised, bool by_shoulder) {
    return [=](Handling& p) {
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
           robot);
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
  Handling robot(workcell, sweep ? &*sweep : nullptr, driver ? &*driver : nullptr);
  try {
    run(robot, rule.last);
  } catch (const SimulationFailure& failed) {
    robot.process.failure = failed.what();
    robot.process.cause = failed.cause;
  }
  robot.process.triggers = zone_triggers(workcell, robot.process, rule.sphere_alone);
  stop_at_zones(workcell, robot.process);
  return std::move(robot.process);
}

std::optional<double> seconds(const Arm& arm, Moved joint, double degrees) {
  kinematics::Angles moved = arm.home;
  moved[joint] += degrees;
  const kinematics::Angles before = arm.chain.turns(arm.home), after = arm.chain.turns(moved);
  double longest = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double turned = std::abs(after[i] - before[i]);
    if (turned == 0) continue;
    if (!(arm.speeds[i] > 0)) return std::nullopt;
    longest = std::max(longest, turned / arm.speeds[i]);
  }
  return longest;
}

StepOfJoint step_between(const Stop& from, const Stop& to) {
  for (const Moved joint : {kBase, kShoulder, kElbow})
    if (from.commanded[joint] != to.commanded[joint]) return {joint, to.commanded[joint] - from.commanded[joint]};
  return {kBase, 0};
}

std::vector<double> times_of(const Arm& arm, const Process& process) {
  std::vector<double> times;
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    if (i == 0) {
      times.push_back(0);
      continue;
    }
    const StepOfJoint step = step_between(process.stops[i - 1], process.stops[i]);
    const auto taken = seconds(arm, step.joint, step.degrees);
    if (!taken) return {};
    times.push_back(times.back() + *taken);
  }
  return times;
}

std::optional<double> when(const std::vector<double>& times, const Arm& arm, const Process& process, std::size_t stop,
                           double degrees) {
  if (times.empty()) return std::nullopt;
  if (degrees == 0 || stop + 1 == process.stops.size()) return times[stop];
  const Moved joint = step_between(process.stops[stop], process.stops[stop + 1]).joint;
  return times[stop] + seconds(arm, joint, degrees).value();
}

}  // namespace touchstone::cell
