// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/shapes/polygon.h"

namespace touchstone::exact::detail {

/// Returns the axis of the largest component of the outer loop's Newell normal, the lowest on a tie, decided exactly;
/// nothing if the normal is zero. Cost: linear.
[[nodiscard]] std::optional<int> dropped_axis(const Polygon& polygon);

}  // namespace touchstone::exact::detail
