// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/face_sets.h"

#include <cmath>
#include <limits>

#include "robust/filtered/prepared.h"
#include "robust/floating_point_state.h"

namespace touchstone::scene {
namespace {

BoxTree tree_of(const std::vector<Triangle>& triangles) {
  const FloatingPointState nearest;
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) boxes.push_back(box(triangle));
  return BoxTree(boxes);
}

std::vector<filtered::PreparedPolygon> prepared_of(const std::vector<Polygon>& polygons) {
  std::vector<filtered::PreparedPolygon> prepared;
  prepared.reserve(polygons.size());
  for (const Polygon& polygon : polygons) prepared.emplace_back(polygon);
  return prepared;
}

/// A vertex moves along the dropped axis by at most off_plane. What lies beyond the finite doubles is nearer to every
/// centre when it is moved back to the last of them.
Box lifted_box(const Polygon& polygon, const filtered::PreparedPolygon& prepared) {
  Box box;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) box = box.joined({polygon.vertex(i), polygon.vertex(i)});
  const filtered::UnlimitedPolygon& unlimited = prepared.parts().unlimited;
  if (unlimited.planar()) return box;
  constexpr double last = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const double lift = std::nextafter(unlimited.off_plane(), infinity);
  double &low = box.low[unlimited.dropped_axis()], &high = box.high[unlimited.dropped_axis()];
  low = std::max(std::nextafter(low - lift, -infinity), -last);
  high = std::min(std::nextafter(high + lift, infinity), last);
  return box;
}

BoxTree tree_of(const std::vector<Polygon>& polygons, const std::vector<filtered::PreparedPolygon>& prepared) {
  const FloatingPointState nearest;
  std::vector<Box> boxes;
  boxes.reserve(polygons.size());
  for (std::size_t i = 0; i < polygons.size(); ++i) boxes.push_back(lifted_box(polygons[i], prepared[i]));
  return BoxTree(boxes);
}

}  // namespace

TriangleSet::TriangleSet(const std::vector<Triangle>& by_number) : tree(tree_of(by_number)) {
  triangles.reserve(by_number.size());
  for (const std::uint32_t number : tree.order()) triangles.push_back(by_number[number]);
}

std::size_t TriangleSet::memory() const {
  return tree.nodes().capacity() * sizeof(BoxTree::Node) + tree.order().capacity() * sizeof(std::uint32_t) +
         triangles.capacity() * sizeof(Triangle);
}

PolygonSet::PolygonSet(std::vector<Polygon> by_number)
    : polygons(std::move(by_number)), prepared(prepared_of(polygons)), tree(tree_of(polygons, prepared)), edges(0) {
  for (const Polygon& polygon : polygons) edges += polygon.vertex_count();
}

}  // namespace touchstone::scene
