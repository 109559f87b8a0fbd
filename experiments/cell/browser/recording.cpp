// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/browser/recording.h"

#include <array>
#include <utility>

#include "experiments/cell/model/solid_faces.h"

namespace touchstone::cell::browser {
namespace {

/// The material follows the flange while the gripper has it.
std::vector<Look> looks_of(const Workcell& workcell, const Process& process) {
  std::array<scene::Scene, 2> materials;
  for (const Place place : {Place::Storage, Place::Machine})
    materials[static_cast<std::size_t>(place)].add("material", workcell.at(place).faces);

  std::vector<Look> looks;
  Pose held;  // in the flange's frame
  auto custody = process.custody.begin();
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    const Stop& stop = process.stops[i];
    Look look{workcell.arm().link_poses(stop.commanded), {}, {}, {}};
    const Pose& flange = look.links.back();
    while (custody + 1 != process.custody.end() && (custody + 1)->stop <= i) {
      const auto from = custody->place;
      ++custody;
      if (!from || custody->place) continue;
      const Pose& at = workcell.at(*from).pose;
      const Eigen::Matrix3d back = flange.rotation.transpose();
      held = {back * at.rotation, back * (at.translation - flange.translation)};
    }
    look.place = custody->place;
    look.material =
        look.place ? workcell.at(*look.place).pose
                   : Pose{flange.rotation * held.rotation, flange.rotation * held.translation + flange.translation};
    if (stop.target) look.nearest = materials[static_cast<std::size_t>(*stop.target)].nearest(stop.sphere);
    looks.push_back(std::move(look));
  }
  return looks;
}

}  // namespace

Simulator::Simulator(Cell cell, Manner manner)
    : cell_(std::move(cell)),
      parts_(build_model(cell_)),
      manner_(std::move(manner)),
      arm_(std::make_shared<const std::vector<Covered>>(cover_arm(parts_, manner_.overhang))) {}

Recording Simulator::run(const Setting& setting) const {
  Recording recording{
      .cell = changed(cell_, setting), .parts = parts_, .places = {}, .process = {}, .looks = {}, .contest = {}};
  if (setting.height != cell_.storage.height && cell_.storage.stand)
    for (ModelPart& part : recording.parts)
      if (part.name == "storage/stand") part.faces = faces_of(stand_of(recording.cell.storage), part.name);
  const Workcell workcell(recording.cell, recording.parts, arm_);
  for (const Place place : {Place::Storage, Place::Machine}) recording.places.push_back(workcell.at(place).pose);
  recording.process = perform(workcell);
  recording.looks = looks_of(workcell, recording.process);
  recording.contest = hold_contest(workcell, recording.process, manner_.methods, true);
  return recording;
}

}  // namespace touchstone::cell::browser
