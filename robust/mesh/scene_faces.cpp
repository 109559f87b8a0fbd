// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/scene_faces.h"

#include <utility>

namespace touchstone::mesh {

SceneFaces scene_faces(const Mesh& mesh, const MergedMesh& merged, std::size_t least) {
  SceneFaces result;
  std::vector<std::uint32_t> of_polygons;  // scenes number triangles before polygons
  const auto add = [&](const Polygon& polygon, std::uint32_t number) {
    if (polygon.vertex_count() == 3) {
      result.faces.triangles.push_back({polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)});
      result.merged.push_back(number);
    } else {
      result.faces.polygons.push_back(polygon);
      of_polygons.push_back(number);
    }
  };
  for (std::uint32_t number = 0; number < merged.faces.size(); ++number) {
    const MergedFace& face = merged.faces[number];
    if (face.faces.size() >= least) {
      add(face.polygon, number);
      continue;
    }
    for (const std::uint32_t part : face.faces) {
      Loop loop;
      for (const std::uint32_t vertex : mesh.faces[part]) loop.push_back(mesh.vertices[vertex]);
      add(Polygon(loop), number);
    }
  }
  result.merged.insert(result.merged.end(), of_polygons.begin(), of_polygons.end());
  return result;
}

}  // namespace touchstone::mesh
