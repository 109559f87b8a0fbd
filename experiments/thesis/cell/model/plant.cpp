// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/plant.h"

#include <cmath>
#include <utility>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/thesis/cell/model/poses.h"

namespace touchstone::cell {
namespace {

/// The parts under a pose, with the names that they have as things that stand.
void add(std::vector<Part>& all, const std::string& owner, const std::vector<Part>& parts, const Pose& pose) {
  for (const Part& part : parts) {
    all.push_back({owner.empty() ? part.name : owner + "/" + part.name, part.solid});
    if (!(pose == Pose{})) all.back().solid.pose = within(pose, part.solid.pose);
  }
}

/// A station as it is about the axis of another robot.
Station about(const Plant::PlacedStation& placed, const Plant& plant, std::size_t robot) {
  Station station = placed.station;
  const Pose &from = plant.robots[placed.robot].frame, &to = plant.robots[robot].frame;
  if (placed.robot == robot || from == to) return station;
  const Pose pose = within(inverse(to), within(from, pose_of(station)));
  const Eigen::Vector3d &at = pose.translation, x = pose.rotation.col(0);
  const double azimuth = workloads::arc_tangent(at.y(), at.x());
  station.radius = std::sqrt(at.x() * at.x() + at.y() * at.y());
  station.home = azimuth - station.angle;
  station.turn = workloads::arc_tangent(x.y(), x.x()) - azimuth;
  return station;
}

Pose slot_pose(const Slot& slot) { return {Eigen::Matrix3d::Identity(), slot.place}; }

/// Labels below one path, also below another; what is there already gives way.
void relabel(std::map<std::string, Label>& labels, const Plant& plant, const std::string& from, const std::string& to) {
  if (from == to) return;
  std::erase_if(labels, [&](const auto& label) {
    return label.first == to || label.first.starts_with(to + ".") || label.first.starts_with(to + "[");
  });
  for (std::size_t length = from.size(); length > 0; --length) {  // the nearest label above
    const auto found = plant.labels.find(from.substr(0, length));
    if (found == plant.labels.end() || (length < from.size() && from[length] != '.' && from[length] != '[')) continue;
    labels[to] = found->second;
    break;
  }
  for (const auto& [path, label] : plant.labels)
    if (path.starts_with(from + ".") || path.starts_with(from + "[")) labels[to + path.substr(from.size())] = label;
}

}  // namespace

Cell cell_of(const Plant& plant, std::size_t number) {
  const Plant::Piece& piece = plant.pieces[number];
  const Plant::PlacedRobot& own = plant.robots[piece.robot];
  Cell cell{.file = plant.file,
            .name = plant.name,
            .unit = plant.unit,
            .robot = own.robot,
            .gripper = own.gripper,
            .storage = about(plant.storages[piece.storage], plant, piece.robot),
            .machine = about(plant.machines[piece.machine], plant, piece.robot),
            .material = piece.material,
            .step = plant.step,
            .clearance = plant.clearance,
            .labels = plant.labels};
  const Pose to_own = inverse(own.frame);
  const bool moved = !(own.frame == Pose{});
  const auto here = [&](const Pose& pose) { return moved ? within(to_own, pose) : pose; };

  for (std::size_t i = 0; i < plant.robots.size(); ++i) {
    if (i == piece.robot) continue;
    const auto& [name, frame, turn, robot, gripper] = plant.robots[i];
    const std::vector<Pose> links = home_poses(robot);
    for (std::size_t k = 0; k < links.size(); ++k)
      add(cell.obstacles, name + "/" + robot.links[k].name, robot.links[k].parts, within(here(frame), links[k]));
    add(cell.obstacles, name + "/gripper", parts_of(gripper), within(here(frame), links.back()));
  }
  const auto add_stations = [&](const std::vector<Plant::PlacedStation>& stations, std::size_t served) {
    for (std::size_t i = 0; i < stations.size(); ++i) {
      if (i == served) continue;
      const Station station = about(stations[i], plant, piece.robot);
      std::vector<Part> parts = station.parts;
      if (station.stand) parts.push_back({"stand", stand_of(station)});
      add(cell.obstacles, station.name, parts, pose_of(station));
    }
  };
  add_stations(plant.storages, piece.storage);
  add_stations(plant.machines, piece.machine);
  for (std::size_t i = 0; i < plant.pieces.size(); ++i) {
    if (i == number) continue;
    const auto& [name, key, material, robot, storage, machine] = plant.pieces[i];
    const Pose in_station = slot_pose(plant.storages[storage].station.slots[material.slot]);
    const Part part{name, material.solid};
    if (storage == piece.storage) {  // it goes where its storage goes
      add(cell.storage.parts, "", {part}, in_station);
    } else {
      const Station station = about(plant.storages[storage], plant, piece.robot);
      add(cell.obstacles, station.name, {part}, within(pose_of(station), in_station));
    }
  }
  for (const Part& obstacle : plant.obstacles) add(cell.obstacles, "", {obstacle}, here(Pose{}));
  for (Zone zone : plant.zones) {
    zone.pose = here(zone.pose);
    cell.zones.push_back(std::move(zone));
  }

  relabel(cell.labels, plant, own.robot.key, "robot");
  if (own.robot.key != "robot") relabel(cell.labels, plant, own.robot.key + ".gripper", "gripper");
  relabel(cell.labels, plant, cell.storage.key, "storage");
  relabel(cell.labels, plant, cell.machine.key, "machine");
  relabel(cell.labels, plant, piece.key, "material");
  return cell;
}

}  // namespace touchstone::cell
