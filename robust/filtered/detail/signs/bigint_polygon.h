// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/signs/signs.h"

namespace touchstone::filtered::detail {

/// A lifted polygon in integers of any size: its exact normal and lift. Decides every sign and every rounding.
///
/// Throws Rejected with `zero-normal`. Keeps a reference to the polygon. All functions require round to nearest.
class BigIntPolygon {
 public:
  explicit BigIntPolygon(const Polygon& polygon);
  BigIntPolygon(BigIntPolygon&&) noexcept;
  ~BigIntPolygon();

  [[nodiscard]] int dropped_axis() const;
  /// Returns whether all vertices lie on the supporting plane, so that nothing is lifted.
  [[nodiscard]] bool planar() const;
  /// Returns the largest displacement of a vertex onto the plane, as the nearest double.
  [[nodiscard]] double off_plane() const;

  /// Returns a component of the normal times 2^exponent, as the nearest double and the double nearest to the rest. The
  /// error is at most 2^-106 of the component, or 2^-1075 if that is more.
  [[nodiscard]] DoubleDouble normal(int axis, int exponent) const;
  /// Returns whether these two doubles hold every bit.
  [[nodiscard]] bool normal_fits(int axis, int exponent) const;
  /// Returns N.(g - p) times 2^exponent for vertex 0 at p: how far the plane is in front of it.
  [[nodiscard]] DoubleDouble plane_height(int exponent) const;

  /// Returns the exact sign for an edge. `axis` is for SignKind::Above.
  [[nodiscard]] int sign(SignKind kind, const Ball& ball, std::size_t edge, int axis = 0) const;
  /// Returns which of two features of the boundary is nearer to the ball's centre: the first (-), neither (0) or the
  /// second (+). For an edge its line counts.
  [[nodiscard]] int compare_distances(const Ball& ball, const Feature& first, const Feature& second) const;
  /// Returns a coordinate of the feature's point closest to the centre, or its distance, as the nearest double.
  [[nodiscard]] double point(const Ball& ball, const Feature& feature, int axis) const;
  [[nodiscard]] double distance(const Ball& ball, const Feature& feature) const;
  /// @{
  /// Returns the contact normal at the feature's point closest to the centre, or the depth, as in Answer.
  [[nodiscard]] Eigen::Vector3d contact_normal(const Ball& ball, const Feature& feature) const;
  [[nodiscard]] double depth(const Ball& ball, const Feature& feature) const;
  /// @}

 private:
  struct Numbers;
  std::unique_ptr<const Numbers> numbers_;
};

}  // namespace touchstone::filtered::detail
