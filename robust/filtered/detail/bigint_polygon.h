// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/sign_kind.h"

namespace touchstone::filtered {

/// A lifted polygon in integers of any size: its exact normal and lift, and the last word on every sign and rounding.
///
/// Throws Rejected with `zero-normal`. Keeps a reference to the polygon. Requires round to nearest throughout.
class BigIntPolygon {
 public:
  explicit BigIntPolygon(const Polygon& polygon);
  BigIntPolygon(BigIntPolygon&&) noexcept;
  ~BigIntPolygon();

  [[nodiscard]] int dropped_axis() const;
  /// All vertices lie on the supporting plane: nothing is lifted.
  [[nodiscard]] bool planar() const;
  /// The largest move of a vertex onto the plane, as the nearest double.
  [[nodiscard]] double off_plane() const;

  /// A component of the normal times 2^exponent, as the nearest double and the double nearest to what that leaves: to
  /// 2^-106 of itself, and to 2^-1075 where that is more.
  [[nodiscard]] DoubleDouble normal(int axis, int exponent) const;
  /// Do both together hold every bit?
  [[nodiscard]] bool normal_fits(int axis, int exponent) const;
  /// N.(g - p) times 2^exponent for vertex 0: how far the plane is in front of it.
  [[nodiscard]] DoubleDouble plane_height(int exponent) const;

  /// The exact sign for an edge; `axis` is that of SignKind::Above.
  [[nodiscard]] int sign(SignKind kind, const Ball& ball, std::size_t edge, int axis = 0) const;
  /// Which of two features of the boundary is nearer to the ball's centre: the first (-), neither (0), the second (+).
  /// An edge stands for its line.
  [[nodiscard]] int compare_distances(const Ball& ball, const Feature& first, const Feature& second) const;
  /// The point of the feature closest to the centre, and its distance, rounded to the nearest doubles.
  [[nodiscard]] double point(const Ball& ball, const Feature& feature, int axis) const;
  [[nodiscard]] double distance(const Ball& ball, const Feature& feature) const;

 private:
  struct Numbers;
  std::unique_ptr<const Numbers> numbers_;
};

}  // namespace touchstone::filtered
