// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/plant.h"

namespace touchstone::cell::browser {

/// Returns what a cell file consists of: [{kind, key, name, listed, fields: [{path, value}]}]. A field is a number, an
/// array of numbers or true or false that the page can change by `path=value`; what is listed can be removed by
/// `key=null`.
[[nodiscard]] nlohmann::ordered_json elements_json(const Plant& plant);

/// Returns the virtual objects as they are drawn: [{name, stops, points, triangles, face_ends, outline}], in the cell.
[[nodiscard]] nlohmann::ordered_json zones_json(const Cell& cell);

}  // namespace touchstone::cell::browser
