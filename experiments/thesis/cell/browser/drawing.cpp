// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/drawing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "experiments/methods/triangulate.h"

namespace touchstone::cell::browser {
namespace {

constexpr double kCosineOfOutline = 0.93969262078590838;  // of 20 degrees

/// Twice the vector area of the outer loop, divided by its length.
Eigen::Vector3d direction(const Polygon& polygon) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = polygon.vertex(0);
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
    sum += (polygon.vertex(i) - origin).cross(polygon.vertex(polygon.next(i)) - origin);
  return sum.normalized();
}

/// The faces that lie on an edge.
struct Edge {
  std::size_t faces = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  // where the first one looks
  bool bent = false;
};

}  // namespace

Drawing drawing_of(const SolidFaces& solid) {
  Drawing drawing;
  std::map<std::array<double, 3>, std::uint32_t> numbers;
  std::map<std::array<std::uint32_t, 2>, Edge> edges;
  for (const Face& face : solid.faces) {
    const Polygon& polygon = face.polygon;
    std::vector<std::uint32_t> own;
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
      const Eigen::Vector3d at = polygon.vertex(i);
      const auto [number, added] =
          numbers.try_emplace({at.x(), at.y(), at.z()}, static_cast<std::uint32_t>(drawing.points.size()));
      if (added) drawing.points.push_back(at);
      own.push_back(number->second);
    }
    for (const auto& triangle : methods::triangulate(polygon))
      drawing.triangles.push_back({own[triangle[0]], own[triangle[1]], own[triangle[2]]});
    drawing.face_ends.push_back(drawing.triangles.size());

    const Eigen::Vector3d normal = direction(polygon);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto [a, b] = std::minmax(own[i], own[polygon.next(i)]);
      Edge& edge = edges[{a, b}];
      if (edge.faces++ == 0)
        edge.first = normal;
      else if (edge.first.dot(normal) < kCosineOfOutline)
        edge.bent = true;
    }
  }
  for (const auto& [ends, edge] : edges)
    if (edge.bent || edge.faces != 2) drawing.outline.push_back(ends);
  return drawing;
}

}  // namespace touchstone::cell::browser
