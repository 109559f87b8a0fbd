// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/kinematics/layout_study.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>

#include "experiments/program/input.h"
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

const cell::Cell& aristo_cell() {
  static const cell::Cell cell = cell::read_cell(program::data("experiments/thesis/cell/cells/aristo.json"));
  return cell;
}

/// The cell as in a layout; the bodies of gripper and stations stay as they are.
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

}  // namespace

std::string_view name_of(std::size_t joint) {
  constexpr std::array<std::string_view, 3> names{"base", "shoulder", "elbow"};
  return names.at(joint);
}

cell::Process rehearse(const Layout& layout, const Station& storage, const cases::Method* drive) {
  const cell::Cell cell = laid_out(aristo_cell(), layout, storage);
  std::vector<cell::ModelPart> parts;  // the sphere finds nothing but the material
  parts.push_back({cell::Carrier::Material, 0, "material", cell::faces_of(cell.material.solid, "material")});
  try {
    const cell::Workcell workcell(cell, parts, std::make_shared<const std::vector<cell::Covered>>());
    return cell::simulate(workcell,
                          {.last = cell::Phase::ToMachine, .sphere_alone = true, .drive = drive, .finds_ways = false});
  } catch (const cell::BadCell& error) {
    cell::Process none;
    none.failure = error.what();
    none.cause = cell::FailureCause::OutOfReach;
    return none;
  }
}

cell::Process rehearse_case(const Layout& layout, std::size_t number) {
  return rehearse(layout, layout.storage(number, kCases.at(number).storage_angle));
}

std::vector<std::pair<AristoJoint, int>> moves_of(const Captions& captions) {
  std::vector<std::pair<AristoJoint, int>> moves{{kElbow, captions.elbow},
                                                 {kBase, captions.base},
                                                 {kShoulder, captions.shoulder},
                                                 {kShoulder, captions.lift},
                                                 {kElbow, captions.elbow_to_machine},
                                                 {kBase, captions.base_to_machine},
                                                 {kShoulder, captions.shoulder_to_machine}};
  std::erase_if(moves, [](const auto& move) { return move.second == 0; });
  return moves;
}

std::string difference(const cell::Process& process, const Captions& captions) {
  const auto expected = moves_of(captions);
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

namespace {

/// Empty if both cases have the captions' values.
std::string failure_of(const Layout& layout) {
  for (std::size_t i = 0; i < kCases.size(); ++i)
    if (const std::string d = difference(rehearse_case(layout, i), kCases[i]); !d.empty())
      return "case " + std::to_string(i + 1) + ": " + d;
  return "";
}

const std::array<Parameter, 13> kParameters{{
    {"storage height", "mm",
     [](Layout& l) {
       return std::vector{&l.storage_height[0], &l.storage_height[1]};
     }},
    {"home lean of the upper arm", "deg", [](Layout& l) { return std::vector{&l.home.lean}; }},
    {"home elevation of the forearm", "deg", [](Layout& l) { return std::vector{&l.home.elevation}; }},
    {"sphere radius", "mm", [](Layout& l) { return std::vector{&l.sphere_radius}; }},
    {"sphere distance from the flange", "mm", [](Layout& l) { return std::vector{&l.sphere_distance}; }},
    {"material side", "mm", [](Layout& l) { return std::vector{&l.side}; }},
    {"gap between station axis and material", "mm", [](Layout& l) { return std::vector{&l.gap}; }},
    {"drop onto the place at the machine", "mm", [](Layout& l) { return std::vector{&l.drop}; }},
    {"storage radius in case 1", "mm", [](Layout& l) { return std::vector{&l.storage_radius[0]}; }},
    {"storage radius in case 2", "mm", [](Layout& l) { return std::vector{&l.storage_radius[1]}; }},
    {"machine radius", "mm", [](Layout& l) { return std::vector{&l.machine_radius}; }},
    {"machine height", "mm", [](Layout& l) { return std::vector{&l.machine_height}; }},
    {"clearance of the lift", "mm", [](Layout& l) { return std::vector{&l.clearance}; }},
}};

}  // namespace

const std::array<Parameter, 13>& parameters() { return kParameters; }

double furthest(const Layout& layout, const Parameter& parameter, double direction, double precision,
                const std::function<bool(const Layout&)>& holds) {
  const auto holds_at = [&](double by) { return holds(parameter.moved(layout, direction * by)); };
  double low = 0, high = 0.125;
  while (high <= 100 && holds_at(high)) low = high, high *= 2;
  while (high - low > precision) {
    const double middle = (low + high) / 2;
    (holds_at(middle) ? low : high) = middle;
  }
  return direction * low;
}

Member study_home(const Linkage& linkage, const LinkAngles& home) {
  Member member{linkage, home, solve_layout(linkage, home), ""};
  member.failure = member.layout ? failure_of(*member.layout) : "no layout";
  return member;
}

std::uint64_t layout_work(HomeSteps steps) {
  const auto angles = [](int step) { return 2 * std::size_t{kHomeReach} / static_cast<std::size_t>(step) + 1; };
  const std::size_t grid = angles(steps.grid);
  return kCouplings.size() * kHands.size() * (grid * grid + angles(steps.line)) + kParameters.size();
}

std::optional<LayoutStudy> study_layout(HomeSteps steps, const std::atomic<bool>& stop,
                                        const LayoutProgress& progress) {
  std::uint64_t done = 0;
  const auto stopped = [&] {
    progress(++done);
    return stop.load();
  };
  LayoutStudy study;
  std::vector<Linkage> linkages;
  for (const Hand hand : kHands)
    for (const Coupling coupling : kCouplings) linkages.push_back({coupling, hand});
  for (const Linkage& linkage : linkages) {
    for (int elevation = -kHomeReach; elevation <= kHomeReach; elevation += steps.grid)
      for (int lean = -kHomeReach; lean <= kHomeReach; lean += steps.grid) {
        study.grid.push_back(study_home(linkage, {0.0 + lean, 0.0 + elevation}));
        if (stopped()) return std::nullopt;
      }
    for (int elevation = -kHomeReach; elevation <= kHomeReach; elevation += steps.line) {
      for (const double lean : leans_of_one_height(linkage, elevation))
        study.one_height.push_back(study_home(linkage, {lean, 0.0 + elevation}));
      if (stopped()) return std::nullopt;
    }
  }

  study.chosen = chosen_layout();
  const Layout& layout = study.chosen;
  for (std::size_t i = 0; i < kCases.size(); ++i) study.cases.push_back(rehearse_case(layout, i));
  for (const Parameter& parameter : kParameters) {
    const double value = parameter.value(layout);
    const auto end = [&](double direction) {
      return value + furthest(layout, parameter, direction, 0.001,
                              [](const Layout& changed) { return failure_of(changed).empty(); });
    };
    study.choices.push_back({parameter.name, parameter.unit, value, end(-1), end(1)});
    if (stopped()) return std::nullopt;
  }
  return study;
}

}  // namespace touchstone::kinematics
