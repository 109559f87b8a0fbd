// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::filtered {

/// A triangle and a motion as pointers to their numbers, which can be passed in registers.
struct MotionTriangleView {
  const double (*vertex)[3];  ///< three vertices
  const double* motion;       ///< the centre, the radius, and the centre at time 1

  static constexpr int kNumbers = 7;  ///< of the motion
  [[nodiscard]] const double* numbers() const { return motion; }
  [[nodiscard]] double center(int axis) const { return motion[axis]; }
  [[nodiscard]] double radius() const { return motion[3]; }
  [[nodiscard]] double to(int axis) const { return motion[4 + axis]; }
};

/// Returns whether the ball stays where it is. Requires that the floating-point unit distinguishes subnormal numbers.
inline bool at_rest(const MotionTriangleView& view) {
  return view.center(0) == view.to(0) && view.center(1) == view.to(1) && view.center(2) == view.to(2);  // exact
}

/// Returns a view of a motion and a triangle.
[[nodiscard]] __attribute__((always_inline)) inline MotionTriangleView view_of(const Motion& motion,
                                                                               const Triangle& triangle) {
  static_assert(sizeof(Motion) == 7 * sizeof(double), "a motion is seven doubles in a row");
  return {reinterpret_cast<const double(*)[3]>(&triangle), reinterpret_cast<const double*>(&motion)};
}

}  // namespace touchstone::filtered
