// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/cell/kinematics/chain.h"
#include "experiments/cell/model/model.h"
#include "experiments/studies/stability/outlines.h"
#include "experiments/thesis/case_study.h"

/// The cell as pictures need it.
namespace touchstone::thesis_figures {

/// The arm of a cell. Requires joints that turn, and at most one coupling: the joint before, with factor 1.
[[nodiscard]] kinematics::Chain chain_of(const cell::Robot& robot);

/// The largest face of the gripper with most corners, its jaws side by side, as a loop in its own plane that runs
/// counter-clockwise: x along the cell's, y up.
[[nodiscard]] stability::Outline gripper_outline(const std::vector<cell::ModelPart>& parts);
/// The same face where the hand has it after these commands.
[[nodiscard]] Polygon gripper_face(const cell::Cell& cell, const std::vector<cell::ModelPart>& parts,
                                   const kinematics::Angles& commanded);

/// By part: what it moves with, vertices, triangles that cover its faces, and the faces' loops; in its own frame.
[[nodiscard]] nlohmann::ordered_json drawn_parts(const std::vector<cell::ModelPart>& parts);

/// By part that is a Boolean of others: these, as above.
[[nodiscard]] nlohmann::ordered_json drawn_primitives(const std::vector<cell::Part>& parts);

/// By moment: where links (rotation, row by row, and translation), storage, machine, material and sphere stand, in the
/// cell. The storage stands where the case study has it.
[[nodiscard]] nlohmann::ordered_json drawn_moments(const cell::Cell& cell, const CaseStudy& study);

}  // namespace touchstone::thesis_figures
