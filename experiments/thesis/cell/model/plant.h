// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/thesis/cell/model/cell.h"
#include "geometry/shapes/pose.h"

namespace touchstone::cell {

/// The checked contents of a cell file: any number of robots, storages, machines, pieces of material, obstacles and
/// virtual objects, in the frame of the floor.
///
/// Robots take turns: the pieces are handled one after the other, each by its robot, from its storage to its
/// machine and back. Each process ends as it began, with all robots at home and all pieces in their slots, so each is a
/// Cell of its own.
struct Plant {
  struct PlacedRobot {
    std::string name;
    Pose frame;   ///< of the robot: moved and turned on the floor
    double turn;  ///< degrees of that turn
    Robot robot;
    Gripper gripper;
  };
  /// A station stands about the axis of a robot.
  struct PlacedStation {
    Station station;
    std::size_t robot;
  };
  /// A piece, and what handles it.
  struct Piece {
    std::string name, key;  ///< key: its path in the file
    Material material;
    std::size_t robot, storage, machine;
  };

  std::filesystem::path file;
  std::string name;
  workloads::Unit unit;
  double step, clearance;
  std::vector<PlacedRobot> robots = {};                     ///< at least one
  std::vector<PlacedStation> storages = {}, machines = {};  ///< at least one each
  std::vector<Piece> pieces = {};                           ///< at least one
  std::vector<Part> obstacles = {};
  std::vector<Zone> zones = {};
  std::map<std::string, Label> labels = {};
};

/// Returns what one robot does with one piece, in the frame of that robot: everything else stands about it. Labels of
/// its robot, storage, machine and piece are also found under `robot`, `gripper`, `storage`, `machine` and `material`.
[[nodiscard]] Cell cell_of(const Plant& plant, std::size_t piece);

}  // namespace touchstone::cell
