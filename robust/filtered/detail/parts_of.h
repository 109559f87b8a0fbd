// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/filtered.h"

namespace touchstone::filtered {

/// Returns what was prepared; its type is complete in prepared.h. Requires a polygon that was not moved from.
[[nodiscard]] inline const PreparedPolygon::Parts& parts_of(const PreparedPolygon& polygon) { return *polygon.parts_; }

}  // namespace touchstone::filtered
