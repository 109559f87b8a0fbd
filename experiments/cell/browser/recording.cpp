// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/browser/recording.h"

#include <array>
#include <utility>

#include "experiments/cell/model/solid_faces.h"

namespace touchstone::cell::browser {
// The material follows the flange while the gripper has it.
std::vector<Snapshot> snapshots_of(const Workcell& workcell, const Process& process) {
  std::array<scene::Scene, 2> materials, copies;
  for (const StationSlot slot : {StationSlot::Storage, StationSlot::Machine}) {
    materials[static_cast<std::size_t>(slot)].add("material", workcell.at(slot).faces);
    copies[static_cast<std::size_t>(slot)].add("material", workcell.at(slot).virtual_faces);
  }
  std::vector<Snapshot> snapshots;
  auto transfer = process.transfers.begin();
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    const Stop& stop = process.stops[i];
    const bool handed_over = transfer + 1 != process.transfers.end() && (transfer + 1)->stop <= i;
    const bool found_copy = stop.target && transfer->slot != stop.target;
    if (handed_over) ++transfer;
    Snapshot snapshot{workcell.arm().link_poses(stop.commanded), {}, transfer->slot, {}};
    snapshot.material =
        snapshot.slot ? workcell.at(*snapshot.slot).pose : within(snapshot.links.back(), *transfer->in_flange);
    if (stop.target)
      snapshot.nearest = (found_copy ? copies : materials)[static_cast<std::size_t>(*stop.target)].nearest(stop.sphere);
    snapshots.push_back(std::move(snapshot));
  }
  return snapshots;
}

Simulator::Simulator(Cell cell, SimulatorOptions options)
    : cell_(std::move(cell)),
      parts_(build_model(cell_)),
      options_(std::move(options)),
      arm_(std::make_shared<const std::vector<Covered>>(cover_arm(parts_, options_.overhang))) {}

Recording Simulator::run(const Setting& setting) const {
  Recording recording{
      .cell = changed(cell_, setting), .parts = parts_, .places = {}, .process = {}, .snapshots = {}, .comparison = {}};
  if (setting.height != cell_.storage.height && cell_.storage.stand)
    for (ModelPart& part : recording.parts)
      if (part.name == "storage/stand") part.faces = faces_of(stand_of(recording.cell.storage), part.name);
  const Workcell workcell(recording.cell, recording.parts, arm_);
  for (const StationSlot slot : {StationSlot::Storage, StationSlot::Machine})
    recording.places.push_back({workcell.at(slot).pose.rotation,
                                workcell.at(slot).pose.translation + Eigen::Vector3d(0, 0, workcell.at(slot).drop)});
  recording.process = simulate(workcell, options_.rule);
  recording.snapshots = snapshots_of(workcell, recording.process);
  recording.comparison = compare_methods(workcell, recording.process, options_.methods, true);
  return recording;
}

}  // namespace touchstone::cell::browser
