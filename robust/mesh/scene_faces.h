// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../geometry/shapes/mesh.h"
#include "../scene/scene.h"
#include "merge.h"

namespace touchstone::mesh {

/// The faces of a merged mesh, ready to be added to a scene.
struct SceneFaces {
  scene::Faces faces;                 ///< to pass to scene::Scene::add
  std::vector<std::uint32_t> merged;  ///< for each of these faces, its index in MergedMesh::faces
};

/// Returns the faces of a merged mesh for a scene. A merged face made of at least `least` faces of the mesh becomes one
/// polygon; one made of fewer is returned as the faces that it was merged from. Faces with three vertices become
/// triangles. Rejected faces are left out.
///
/// Requires that `merged` is the result of merging `mesh`. Cost: linear.
[[nodiscard]] SceneFaces scene_faces(const Mesh& mesh, const MergedMesh& merged, std::size_t least = 2);

}  // namespace touchstone::mesh
