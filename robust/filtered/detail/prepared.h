// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "robust/exact/exact.h"
#include "robust/filtered/detail/bigint_polygon.h"
#include "robust/filtered/detail/edge_tree.h"
#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/vector3.h"
#include "robust/filtered/filtered.h"

namespace touchstone::filtered {

/// An isometric frame in the supporting plane: origin at vertex 0, unit axes x and y in the plane, the unit normal.
///
/// Lengths are multiplied by a power of two so that no vertex is farther than bounds::kExtent from the origin. The x
/// axis is parallel to the plane's lines of equal coordinate (dropped axis + 2) mod 3, and y grows with that
/// coordinate: above and below are the same in the frame and in the projection that drops an axis.
struct Frame {
  /// Vertices and centres are at most this far from the coordinate planes, in the frame's unit of length.
  static constexpr double kReach = 0x1p60;
  /// Below this exponent coordinates that matter may be subnormal, and are scaled up before anything else: a caller's
  /// flush-to-zero must be set aside first.
  static constexpr int kSubnormal = -900;

  int exponent;            ///< frame lengths are true lengths times 2^-exponent
  double scale[2];         ///< whose product is 2^-exponent
  double reachable;        ///< coordinates of centres, and radii, up to which the frame may be used
  Vector3<double> origin;  ///< vertex 0, scaled
  Vector3<double> x, y, normal;
  double plane_height;  ///< of the plane above the origin
  EdgeTree edges;
};

/// What the polygon is in double-doubles, in the frame's unit of length but with its own axes.
struct LiftedPolygon {
  Vector3<DoubleDouble> normal;     ///< each component N_k to kDoubleDoubleUnit |N_k| + kNormalUnderflow (bounds.h)
  double normal_maximum;            ///< bounds the magnitudes of its components
  bool exact_normal;                ///< no bit is missing
  std::vector<DoubleDouble> lifts;  ///< along the dropped axis, to bounds::kLift; none where nothing is lifted
};

struct PreparedPolygon::Parts {
  explicit Parts(const Polygon& polygon);

  Polygon polygon;
  BigIntPolygon bigint;
  LiftedPolygon lifted;
  std::optional<Frame> frame;  ///< none where scaling would lose bits, or beyond kMostEdges: `exact` answers

  /// The polygon for `exact`, made when it is first asked for.
  [[nodiscard]] const exact::PreparedPolygon& exact() const;

 private:
  mutable std::once_flag exact_once_;
  mutable std::optional<exact::PreparedPolygon> exact_;
};

/// Returns what was prepared. Requires a polygon that was not moved from.
[[nodiscard]] inline const PreparedPolygon::Parts& parts_of(const PreparedPolygon& polygon) { return *polygon.parts_; }

}  // namespace touchstone::filtered
