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
  constexpr std::array<std::string_view, 7> words{"planned", "facing", "contact", "cleared",
                                                  "landed",  "raised", "through"};
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
  std::optional<std::pair<Handling, SimulationFailure>> furthest;
  std::vector<std::string> refused;
  for (const Attempt& attempt : attempts) {
    Handling tried = robot;
    try {
      attempt.go(tried);
      robot = std::move(tried);
      return;
    } catch (const SimulationFailure& failed) {
      auto& its = tried.process.refused;
      if (its.empty()) its.emplace_back(failed.what());
      for (const std::string& why : its) refused.push_back(fmt::format("{}: {}", attempt.name, why));
      if (furthest && furthest->first.went_further_than(tried)) continue;
      furthest.emplace(std::move(tried), failed);
      if (furthest->first.was_misled()) break;
    }
  }
  robot = std::move(furthest->first);
  robot.process.refused = std::move(refused);
  throw SimulationFailure(furthest->second);
}

/// The attempts in the thesis's order of moves, if the robot has kept to it, and that by a way that is found.
void first_of(std::vector<Attempt> in_order, const std::function<void(Handling&)>& by_way, const Rule& rule,
              Handling& robot) {
  if (!robot.in_order()) in_order.clear();
  if (rule.finds_ways && rule.drive == nullptr) in_order.push_back({"by a way that is found", by_way});
  first_of(in_order, robot);
}

void straight_up(Handling& robot) {
  const auto by = [](double share) { return [share](Handling& p) { p.go_straight_up(share); }; };
  first_of({{"straight up", by(1)}, {"straight up by half", by(0.5)}, {"straight up by a quarter", by(0.25)}}, robot);
}

void lift(Handling& robot) {
  first_of({{"lift by the shoulder", [](Handling& p) { p.lift(kShoulder); }},
            {"lift by the elbow", [](Handling& p) { p.lift(kElbow); }}},
           robot);
}

/// By a way that is found, onto the material in a slot or its virtual copy.
void find_onto(StationSlot slot, Handling& robot) {
  robot.find_to_above(slot);
  robot.come_straight_down(slot);
}

/// With the material that has just been touched in storage, to the machine.
void load(const Rule& rule, Handling& robot) {
  robot.grip();
  robot.begin(Phase::ToMachine);
  first_of(
      {{"from above",
        [](Handling& p) {
          if (p.is_above()) lift(p);
          p.come_upon(StationSlot::Machine, Approach::Above);
          p.release(StationSlot::Machine);
        }}},
      [](Handling& p) {
        straight_up(p);
        find_onto(StationSlot::Machine, p);
        p.release(StationSlot::Machine);
      },
      rule, robot);
}

void go_home(const Rule& rule, Handling& robot) {
  robot.begin(Phase::ToHome);
  const auto by = [](std::array<Moved, 3> order) {
    return [order](Handling& p) {
      lift(p);
      p.go_home(order);
    };
  };
  first_of(
      {{"base first", by({kBase, kElbow, kShoulder})},
       {"shoulder first", by({kShoulder, kElbow, kBase})},
       {"elbow first", by({kElbow, kShoulder, kBase})}},
      [](Handling& p) {
        straight_up(p);
        p.find_home();
      },
      rule, robot);
}

void run(Handling& robot, const Rule& rule) {
  robot.begin(Phase::ToStorage);
  const Phase last = rule.last;
  const auto fetch = [&](Approach approach) {
    return [&rule, last, approach](Handling& p) {
      p.come_upon(StationSlot::Storage, approach);
      if (last > Phase::ToStorage) load(rule, p);
    };
  };
  first_of(
      {{"from the side", fetch(Approach::Side)},
       {"from above", fetch(Approach::Above)},
       {"from the side, shoulder moved", fetch(Approach::SideByShoulder)},
       {"from above, base first", fetch(Approach::AboveBaseFirst)}},
      [&](Handling& p) {
        find_onto(StationSlot::Storage, p);
        if (last > Phase::ToStorage) load(rule, p);
      },
      rule, robot);
  if (last <= Phase::ToMachine) return;

  robot.begin(Phase::Withdraw);
  const auto again = [&](const auto& up, const auto& down) {
    return [=](Handling& p) {
      up(p);
      if (last == Phase::Withdraw) return;
      p.begin(Phase::ToPiece);
      down(p);
      p.grip();
    };
  };
  first_of({{"by the shoulder", again(lift, [](Handling& p) { p.come_down_again(); })}},
           again(straight_up, [](Handling& p) { p.come_straight_down(StationSlot::Machine); }), rule, robot);
  if (last <= Phase::ToPiece) return;

  robot.begin(Phase::BackToStorage);
  const auto let_go = [&](Handling& p) {
    p.release(StationSlot::Storage);
    if (last == Phase::ToHome) go_home(rule, p);
  };
  const auto bring = [&](bool by_shoulder) {
    return [=](Handling& p) {
      p.raise();
      if (by_shoulder)
        p.come_upon(StationSlot::Storage, Approach::AboveBaseFirst);
      else
        p.come_down_by_elbow(StationSlot::Storage);
      let_go(p);
    };
  };
  first_of(
      {{"raised, from above by the shoulder", bring(true)}, {"raised, from above by the elbow", bring(false)}},
      [&](Handling& p) {
        straight_up(p);
        find_onto(StationSlot::Storage, p);
        let_go(p);
      },
      rule, robot);
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
  const Sweep sweep(workcell, rule.sphere_alone);
  std::optional<Driver> driver;
  if (rule.drive != nullptr) driver.emplace(*rule.drive);
  Handling robot(workcell, sweep, driver ? &*driver : nullptr);
  try {
    robot.start();
    first_of(
        {{"in the thesis's order as far as it goes", [&](Handling& p) { run(p, rule); }}},
        [&](Handling& p) {
          p.leave_order();
          run(p, rule);
        },
        rule, robot);
  } catch (const SimulationFailure& failed) {
    robot.process.failure = failed.what();
    if (robot.process.refused.empty()) robot.process.refused = {robot.process.failure};
    robot.process.cause = failed.cause;
  }
  robot.process.triggers = zone_triggers(workcell, robot.process, rule.sphere_alone);
  stop_at_zones(workcell, robot.process);
  return std::move(robot.process);
}

kinematics::Angles Step::after(kinematics::Angles from, double turned) const {
  for (std::size_t i = 0; i < by.size(); ++i)
    if (by[i] != 0) from[i] += std::copysign(i == joint ? turned : turned * std::abs(by[i] / degrees), by[i]);
  return from;
}

Step step_of(Moved joint, double degrees) {
  Step step{joint, degrees, {}};
  step.by[joint] = degrees;
  return step;
}

Step step_between(const kinematics::Angles& from, const kinematics::Angles& to) {
  Step step{kBase, 0, {}};
  for (const Moved joint : {kBase, kShoulder, kElbow}) {
    step.by[joint] = to[joint] - from[joint];
    if (std::abs(step.by[joint]) > std::abs(step.degrees)) step.joint = joint, step.degrees = step.by[joint];
  }
  return step;
}

}  // namespace touchstone::cell
