// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/shapes/mesh.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/pose.h"

namespace touchstone::cases {

/// A mesh under a pose. Every face is valid, as the mesh has it and posed.
class PosedMesh {
 public:
  /// Poses the faces (posing.h), of which there must be one. Throws Rejected: `not-finite` if a vertex or the pose is
  /// not finite, and else the rejection of the first bad face, which the message names.
  explicit PosedMesh(Mesh mesh, const Pose& pose = {});

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// Returns the faces of the mesh with their posed vertices.
  [[nodiscard]] const std::vector<Polygon>& faces() const { return faces_; }
  /// Returns the numbers of the faces, the first of equals first: faces of three vertices, then the others, ascending.
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }

 private:
  Mesh mesh_;
  Pose pose_;
  std::vector<Polygon> faces_;
  std::vector<std::size_t> order_;
};

}  // namespace touchstone::cases
