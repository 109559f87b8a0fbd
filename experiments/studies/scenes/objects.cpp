// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/scenes/objects.h"

#include <fmt/core.h>

#include <utility>

#include "experiments/cases/workloads/meshes/face_polygon.h"

namespace touchstone::scenes {

Object object_of(workloads::NamedFile file) {
  Object object{std::move(file.name), {}, {}, {}, 0};
  const Mesh& mesh = file.content.mesh;
  std::vector<std::uint32_t> polygons;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    try {
      Polygon polygon = workloads::face_polygon(mesh, face);
      if (polygon.vertex_count() == 3) {
        object.faces.triangles.push_back({polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)});
        object.numbers.push_back(face);
      } else {
        object.faces.polygons.push_back(std::move(polygon));
        polygons.push_back(face);
      }
    } catch (const Rejected& rejected) {
      if (object.faces_rejected++ >= kMostSentences) continue;
      const auto& [code, message] = rejected.rejection();
      object.rejected.push_back(io::sentence(file.file, file.content.places[face],
                                             fmt::format("face {}: {}: {}", face, to_string(code), message)));
    }
  }
  object.numbers.insert(object.numbers.end(), polygons.begin(), polygons.end());
  return object;
}

}  // namespace touchstone::scenes
