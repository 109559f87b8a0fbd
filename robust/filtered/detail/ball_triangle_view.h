// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::filtered {

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

}  // namespace touchstone::filtered
