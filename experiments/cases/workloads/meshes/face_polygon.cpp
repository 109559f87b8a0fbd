// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/meshes/face_polygon.h"

#include <utility>

#include "geometry/shapes/rejection.h"
#include "robust/exact/validate.h"

namespace touchstone::workloads {

Polygon face_polygon(const Mesh& mesh, std::uint64_t face) {
  Loop loop;
  for (const std::uint32_t vertex : mesh.faces[face]) loop.push_back(mesh.vertices[vertex]);
  Polygon polygon(loop);
  if (auto rejection = exact::validate(polygon)) throw Rejected(std::move(*rejection));
  return polygon;
}

}  // namespace touchstone::workloads
