// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "geometry/shapes/mesh.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::workloads {

/// Returns the face as a polygon of the contract. Throws Rejected.
[[nodiscard]] Polygon face_polygon(const Mesh& mesh, std::uint64_t face);

}  // namespace touchstone::workloads
