// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/cell/browser/setting.h"
#include "experiments/cell/model/cell.h"
#include "experiments/cell/model/model.h"
#include "experiments/cell/simulation/contest.h"
#include "experiments/cell/simulation/process.h"
#include "experiments/cell/simulation/workcell.h"
#include "geometry/shapes/pose.h"
#include "robust/scene/scene.h"

namespace touchstone::cell::browser {

/// How the cell looks at a stop, and the answer there.
struct Look {
  std::vector<Pose> links;     ///< as in Robot::links, in the cell
  Pose material;               ///< in the cell
  std::optional<Place> place;  ///< where the material is; none: the gripper has it
  /// Of the sphere's centre and the target, where there is one: the nearest face, exactly.
  std::optional<scene::NearestFace> nearest;
};

/// A run of the process, ready to be drawn.
struct Recording {
  Cell cell;                     ///< as it was set
  std::vector<ModelPart> parts;  ///< of it
  std::vector<Pose> places;      ///< of the material in its slot, in the cell, by Place
  Process process;
  std::vector<Look> looks;  ///< one a stop
  Contest contest;
};

/// How runs are made, whatever the setting.
struct Manner {
  double overhang = 8;                        ///< of the balls that cover the arm, as in BallCover
  std::vector<const cases::Method*> methods;  ///< asked of every face beside the exact answer
};

/// A cell that can be set anew and run. Running is safe from several threads.
class Simulator {
 public:
  /// Throws what build_model throws. Cost: that of build_model and cover_arm.
  Simulator(Cell cell, Manner manner);

  [[nodiscard]] const Cell& cell() const { return cell_; }
  [[nodiscard]] const std::vector<ModelPart>& parts() const { return parts_; }

  /// Throws BadCell where the cell cannot be, as `changed` and Workcell do. A process that does not come out is a
  /// recording all the same; its `failure` says why.
  [[nodiscard]] Recording run(const Setting& setting) const;

 private:
  Cell cell_;
  std::vector<ModelPart> parts_;
  Manner manner_;
  std::shared_ptr<const std::vector<Covered>> arm_;
};

}  // namespace touchstone::cell::browser
