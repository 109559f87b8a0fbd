// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/cases/workloads/meshes/named_meshes.h"
#include "robust/scene/scene.h"

namespace touchstone::scenes {

/// The faces of a mesh that are polygons of the contract.
struct Object {
  std::string name;
  scene::Faces faces;                  ///< triangles first
  std::vector<std::uint32_t> numbers;  ///< indices of these faces in the mesh, from 0
  std::vector<std::string> rejected;   ///< a sentence for each of the first other faces, with its place in the file
  std::uint64_t faces_rejected = 0;    ///< the number of all other faces
};

/// Takes every face of the mesh as it is. Cost: that of exact::validate per face.
[[nodiscard]] Object object_of(workloads::NamedFile file);

}  // namespace touchstone::scenes
