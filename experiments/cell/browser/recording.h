// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/cell/browser/setting.h"
#include "experiments/cell/model/cell.h"
#include "experiments/cell/model/model.h"
#include "experiments/cell/simulation/method_comparison.h"
#include "experiments/cell/simulation/process.h"
#include "experiments/cell/simulation/workcell.h"
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
};

/// A run of the process, ready to be drawn.
struct Recording {
  Cell cell;                     ///< with the setting applied
  std::vector<ModelPart> parts;  ///< of the cell
  std::vector<Pose> places;      ///< of the virtual material in the cell, by StationSlot
  Process process;
  std::vector<Snapshot> snapshots;  ///< one for each stop
  MethodComparison comparison;
};

/// Returns the state of the cell at every stop.
[[nodiscard]] std::vector<Snapshot> snapshots_of(const Workcell& workcell, const Process& process);

/// The options of runs that do not depend on the setting.
struct SimulatorOptions {
  double overhang = 8;                        ///< of the balls that cover the arm, as in BallCover
  std::vector<const cases::Method*> methods;  ///< asked about every face, besides the exact answer
  Rule rule;
};

/// A cell that can be run with changed settings. Running is thread-safe.
class Simulator {
 public:
  /// Throws what build_model throws. Cost: that of build_model and cover_arm.
  Simulator(Cell cell, SimulatorOptions options);

  [[nodiscard]] const Cell& cell() const { return cell_; }
  [[nodiscard]] const std::vector<ModelPart>& parts() const { return parts_; }

  /// Runs the process with a setting. Throws BadCell for an impossible cell, as `changed` and Workcell do. A process
  /// that does not complete is recorded too; its `failure` says why.
  [[nodiscard]] Recording run(const Setting& setting) const;

 private:
  Cell cell_;
  std::vector<ModelPart> parts_;
  SimulatorOptions options_;
  std::shared_ptr<const std::vector<Covered>> arm_;
};

}  // namespace touchstone::cell::browser
