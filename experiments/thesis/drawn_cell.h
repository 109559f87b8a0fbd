// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/cell/kinematics/chain.h"
#include "experiments/cell/model/model.h"
#include "experiments/studies/stability/outlines.h"
#include "experiments/thesis/case_study.h"

/// The cell in the form that pictures need.
namespace touchstone::thesis_figures {

/// Returns the arm of a cell. Requires joints that turn, and at most one coupling: to the previous joint, with factor
/// 1.
[[nodiscard]] kinematics::Chain chain_of(const cell::Robot& robot);

/// Returns the largest face of the gripper with most corners, its jaws side by side, as a counter-clockwise loop in its
/// own plane: x along the cell's, y up.
[[nodiscard]] stability::Outline gripper_outline(const std::vector<cell::ModelPart>& parts);
/// Returns the same face at its place after these commands.
[[nodiscard]] Polygon gripper_face(const cell::Cell& cell, const std::vector<cell::ModelPart>& parts,
                                   const kinematics::Angles& commanded);

/// Returns for each part its carrier, vertices, triangles that cover its faces, and the faces' loops; in its own frame.
[[nodiscard]] nlohmann::ordered_json drawn_parts(const std::vector<cell::ModelPart>& parts);

/// Returns for each part that is a Boolean its operands, as above.
[[nodiscard]] nlohmann::ordered_json drawn_primitives(const std::vector<cell::Part>& parts);

/// Returns for each moment the poses of links (rotation, row by row, and translation), storage, machine, material and
/// sphere in the cell. The storage is at the case study's place.
[[nodiscard]] nlohmann::ordered_json drawn_moments(const cell::Cell& cell, const CaseStudy& study);

}  // namespace touchstone::thesis_figures
