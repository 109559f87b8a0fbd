// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/polygon/frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchstone::filtered::detail {
namespace {

/// The frame's axes and the lift in terms of the normal N = (N_k, N_a, N_b), where k is the dropped axis, a = k + 1 and
/// b = k + 2 mod 3.
///
/// A lift moves a point along axis k onto the plane. So a lifted point is a function of its coordinates a and b alone:
/// it is X_a a + X_b b to the right of where vertex 0 is lifted to, and Y_b b above that.
struct Axes {
  int k, a, b;
  DoubleDouble n_k, n_a, n_b;
  DoubleDouble width, length;  // |(N_k, N_a)|, |N|
  DoubleDouble per_width, per_length;

  explicit Axes(const NewellPlane& plane) : k(plane.dropped_axis), a((k + 1) % 3), b((k + 2) % 3) {
    // The normal is as large as the area, so scale it to about 1 before squaring it.
    const DoubleDouble about_one = std::ldexp(1.0, -std::ilogb(plane.normal[k].high));
    n_k = about_one * plane.normal[k], n_a = about_one * plane.normal[a], n_b = about_one * plane.normal[b];
    const DoubleDouble width_squared = n_k * n_k + n_a * n_a;
    width = sqrt(width_squared), length = sqrt(width_squared + n_b * n_b);
    per_width = DoubleDouble(1) / width, per_length = DoubleDouble(1) / length;
  }

  [[nodiscard]] Vector3<DoubleDouble> vector(const DoubleDouble& along_k, const DoubleDouble& along_a,
                                             const DoubleDouble& along_b) const {
    const DoubleDouble components[] = {along_k, along_a, along_b};
    return {components[(3 - k) % 3], components[(4 - k) % 3], components[(5 - k) % 3]};
  }
  [[nodiscard]] Vector3<DoubleDouble> x() const { return vector(-(n_a * per_width), n_k * per_width, {}); }
  [[nodiscard]] Vector3<DoubleDouble> y() const {
    const DoubleDouble across = -(n_b * per_width * per_length);
    return vector(across * n_k, across * n_a, width * per_length);
  }
  [[nodiscard]] Vector3<DoubleDouble> normal() const {
    return vector(n_k * per_length, n_a * per_length, n_b * per_length);
  }
  /// `lift`: that of vertex 0.
  [[nodiscard]] Shear shear(const DoubleDouble& lift) const {
    const DoubleDouble per_k = DoubleDouble(1) / n_k;
    return {(width * per_k).high,
            (n_a * n_b * per_width * per_k).high,
            (length * per_width).high,
            {(lift * x()[k]).high, (lift * y()[k]).high}};
  }
};

/// Squares of shorter edges would underflow.
constexpr double kShortestEdge = 0x1p-400;
/// Edges that are steeper above the plane become so short when they are lifted that bounds::kLiftedEdge, which is
/// relative to their length before, would not tell their direction.
constexpr double kLeastSlope = 0x1p-40;

Vector3<double> rounded(const Vector3<DoubleDouble>& v) { return {v.x.high, v.y.high, v.z.high}; }

std::optional<std::vector<EdgeTree::Edge>> lifted_edges(const Polygon& polygon,
                                                        const std::vector<ScaledVertex>& vertices, const Axes& axes,
                                                        const Shear& shear) {
  std::vector<EdgeTree::Edge> edges(vertices.size());
  bool accurate = true;
  for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop) {
    const std::size_t begin = polygon.loop_begin(loop), end = polygon.loop_end(loop);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t next = i + 1 < end ? i + 1 : begin;
      const auto difference = [&](int axis, std::size_t from) {
        return vertices[i].coordinates[axis] - vertices[from].coordinates[axis];
      };
      EdgeTree::Edge& edge = edges[i];
      const PlanarPoint<double> start = sheared_vertex(shear, difference(axes.a, 0), difference(axes.b, 0));
      edge.start_x = start.x, edge.start_y = start.y;
      // Compute an edge from its own differences: then its error is relative to its length.
      const double a = -difference(axes.a, next), b = -difference(axes.b, next);
      const double widest = std::max(std::abs(a), std::abs(b));
      accurate &= widest >= kShortestEdge && widest >= kLeastSlope * std::abs(difference(axes.k, next));
      const PlanarDirection<double> along = direction(sheared_edge(shear, a, b));
      edge.direction_x = along.x, edge.direction_y = along.y, edge.length = along.length;
    }
    for (std::size_t i = begin; i < end; ++i) {
      const EdgeTree::Edge& after = edges[i + 1 < end ? i + 1 : begin];
      edges[i].end_x = after.start_x, edges[i].end_y = after.start_y;
    }
  }
  if (!accurate) return std::nullopt;
  return edges;
}

}  // namespace

GivenPlane::GivenPlane(const Frame& frame) {
  if (frame.unit.exponent < Frame::kSubnormal || frame.unit.exponent > kLargest) return;
  const auto given = [&frame](double length) { return frame.unit.unscaled(length); };
  const Vector3<double> origin{given(frame.origin.x), given(frame.origin.y), given(frame.origin.z)};
  reach = frame.reachable;
  height = given(frame.plane_height);
  origin_xy = DoublePair{origin.x, origin.y}, origin_z = DoublePair{origin.z, 0};
  normal_xy = DoublePair{frame.normal.x, frame.normal.y}, normal_z = DoublePair{frame.normal.z, 0};
  const double largest = std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)});
  error = frame::given_height_error(largest + given(1));
}

std::optional<FramedPolygon> framed(const Polygon& polygon, const std::vector<ScaledVertex>& vertices,
                                    const LengthUnit& unit, const NewellPlane& plane) {
  const Axes axes(plane);
  const Vector3<DoubleDouble> normal = axes.normal();
  const DoubleDouble height = dot(normal, plane.mean);
  auto edges = lifted_edges(polygon, vertices, axes, axes.shear(height / normal[axes.k]));
  if (!edges) return std::nullopt;
  return FramedPolygon{{.unit = unit,
                        .reachable = std::ldexp(Frame::kReach, std::min(unit.exponent, 960)),
                        .origin = {vertices[0].coordinates[0], vertices[0].coordinates[1], vertices[0].coordinates[2]},
                        .x = rounded(axes.x()),
                        .y = rounded(axes.y()),
                        .normal = rounded(normal),
                        .plane_height = height.high,
                        .dropped_axis = plane.dropped_axis},
                       std::move(*edges)};
}

}  // namespace touchstone::filtered::detail
