// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::filtered::detail {

/// A triangle and a ball as pointers to their numbers, which can be passed in registers.
struct BallTriangleView {
  const double (*vertex)[3];  ///< three vertices
  const double* center;       ///< three coordinates, followed by the radius

  static constexpr int kNumbers = 4;  ///< of the ball
  [[nodiscard]] const double* numbers() const { return center; }
  [[nodiscard]] double radius() const { return center[3]; }
};

/// The certain signs of one expression, one bit per lane. If neither bit is set, doubles cannot decide the sign.
struct CertainSigns {
  unsigned positive, negative;

  /// Returns +1, -1, or 0 if the sign is not certain.
  [[nodiscard]] int of(int lane) const {
    return static_cast<int>(positive >> lane & 1) - static_cast<int>(negative >> lane & 1);
  }
};

/// The results of the first stage for a triangle; lane i belongs to edge i. Holds every sign of signs.h that matters
/// for contact (that of the plane three times, computed from each edge) and the maxima of `to_center`, with r, and of
/// `edge`.
struct TriangleSigns {
  CertainSigns vertex, along, beyond, line, side, plane;
  unsigned reachable;  ///< the lanes of the edges that the ball may touch
  double to_center[4], edge[4];
};

/// The sign on which alone contact depends after a first stage that could not decide it, as for most balls near
/// contact.
struct LoneSign {
  /// The places of the bits of vertex 0, of edge 0 with its line, and of the plane. Bits from kNone on go with others.
  static constexpr int kVertices = 0, kLines = 3, kPlane = 6, kNone = 7;

  unsigned bit = 0;              ///< 0 if contact depends on several signs
  double to_center[4], edge[4];  ///< maxima, as in TriangleSigns
};

/// The result of the first stage. OutOfRange: some number is too large for this stage.
enum class FilterResult : unsigned char { No, Yes, Unsure, OutOfRange };

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

}  // namespace touchstone::filtered::detail
