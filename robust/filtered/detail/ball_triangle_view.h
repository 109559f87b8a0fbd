// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::filtered {

/// A triangle and a ball as plain numbers where they lie, to be handed over in registers.
struct BallTriangleView {
  const double (*vertex)[3];  ///< three of them
  const double* center;       ///< and after it the radius

  [[nodiscard]] double radius() const { return center[3]; }
};

/// What is sure of one sign in each lane, a bit a lane; where neither bit is set, doubles cannot tell.
struct CertainSigns {
  unsigned positive, negative;

  /// +1, -1, or 0 where it is not sure.
  [[nodiscard]] int of(int lane) const {
    return static_cast<int>(positive >> lane & 1) - static_cast<int>(negative >> lane & 1);
  }
};

/// What the first stage has found of a triangle, lane i for edge i: every sign of signs.h that bears on a contact (the
/// plane's is one sign, seen from three edges), and the maxima of `to_center`, with r, and of `edge`.
struct TriangleSigns {
  CertainSigns vertex, along, beyond, line, side, plane;
  unsigned reachable;  ///< lanes of the edges that the ball may touch
  double to_center[4], edge[4];
};

/// OutOfRange: some number is too large for the stage to be used at all.
enum class FilterResult : unsigned char { No, Yes, Unsure, OutOfRange };

}  // namespace touchstone::filtered
