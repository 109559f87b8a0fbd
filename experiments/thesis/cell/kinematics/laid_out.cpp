// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/kinematics/laid_out.h"

#include <fmt/core.h>

#include <array>
#include <memory>
#include <string_view>
#include <utility>

#include "experiments/run/input.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/read_cell.h"

namespace touchstone::kinematics {
namespace {

/// Which joint undoes the turning of which, and by what factor of its command in the cell's directions.
std::vector<cell::Coupling> couplings_of(const Layout& layout) {
  std::vector<cell::Coupling> couplings;
  const bool keeps = layout.coupling == Coupling::KeepsElevation;
  if (keeps) couplings.push_back({kElbow, kShoulder, 1});
  if (layout.hand == Hand::Locked) return couplings;
  if (!keeps) couplings.push_back({kWristPitch, kShoulder, 1});
  couplings.push_back({kWristPitch, kElbow, -1});
  return couplings;
}

std::string_view name_of(std::size_t joint) {
  constexpr std::array<std::string_view, 3> names{"base", "shoulder", "elbow"};
  return names.at(joint);
}

const cell::Cell& aristo_cell() {
  static const cell::Cell cell = cell::read_cell(run::data("experiments/thesis/cell/cells/aristo.json"));
  return cell;
}

}  // namespace

cell::Cell laid_out(cell::Cell cell, const Layout& layout, const Station& storage) {
  cell.robot.couplings = couplings_of(layout);
  const Angles home = home_pose(layout);
  for (std::size_t i = 0; i < home.size(); ++i) cell.robot.joints[i].home = home[i];
  cell.gripper.sphere = {{0, 0, -layout.sphere_distance}, layout.sphere_radius};
  const double half = layout.side / 2;
  const Eigen::Vector2d beside(0, -layout.gap - half);
  const auto put = [&](cell::Station& station, cell::Slot& slot, const Station& at) {
    station.angle = at.azimuth - station.home;
    station.radius = at.radius;
    station.height = at.height - slot.place.z();
    slot.place.head<2>() = beside;
    slot.aim = {0, 0};
  };
  put(cell.storage, cell.storage.slots[cell.material.slot], storage);
  put(cell.machine, cell.machine.slots[cell.material.machine_slot], layout.machine());
  cell.material.solid.shape = cell::Box{{-half, -half, 0}, {half, half, layout.side}};
  cell.material.drop = layout.drop;
  cell.clearance = layout.clearance;
  return cell;
}

cell::Process rehearse(const Layout& layout, const Station& storage) {
  const cell::Cell cell = laid_out(aristo_cell(), layout, storage);
  std::vector<cell::ModelPart> parts;  // the sphere finds nothing but the material
  parts.push_back({cell::Carrier::Material, 0, "material", cell::faces_of(cell.material.solid, "material")});
  try {
    const cell::Workcell workcell(cell, parts, std::make_shared<const std::vector<cell::Covered>>());
    return cell::simulate(workcell, {.last = cell::Phase::ToMachine, .sphere_alone = true});
  } catch (const cell::BadCell& error) {
    cell::Process none;
    none.failure = error.what();
    none.cause = FailureCause::OutOfReach;
    return none;
  }
}

cell::Process rehearse_case(const Layout& layout, std::size_t number) {
  return rehearse(layout, layout.storage(number, kCases.at(number).storage_angle));
}

std::string difference(const cell::Process& process, const Captions& captions) {
  std::vector<std::pair<AristoJoint, int>> expected{{kElbow, captions.elbow}, {kBase, captions.base}};
  if (captions.shoulder != 0) expected.emplace_back(kShoulder, captions.shoulder);
  if (captions.lift != 0) expected.emplace_back(kShoulder, captions.lift);
  expected.emplace_back(kElbow, captions.elbow_to_machine);
  expected.emplace_back(kBase, captions.base_to_machine);
  expected.emplace_back(kShoulder, captions.shoulder_to_machine);
  std::size_t i = 0;
  for (const cell::Move& move : process.moves) {
    if (move.phase > cell::Phase::ToMachine) break;
    if (i == expected.size()) return fmt::format("more moves than the {} that the captions name", expected.size());
    const auto [joint, degrees] = expected[i++];
    if (std::size_t{move.joint} != joint || move.degrees != degrees)
      return fmt::format("move {}: {} {:+} where the caption says {} {:+}", i, name_of(move.joint), move.degrees,
                         name_of(joint), degrees);
  }
  if (i == expected.size()) return "";
  return process.failure.empty() ? fmt::format("{} moves where the captions name {}", i, expected.size())
                                 : process.failure;
}

}  // namespace touchstone::kinematics
