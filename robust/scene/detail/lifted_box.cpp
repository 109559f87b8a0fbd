// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/lifted_box.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::scene::detail {
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
  const filtered::detail::BigIntPolygon& bigint = parts_of(prepared).exact_form().bigint;
  if (bigint.planar()) return box;
  // A vertex moves along the dropped axis by at most off_plane.
  widen(box, bigint.dropped_axis(), std::nextafter(bigint.off_plane(), std::numeric_limits<double>::infinity()));
  return box;
}

std::optional<Box> quick_lifted_box(const Polygon& polygon) {
  using filtered::detail::Vector3;
  const std::size_t outer = polygon.loop_end(0);
  const auto count = static_cast<double>(outer);
  if (count > rounded_plane::kMostVertices) return std::nullopt;
  const Eigen::Vector3d origin = polygon.vertex(0);
  const auto from_origin = [&](std::size_t i) -> Eigen::Vector3d { return polygon.vertex(i) - origin; };
  double size = 0;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) size = std::max(size, from_origin(i).cwiseAbs().maxCoeff());
  if (!(size > rounded_plane::kSmallestSize && size < 0x1p300)) return std::nullopt;

  const auto at = [&](std::size_t i) {
    const Eigen::Vector3d p = from_origin(i);
    return Vector3<double>{p.x(), p.y(), p.z()};
  };
  const rounded_plane::Plane<double> plane = rounded_plane::plane_of(outer, 0.0, at);
  const Vector3<double>& normal = plane.normal;
  const double unit = 0x1p-53 * count * count;
  const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  const double error = rounded_plane::kNormal * unit * size * size;
  const double height_error = rounded_plane::kHeight * unit * size * size * size;
  if (!(height_error <= 0x1p-21 * size * largest)) return std::nullopt;

  double height = 0;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
    height = std::max(height, std::abs(rounded_plane::height(plane, at(i))));
  const double lift = (height + height_error) / (largest - error);
  Box box = box_of_vertices(polygon);
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(normal[axis]) >= largest - 2 * error) widen(box, axis, lift);  // this may be the dropped axis
  return box;
}

}  // namespace touchstone::scene::detail
