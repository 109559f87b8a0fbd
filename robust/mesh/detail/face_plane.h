// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>

#include "geometry/shapes/polygon.h"

/// All functions here require round to nearest, without flush-to-zero.
namespace touchstone::mesh::detail {

/// Returns the orientation of a loop in the projection along an axis, with the other two axes in cyclic order:
/// counterclockwise (1) or clockwise (-1). Requires a loop that `exact::validate` accepts with that axis dropped.
/// Exact. Cost: linear.
[[nodiscard]] int turn(const Polygon& polygon, std::size_t loop, int axis);

/// The plane of a planar face, through three corners that have the orientation of the face.
class FacePlane {
 public:
  /// Requires a polygon of one loop that `exact::validate` accepts.
  explicit FacePlane(const Polygon& face);

  [[nodiscard]] int dropped_axis() const { return axis_; }
  /// Returns whether the point lies on the plane. Exact.
  [[nodiscard]] bool contains(const Eigen::Vector3d& point) const;
  /// Returns the orientation of the face in the projection along an axis; 0 if its plane is parallel to the axis.
  /// Exact.
  [[nodiscard]] int turn(int axis) const;
  /// Returns how far a point is from the plane, along the dropped axis, with rounding errors.
  [[nodiscard]] double approximate_height(const Eigen::Vector3d& point) const;

 private:
  int axis_;
  std::array<Eigen::Vector3d, 3> corners_;
};

/// Returns the largest distance of the points from the supporting plane of the polygon, along its dropped axis, as the
/// nearest double: `off_plane` of the contract, for any points. Requires a valid polygon. Exact. Cost: about 1 us per
/// point.
[[nodiscard]] double off_plane(const Polygon& polygon, std::span<const Eigen::Vector3d> points);

}  // namespace touchstone::mesh::detail
