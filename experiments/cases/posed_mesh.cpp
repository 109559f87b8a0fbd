// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/posed_mesh.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "geometry/shapes/rejection.h"
#include "robust/mesh/scene_faces.h"
#include "robust/scene/posing.h"

namespace touchstone::cases {

PosedMesh::PosedMesh(Mesh mesh, const Pose& pose) : mesh_(std::move(mesh)), pose_(pose), order_(mesh_.faces.size()) {
  assert(!mesh_.faces.empty());
  for (std::size_t i = 0; i < mesh_.vertices.size(); ++i)
    if (!mesh_.vertices[i].allFinite())
      throw Rejected({RejectionCode::NotFinite, fmt::format("vertex {} of the mesh is not finite", i)});
  if (!scene::is_finite(pose_)) throw Rejected({RejectionCode::NotFinite, "the pose is not finite"});
  for (std::size_t face = 0; face < mesh_.faces.size(); ++face) try {
      faces_.push_back(scene::posed(pose_, mesh::face_polygon(mesh_, face)));
    } catch (const Rejected& rejected) {
      const auto& [code, message] = rejected.rejection();
      throw Rejected({code, fmt::format("face {} of the mesh: {}", face, message)});
    }
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_partition(order_.begin(), order_.end(),
                        [this](std::size_t face) { return faces_[face].vertex_count() == 3; });
}

}  // namespace touchstone::cases
