// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL triangulates. Own code only tells which triangles are inside: CGAL 5.5, that of Debian 12, has no function for
// it.
#include "experiments/methods/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/detail/floating_point_state.h"
#include "robust/exact/detail/edge_sweep.h"
#include "robust/mesh/detail/face_plane.h"

namespace touchstone::methods {
namespace {

constexpr int kUnseen = -1;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
/// The depth of a face: the number of edges of the polygon between it and the outside.
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

/// Computes depths from the infinite face inwards; each edge of the polygon adds one.
void measure_depths(Triangulation& triangulation) {
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
    face->info() = kUnseen;
  std::vector<Triangulation::Face_handle> level{triangulation.infinite_face()};
  for (int depth = 0; !level.empty(); ++depth) {
    std::vector<Triangulation::Face_handle> behind;
    while (!level.empty()) {
      const Triangulation::Face_handle face = level.back();
      level.pop_back();
      if (face->info() != kUnseen) continue;
      face->info() = depth;
      for (int i = 0; i < 3; ++i) {
        const Triangulation::Face_handle other = face->neighbor(i);
        if (other->info() == kUnseen) (face->is_constrained(i) ? behind : level).push_back(other);
      }
    }
    level = std::move(behind);
  }
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(const Polygon& polygon) {
  const FloatingPointState state;
  const int axis = exact::detail::dropped_axis(polygon).value();
  const auto u = polygon.coordinates((axis + 1) % 3), v = polygon.coordinates((axis + 2) % 3);
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
    vertices.push_back(triangulation.insert(Kernel::Point_2(u[i], v[i])));
    vertices.back()->info() = static_cast<std::uint32_t>(i);
  }
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
    triangulation.insert_constraint(vertices[i], vertices[polygon.next(i)]);
  measure_depths(triangulation);

  const bool turned = mesh::detail::turn(polygon, 0, axis) < 0;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
    if (face->info() % 2 == 0) continue;
    std::array<std::uint32_t, 3> triangle{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    if (turned) std::swap(triangle[1], triangle[2]);
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.push_back(triangle);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<Triangle> triangles_of(const Polygon& polygon) {
  if (polygon.vertex_count() == 3) return {{polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)}};
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : triangulate(polygon))
    triangles.push_back({polygon.vertex(a), polygon.vertex(b), polygon.vertex(c)});
  return triangles;
}

// Sorts in place of a map: the nodes of a map would leave holes in the heap, where libraries that are timed then build.
Mesh::Mesh(std::span<const Triangle> all) : triangles(all), corners(all.size()) {
  const auto vertex = [&](std::size_t i) -> const Eigen::Vector3d& {
    const Triangle& t = all[i / 3];
    return i % 3 == 0 ? t.a : i % 3 == 1 ? t.b : t.c;
  };
  std::vector<std::size_t> order(3 * all.size()), first(order.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
    const Eigen::Vector3d &v = vertex(i), &w = vertex(j);
    return std::tie(v.x(), v.y(), v.z(), i) < std::tie(w.x(), w.y(), w.z(), j);
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool again = k > 0 && vertex(order[k]) == vertex(order[k - 1]);
    first[order[k]] = again ? first[order[k - 1]] : order[k];
  }
  for (std::size_t i = 0; i < first.size(); ++i) {
    std::int32_t& number = corners[i / 3][i % 3];
    if (first[i] == i) {
      number = static_cast<std::int32_t>(vertices.size());
      vertices.push_back(vertex(i));
    } else {
      number = corners[first[i] / 3][first[i] % 3];
    }
  }
}

}  // namespace touchstone::methods
