// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/browser/recording.h"

#include <array>
#include <utility>

#include "experiments/cell/model/solid_faces.h"

namespace touchstone::cell::browser {
namespace {

/// The material follows the flange while the gripper has it.
std::vector<Snapshot> snapshots_of(const Workcell& workcell, const Process& process) {
  std::array<scene::Scene, 2> materials;
  for (const StationSlot slot : {StationSlot::Storage, StationSlot::Machine})
    materials[static_cast<std::size_t>(slot)].add("material", workcell.at(slot).faces);

  std::vector<Snapshot> snapshots;
  Pose held;  // in the flange's frame
  auto transfer = process.transfers.begin();
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    const Stop& stop = process.stops[i];
    Snapshot snapshot{workcell.arm().link_poses(stop.commanded), {}, {}, {}};
    const Pose& flange = snapshot.links.back();
    while (transfer + 1 != process.transfers.end() && (transfer + 1)->stop <= i) {
      const auto from = transfer->slot;
      ++transfer;
      if (!from || transfer->slot) continue;
      const Pose& at = workcell.at(*from).pose;
      const Eigen::Matrix3d back = flange.rotation.transpose();
      held = {back * at.rotation, back * (at.translation - flange.translation)};
    }
    snapshot.slot = transfer->slot;
    snapshot.material =
        snapshot.slot ? workcell.at(*snapshot.slot).pose
                      : Pose{flange.rotation * held.rotation, flange.rotation * held.translation + flange.translation};
    if (stop.target) snapshot.nearest = materials[static_cast<std::size_t>(*stop.target)].nearest(stop.sphere);
    snapshots.push_back(std::move(snapshot));
  }
  return snapshots;
}

}  // namespace

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
    recording.places.push_back(workcell.at(slot).pose);
  recording.process = simulate(workcell);
  recording.snapshots = snapshots_of(workcell, recording.process);
  recording.comparison = compare_methods(workcell, recording.process, options_.methods, true);
  return recording;
}

}  // namespace touchstone::cell::browser
