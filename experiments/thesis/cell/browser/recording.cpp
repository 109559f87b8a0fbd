// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/recording.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "experiments/methods/registry.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/sweep.h"

namespace touchstone::cell::browser {
namespace {

/// The arm at a pose. The material follows the flange while the gripper has it.
Snapshot snapshot_of(const Workcell& workcell, const kinematics::Angles& commanded, const MaterialTransfer& last) {
  Snapshot snapshot{workcell.arm().link_poses(commanded), {}, last.slot, {}};
  snapshot.material = last.slot ? last.lies->pose : within(snapshot.links.back(), *last.in_flange);
  if (last.grip)
    for (std::size_t i = 0; i < 2; ++i) snapshot.closed[i] = last.grip->fingers[i].way;
  return snapshot;
}

}  // namespace

std::vector<Snapshot> snapshots_of(const Workcell& workcell, const Process& process) {
  std::vector<Snapshot> snapshots;
  auto transfer = process.transfers.begin();
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    const Stop& stop = process.stops[i];
    const bool handed_over = transfer + 1 != process.transfers.end() && (transfer + 1)->stop <= i;
    const Lying found = !stop.target                    ? nullptr
                        : transfer->slot == stop.target ? transfer->lies
                                                        : workcell.at(*stop.target).copy;
    if (handed_over) ++transfer;
    Snapshot snapshot = snapshot_of(workcell, stop.commanded, *transfer);
    if (found) snapshot.nearest = found->scene.nearest(stop.sphere);
    snapshots.push_back(std::move(snapshot));
  }
  return snapshots;
}

Simulator::Simulator(Cell cell, SimulatorOptions options)
    : cell_(std::move(cell)),
      parts_(build_model(cell_)),
      options_(std::move(options)),
      arm_(std::make_shared<const std::vector<Covered>>(cover_arm(parts_))) {}

std::vector<ModelPart> Simulator::parts_for(const Cell& cell) const { return with_stand(parts_, cell.storage); }

Rule Simulator::rule_for(const Setting& setting) const {
  Rule rule = options_.rule;
  rule.drive = setting.drive == "exact" ? nullptr : methods::find_method(setting.drive);
  return rule;
}

Setting Simulator::setting() const {
  Setting setting = setting_of(cell_);
  if (options_.rule.drive != nullptr) setting.drive = options_.rule.drive->name();
  return setting;
}

std::vector<std::string> Simulator::drives() const {
  std::vector<std::string> names{"exact"};
  if (options_.rule.drive != nullptr) names.emplace_back(options_.rule.drive->name());
  for (const cases::Method* method : options_.methods)
    if (std::ranges::find(names, method->name()) == names.end()) names.emplace_back(method->name());
  return names;
}

Recording Simulator::run(const Setting& setting) const {
  Recording recording{.cell = changed(cell_, setting), .drive = setting.drive};
  recording.parts = parts_for(recording.cell);
  const Workcell workcell(recording.cell, recording.parts, arm_);
  for (const StationSlot slot : {StationSlot::Storage, StationSlot::Machine})
    recording.places.push_back(workcell.at(slot).copy->pose);
  recording.process = simulate(workcell, rule_for(setting));
  recording.snapshots = snapshots_of(workcell, recording.process);
  if (const auto& stuck = recording.process.stuck)
    recording.stuck = snapshot_of(workcell, stuck->commanded, recording.process.transfers.back());
  recording.timing = Timing(workcell, recording.process);
  recording.separation = separation_of(workcell, recording.process);
  recording.comparison = compare_methods(workcell, recording.process, options_.methods, true);
  return recording;
}

Posed Simulator::pose(const Setting& setting, const kinematics::Angles& commanded) const {
  const Cell cell = changed(cell_, setting);
  const Workcell workcell(cell, parts_for(cell), arm_);
  const Arm& arm = workcell.arm();
  try {
    arm.chain.require_reachable(commanded);
  } catch (const std::out_of_range& beyond) {
    throw BadCell(fmt::format("{}: {}", cell.file.string(), beyond.what()));
  }
  Posed posed{arm.link_poses(commanded), arm.sphere_at(commanded), {}, {}};
  std::uint64_t queries = 0;
  Process still;
  still.transfers.push_back({0, StationSlot::Storage, 0, 0, {}, workcell.at(StationSlot::Storage).material});
  posed.hindrance = Sweep(workcell).at_rest(commanded, still.transfers.back(), queries);
  still.stops.push_back({0, commanded, posed.sphere, {}, {}});
  posed.separation = separation_of(workcell, still);
  return posed;
}

std::vector<Tried> Simulator::area(const Setting& setting, std::size_t radii) const {
  Cell cell = cell_;
  cell.step = setting.step;
  cell.material.slot = setting.slot;
  std::vector<Tried> tried;
  if (const auto& stand = cell.storage.stand; stand && stand->top <= -setting.height) return tried;
  for (std::size_t i = 0; i < radii; ++i)
    tried.push_back(try_place(cell, parts_, arm_, rule_for(setting), setting.angle,
                              (static_cast<double>(i) + 0.5) / static_cast<double>(radii) * longest(cell_) / 4,
                              setting.height));
  return tried;
}

}  // namespace touchstone::cell::browser
