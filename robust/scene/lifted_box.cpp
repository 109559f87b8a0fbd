// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/lifted_box.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::scene {
namespace {

Box box_of_vertices(const Polygon& polygon) {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::ranges::minmax(polygon.coordinates(axis));
    box.low[axis] = low, box.high[axis] = high;
  }
  return box;
}

void widen(Box& box, int axis, double lift) {
  constexpr double last = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  box.low[axis] = std::max(std::nextafter(box.low[axis] - lift, -infinity), -last);
  box.high[axis] = std::min(std::nextafter(box.high[axis] + lift, infinity), last);
}

}  // namespace

Box lifted_box(const Polygon& polygon, const filtered::PreparedPolygon& prepared) {
  Box box = box_of_vertices(polygon);
  const filtered::UnlimitedPolygon& unlimited = prepared.parts().unlimited;
  if (unlimited.planar()) return box;
  // A vertex moves along the dropped axis by at most off_plane.
  widen(box, unlimited.dropped_axis(), std::nextafter(unlimited.off_plane(), std::numeric_limits<double>::infinity()));
  return box;
}

// In units of u = 2^-53, for n vertices of the outer loop, all coordinates taken from vertex 0, which is rounded once,
// and at most e: a component of the normal, n differences of products, is off by 3.1 * 2 n e^2 in the products,
// 2 n e^2 in the differences, 2.1 n^2 e^2 in the sum, in all less than 5 n^2 e^2 (n >= 3). It is at most 2.1 n e^2.
// A coordinate of the mean is off by (n + 2.1) e, one of w = mean - vertex by (n + 5.2) e < 3 n e, and is at most
// 2.01 e. So the height N.w, a sum of three products, is off by 3 (5 n^2 * 2.01 + 2.1 n * 3 n) e^3 from what goes in
// and less than 12 * 2.1 n * 2.01 e^3 from its own rounding: in all less than 70 n^2 e^3. 2^6.5 = 90.5 of them are
// allowed for, and 6 n^2 e^2, which pays for terms of u^2, for underflow and for the rounding of the bound itself.
std::optional<Box> quick_lifted_box(const Polygon& polygon) {
  const auto count = static_cast<double>(polygon.loop_end(0));
  if (count > 0x1p20) return std::nullopt;
  const Eigen::Vector3d origin = polygon.vertex(0);
  const auto from_origin = [&](std::size_t i) -> Eigen::Vector3d { return polygon.vertex(i) - origin; };
  double size = 0;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) size = std::max(size, from_origin(i).cwiseAbs().maxCoeff());
  if (!(size > 0x1p-300 && size < 0x1p300)) return std::nullopt;

  Eigen::Vector3d normal(0, 0, 0), mean(0, 0, 0);
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i) {
    const Eigen::Vector3d at = from_origin(i);
    normal += at.cross(from_origin(polygon.next(i)));
    mean += at;
  }
  mean /= count;
  const double unit = 0x1p-53 * count * count;
  const double largest = normal.cwiseAbs().maxCoeff(), error = 6 * unit * size * size;
  const double height_error = 91 * unit * size * size * size;
  if (!(height_error <= 0x1p-21 * size * largest)) return std::nullopt;

  double height = 0;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
    height = std::max(height, std::abs(normal.dot(mean - from_origin(i))));
  const double lift = (height + height_error) / (largest - error);
  Box box = box_of_vertices(polygon);
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(normal[axis]) >= largest - 2 * error) widen(box, axis, lift);  // may be the dropped one
  return box;
}

}  // namespace touchstone::scene
