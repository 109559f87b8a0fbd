// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/thesis/cell/area.h"
#include "experiments/thesis/cell/browser/setting.h"
#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/plant.h"
#include "experiments/thesis/cell/simulation/method_comparison.h"
#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/separation.h"
#include "experiments/thesis/cell/simulation/sweep.h"
#include "experiments/thesis/cell/simulation/timing.h"
#include "experiments/thesis/cell/simulation/workcell.h"
#include "geometry/shapes/pose.h"
#include "robust/scene/scene.h"

namespace touchstone::cell::browser {

/// The state of the cell at a stop, and the answer there.
struct Snapshot {
  std::vector<Pose> links;          ///< as in Robot::links, in the cell
  Pose material;                    ///< in the cell
  std::optional<StationSlot> slot;  ///< where the material is; none while the gripper holds it
  /// The exact nearest face of the target, if there is one, to the sphere's centre.
  std::optional<scene::NearestFace> nearest;
  std::array<double, 2> closed = {0, 0};  ///< the ways by which the fingers have closed
};

/// A run of the process, ready to be drawn.
struct Recording {
  Cell cell;                          ///< with the setting applied
  std::vector<ModelPart> parts = {};  ///< of the cell
  std::vector<Pose> places = {};      ///< of the virtual material in the cell, by StationSlot
  std::string drive;                  ///< the method whose answer stopped the robot
  Process process = {};
  std::vector<Snapshot> snapshots = {};  ///< one for each stop
  Timing timing = {};
  Separation separation = {};
  std::optional<Snapshot> stuck = {};  ///< the arm where it gets stuck, if it does
  MethodComparison comparison = {};
};

/// Returns the state of the cell at every stop.
[[nodiscard]] std::vector<Snapshot> snapshots_of(const Workcell& workcell, const Process& process);

/// The options of runs that do not depend on the setting.
struct SimulatorOptions {
  std::vector<const cases::Method*> methods = {};  ///< asked about every face, besides the exact answer
  Rule rule = {};
  std::shared_ptr<const Plant> plant = {};  ///< of which the cell is one piece's; none if it is all there is
  std::size_t piece = 0;                    ///< the number of that piece
};

/// The arm at some pose, and what it touches or is near to.
struct Posed {
  std::vector<Pose> links;
  Ball sphere;
  std::optional<Hindrance> hindrance;
  Separation separation;  ///< of one stop
};

/// A cell that can be run with changed settings. Running is thread-safe.
class Simulator {
 public:
  /// Throws what build_model throws. Cost: that of build_model and cover_arm.
  Simulator(Cell cell, SimulatorOptions options);

  [[nodiscard]] const Cell& cell() const { return cell_; }
  [[nodiscard]] const Plant* plant() const { return options_.plant.get(); }
  [[nodiscard]] std::size_t piece() const { return options_.piece; }
  [[nodiscard]] const std::vector<ModelPart>& parts() const { return parts_; }

  /// Runs the process with a setting. Throws BadCell for an impossible cell, as `changed` and Workcell do. A process
  /// that does not complete is recorded too; its `failure` says why.
  [[nodiscard]] Recording run(const Setting& setting) const;
  /// Returns the arm at a pose, with the material in storage. Throws as run does, and BadCell for a joint beyond its
  /// limits.
  [[nodiscard]] Posed pose(const Setting& setting, const kinematics::Angles& commanded) const;
  /// Runs the process with the storage at the setting's angle and at a number of radii, in the middles of equal parts
  /// of the arm's reach; at none if its stand would be below the floor.
  [[nodiscard]] std::vector<Tried> area(const Setting& setting, std::size_t radii) const;

  /// The cell's own setting.
  [[nodiscard]] Setting setting() const;
  /// The names of the methods that may drive: the exact answer and those that are asked.
  [[nodiscard]] std::vector<std::string> drives() const;
  /// How many joints turn.
  [[nodiscard]] std::size_t joints() const { return arm_of(cell_).home.size(); }

 private:
  [[nodiscard]] std::vector<ModelPart> parts_for(const Cell& cell) const;
  [[nodiscard]] Rule rule_for(const Setting& setting) const;

  Cell cell_;
  std::vector<ModelPart> parts_;
  SimulatorOptions options_;
  std::shared_ptr<const std::vector<Covered>> arm_;
};

}  // namespace touchstone::cell::browser
