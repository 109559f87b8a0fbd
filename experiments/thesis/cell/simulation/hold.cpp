// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/hold.h"

#include <fmt/core.h>

#include "experiments/thesis/cell/simulation/triangle_distance.h"

namespace touchstone::cell {
namespace {

constexpr int kShifts = 16;  // of equal length, up to the play: fingers are thicker than one

}  // namespace

std::string met_by_gripper(const Workcell& workcell, const Pose& in_flange) {
  for (const NamedTriangle& each : workcell.material()) {
    const Triangle triangle{in_flange * each.triangle.a, in_flange * each.triangle.b, in_flange * each.triangle.c};
    for (const NamedTriangle& finger : workcell.gripper())
      if (distance(triangle, finger.triangle).lower == 0) return workcell.names()[finger.owner];
  }
  return "";
}

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

}  // namespace touchstone::cell
