// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/program/sweep.h"
#include "experiments/thesis/cell/first_contact/missed_study.h"
#include "experiments/thesis/cell/kinematics/layout_study.h"
#include "experiments/thesis/cell/model/link_model.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/figures/angle_sum.h"
#include "experiments/thesis/figures/case_study.h"
#include "experiments/thesis/figures/false_areas.h"
#include "experiments/thesis/figures/flowchart.h"
#include "experiments/thesis/figures/known_errors.h"
#include "experiments/thesis/figures/predictions.h"
#include "experiments/thesis/figures/reconfiguration.h"

/// The computations of `touchstone thesis`, done once for all of its entries.
namespace touchstone::figures {

struct Settings {
  std::uint64_t samples = 20'000;  ///< balls for each outline and radius; other measurements use a share of it
  std::uint64_t seed = 1;
  int angle_step = 5;                    ///< degrees, of the area of configuration
  int radius_step = 25;                  ///< mm
  int radius_scan = 5, height_scan = 5;  ///< mm, for the radii and heights at one angle
  int home_step = 10;                    ///< degrees, between home poses
};

/// The round trip of a model file: written, and read again.
struct LinkFile {
  cell::LinkModel model;
  std::string text;
  bool same = false;  ///< whether reading it again gives the same model
};

struct Study {
  Settings settings;
  cell::Cell cell;  ///< in case 1
  std::vector<cell::ModelPart> parts;
  std::shared_ptr<const std::vector<cell::Covered>> covered;
  std::vector<LinkFile> link_files;  ///< for every link, and for the machine's bottom part
  std::vector<Outline> outlines;     ///< the gripper's first, then those of outlines.h

  // Chapter 4
  std::vector<Flowchart> flowcharts;       ///< outline by outline, radius by radius
  FootErrors feet;                         ///< on the gripper's front, where it touches in case 1
  EdgePlaces edges;                        ///< on the gripper
  std::vector<Prediction> predictions;     ///< of the chosen layout, which the cell is
  std::vector<Sensitivity> sensitivities;  ///< of its parameters, in their order

  // Chapters 5 and 6
  std::array<CaseStudy, 2> cases;
  /// Home poses, for the chosen linkage, and those that have a layout in which both cases' captions are reproduced.
  std::vector<kinematics::Member> homes;
  FloorPlan plan;
  std::vector<cell::Tried> area;                    ///< angle by angle, radius by radius, at the chosen height
  std::vector<cell::Tried> area_of_sphere;          ///< the same by the sphere alone
  std::vector<cell::Tried> radii;                   ///< at case 1's angle and height, its own radius among them
  std::array<std::vector<cell::Tried>, 2> heights;  ///< at each case's angle and radius, its own height among them
  std::array<std::vector<cell::Tried>, 2> heights_of_sphere;

  // Known errors
  AngleMap map;                  ///< around the gripper
  std::vector<FalseArea> areas;  ///< in the order of `outlines`
  std::vector<FactorReach> square_reach, gripper_reach;
  NotNumbers not_numbers;
  std::array<Touching, 3> touching;  ///< in the order of Touched
  Collinear collinear;
  std::vector<FarAway> far_away;
  kinematics::MissedStudy missed;

  [[nodiscard]] const Outline& gripper() const { return outlines.front(); }
  /// Returns the flowchart of an outline, by its index in `outlines`, and a radius, by its index in kRadii.
  [[nodiscard]] const Flowchart& flowchart(std::size_t outline, std::size_t radius) const {
    return flowcharts[outline * kRadii.size() + radius];
  }
};

/// Receives the share of the work that is done.
using StudyProgress = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// Computes the parts that need neither samples nor time: the model and the case studies, which are the presets `case
/// 1` and `case 2` of the Aristo's cell, with these changes (change_cell.h). The other parts are empty.
///
/// Throws cell::BadCell if the cell's file (in the source tree) cannot be read.
[[nodiscard]] Study begin_study(const Settings& settings, const std::vector<std::string>& changes = {});

/// Computes all parts; returns nothing if it was stopped. The result does not depend on the number
/// of threads.
///
/// Throws as begin_study does. Cost: about 100 s of one core with the default settings.
[[nodiscard]] std::optional<Study> run_study(const Settings& settings, unsigned threads, const std::atomic<bool>& stop,
                                             const StudyProgress& progress);

}  // namespace touchstone::figures
