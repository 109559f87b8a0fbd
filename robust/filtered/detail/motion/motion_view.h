// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::filtered {

/// A triangle and a motion as pointers to their numbers, which can be passed in registers.
struct MotionTriangleView {
  const double (*vertex)[3];  ///< three vertices
  const double* motion;       ///< the centre, the radius, and the centre at time 1

  [[nodiscard]] double center(int axis) const { return motion[axis]; }
  [[nodiscard]] double radius() const { return motion[3]; }
  [[nodiscard]] double to(int axis) const { return motion[4 + axis]; }
};

/// Returns a view of a motion and a triangle.
[[nodiscard]] __attribute__((always_inline)) inline MotionTriangleView view_of(const Motion& motion,
                                                                               const Triangle& triangle) {
  static_assert(sizeof(Motion) == 7 * sizeof(double), "a motion is seven doubles in a row");
  return {reinterpret_cast<const double(*)[3]>(&triangle), reinterpret_cast<const double*>(&motion)};
}

}  // namespace touchstone::filtered
