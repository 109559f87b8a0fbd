// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/scene_faces.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "geometry/detail/floating_point_state.h"
#include "robust/exact/validate.h"
#include "robust/filtered/detail/triangle/exact_triangle.h"
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

/// Returns the corners that are the vertices of the degenerate triangle of a loop; nothing if its corners do not all
/// lie on one line, or are not finite. Ends are the first corners there. Not inlined into a handler of exceptions,
/// where the object code does not show that the floating-point state is set.
__attribute__((noinline)) std::optional<std::array<std::uint32_t, 3>> corners_on_line(const Loop& loop) {
  const auto before = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  const auto is_finite = [](const Eigen::Vector3d& corner) { return corner.allFinite(); };
  if (loop.size() < 3 || !std::ranges::all_of(loop, is_finite)) return std::nullopt;
  const auto low = std::ranges::min_element(loop, before);
  const auto high = std::ranges::max_element(loop, before);
  for (const Eigen::Vector3d& corner : loop) {
    const double triangle[3][3] = {
        {low->x(), low->y(), low->z()}, {high->x(), high->y(), high->z()}, {corner.x(), corner.y(), corner.z()}};
    if (!filtered::detail::is_degenerate(triangle)) return std::nullopt;
  }
  if (loop.size() == 3) return {{0, 1, 2}};
  const auto [first, last] = std::minmax({low - loop.begin(), high - loop.begin()});
  return {{static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), static_cast<std::uint32_t>(last)}};
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
  const FloatingPointState nearest;
  const bool as_segments = on_bad_face == OnBadFace::AsSegments || on_bad_face == OnBadFace::AsSegmentsOrLeaveOut;
  const bool leaves_out = on_bad_face == OnBadFace::LeaveOut || on_bad_face == OnBadFace::AsSegmentsOrLeaveOut;
  NumberedFaces valid;
  std::vector<RejectedFace> left_out;
  std::vector<SegmentFace> segments;
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
      if (as_segments && code != RejectionCode::MalformedCase) {
        const Loop loop = loop_of(mesh, face);
        if (const auto corners = corners_on_line(loop)) {
          const auto& [i, j, k] = *corners;
          valid.add(Triangle{loop[i], loop[j], loop[k]}, face);
          segments.push_back({face, *corners});
          continue;
        }
      }
      if (!leaves_out) throw Rejected({code, "face " + std::to_string(face) + " of the mesh: " + message});
      left_out.push_back({face, rejected.rejection()});
    }
  }
  if (as_segments) valid.faces().degenerate = Degenerate::AsSegments;
  return {std::move(valid.faces()), std::move(valid.numbers()), std::move(left_out), std::move(segments)};
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
