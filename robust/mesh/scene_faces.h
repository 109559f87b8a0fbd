// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../geometry/shapes/mesh.h"
#include "../scene/scene.h"
#include "merge.h"

namespace touchstone::mesh {

/// The faces of a mesh as an object of a scene.
struct SceneFaces {
  scene::Faces faces;                 ///< for scene::Scene::add
  std::vector<std::uint32_t> merged;  ///< by the number of a face in the scene: its place in MergedMesh::faces
};

/// A merged face of at least `least` faces of the mesh comes as one polygon, one of fewer as the faces that it was
/// merged from. What has three vertices comes as a triangle. Rejected faces are left out.
///
/// Requires the mesh that was merged. Cost: linear.
[[nodiscard]] SceneFaces scene_faces(const Mesh& mesh, const MergedMesh& merged, std::size_t least = 2);

}  // namespace touchstone::mesh
