// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "experiments/thesis/cell/model/model.h"

// What the page draws: pictures only, never answers.
namespace touchstone::cell::browser {

/// Returns the shortest number that is read as the nearest float.
[[nodiscard]] double drawn(double value);
[[nodiscard]] nlohmann::ordered_json drawn(const Eigen::Vector3d& at);

/// Returns the faces of a part: {name, carrier, link, points, triangles, face_ends, outline}, in flat arrays.
/// `face_ends` holds for each face one past the last of its triangles, `outline` the edges at which faces meet at more
/// than 20 degrees, and those that do not have exactly two faces.
[[nodiscard]] nlohmann::ordered_json part_json(const ModelPart& part);

/// Returns the virtual objects: [{name, stops, points, triangles, face_ends, outline}], in the cell.
[[nodiscard]] nlohmann::ordered_json zones_json(const Cell& cell);

}  // namespace touchstone::cell::browser
