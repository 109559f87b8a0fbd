// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/scene_faces.h"

#include <string>
#include <utility>

#include "robust/exact/validate.h"
#include "robust/scene/posing.h"

namespace touchstone::mesh {

namespace {

Loop loop_of(const Mesh& mesh, std::size_t face) {
  Loop loop;
  for (const std::uint32_t vertex : mesh.faces[face]) {
    if (vertex >= mesh.vertices.size())
      throw Rejected(
          {RejectionCode::MalformedCase,
           "vertex " + std::to_string(vertex) + " is out of range: there are " + std::to_string(mesh.vertices.size())});
    loop.push_back(mesh.vertices[vertex]);
  }
  return loop;
}

/// Faces as scenes number them, triangles before polygons, and a number for each.
class NumberedFaces {
 public:
  void add(const Triangle& triangle, std::uint32_t number) {
    faces_.triangles.push_back(triangle);
    of_triangles_.push_back(number);
  }
  void add(Polygon polygon, std::uint32_t number) {
    if (polygon.vertex_count() == 3) return add({polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)}, number);
    faces_.polygons.push_back(std::move(polygon));
    of_polygons_.push_back(number);
  }
  scene::Faces& faces() { return faces_; }
  std::vector<std::uint32_t>& numbers() {
    of_triangles_.insert(of_triangles_.end(), of_polygons_.begin(), of_polygons_.end());
    return of_triangles_;
  }

 private:
  scene::Faces faces_;
  std::vector<std::uint32_t> of_triangles_, of_polygons_;
};

}  // namespace

Polygon face_polygon(const Mesh& mesh, std::size_t face) {
  Polygon polygon(loop_of(mesh, face));
  if (auto rejection = exact::validate(polygon)) throw Rejected(std::move(*rejection));
  return polygon;
}

MeshFaces scene_faces(const Mesh& mesh, OnBadFace on_bad_face) {
  NumberedFaces valid;
  std::vector<RejectedFace> left_out;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    try {
      if (mesh.faces[face].size() != 3) {
        valid.add(face_polygon(mesh, face), face);
        continue;
      }
      const Loop loop = loop_of(mesh, face);
      const Triangle triangle{loop[0], loop[1], loop[2]};
      scene::expect_valid(triangle);
      valid.add(triangle, face);
    } catch (const Rejected& rejected) {
      const auto& [code, message] = rejected.rejection();
      if (on_bad_face == OnBadFace::Refuse)
        throw Rejected({code, "face " + std::to_string(face) + " of the mesh: " + message});
      left_out.push_back({face, rejected.rejection()});
    }
  }
  return {std::move(valid.faces()), std::move(valid.numbers()), std::move(left_out)};
}

SceneFaces scene_faces(const Mesh& mesh, const MergedMesh& merged, std::size_t least) {
  NumberedFaces result;
  for (std::uint32_t number = 0; number < merged.faces.size(); ++number) {
    const MergedFace& face = merged.faces[number];
    if (face.faces.size() >= least) {
      result.add(face.polygon, number);
      continue;
    }
    for (const std::uint32_t part : face.faces) result.add(Polygon(loop_of(mesh, part)), number);
  }
  return {std::move(result.faces()), std::move(result.numbers())};
}

}  // namespace touchstone::mesh
