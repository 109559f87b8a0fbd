// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/figures/case_study.h"
#include "experiments/thesis/figures/outlines.h"

/// The cell in the form that pictures need.
namespace touchstone::figures {

/// Returns the largest face of the gripper with most corners, its jaws side by side, as a counter-clockwise loop in its
/// own plane: x along the cell's, y up.
[[nodiscard]] Outline gripper_outline(const std::vector<cell::ModelPart>& parts);
/// Returns the same face with the flange at a pose.
[[nodiscard]] Polygon gripper_face(const std::vector<cell::ModelPart>& parts, const Pose& flange);

/// Returns for each part its carrier, vertices, triangles that cover its faces, and the faces' loops; in its own frame.
[[nodiscard]] nlohmann::ordered_json drawn_parts(const std::vector<cell::ModelPart>& parts);

/// Returns for each part that is a Boolean its operands, as above.
[[nodiscard]] nlohmann::ordered_json drawn_primitives(const std::vector<cell::Part>& parts);

/// Returns for each moment the poses of links (rotation, row by row, and translation), storage, machine, material and
/// sphere in the cell.
[[nodiscard]] nlohmann::ordered_json drawn_moments(const CaseStudy& study);

}  // namespace touchstone::figures
