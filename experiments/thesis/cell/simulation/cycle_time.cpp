// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/cycle_time.h"

#include <algorithm>
#include <cmath>

namespace touchstone::cell {

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

}  // namespace touchstone::cell
