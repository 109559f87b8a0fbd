// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>

#include "geometry/shapes/polygon.h"

/// Requires round to nearest, without flush-to-zero, throughout.
namespace touchstone::mesh {

/// The turn of a simple loop seen along an axis, against the other two in cyclic order: counterclockwise (1) or
/// clockwise (-1). Requires a loop that `exact::validate` accepts with that axis dropped. Exact, linear.
[[nodiscard]] int turn(const Polygon& polygon, std::size_t loop, int axis);

/// The plane of a planar face: that of three corners of it, which turn as the face does.
class FacePlane {
 public:
  /// Requires a polygon of one loop that `exact::validate` accepts.
  explicit FacePlane(const Polygon& face);

  [[nodiscard]] int dropped_axis() const { return axis_; }
  /// Does the point lie on the plane? Exact.
  [[nodiscard]] bool contains(const Eigen::Vector3d& point) const;
  /// The turn of the face seen along an axis, 0 where its plane is seen edge-on. Exact.
  [[nodiscard]] int turn(int axis) const;
  /// How far a point is from the plane, along the dropped axis; with rounding errors.
  [[nodiscard]] double approximate_height(const Eigen::Vector3d& point) const;

 private:
  int axis_;
  std::array<Eigen::Vector3d, 3> corners_;
};

/// The largest distance of the points from the supporting plane of the polygon, along its dropped axis, as the nearest
/// double: `off_plane` of the contract, for any points. Requires an accepted polygon. Exact; about 1 us a point.
[[nodiscard]] double off_plane(const Polygon& polygon, std::span<const Eigen::Vector3d> points);

}  // namespace touchstone::mesh
