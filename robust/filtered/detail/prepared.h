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
#include "robust/filtered/detail/parts_of.h"
#include "robust/filtered/detail/vector3.h"
#include "robust/filtered/filtered.h"

namespace touchstone::filtered {

/// An isometric frame in the supporting plane: origin at vertex 0, unit axes x and y in the plane, and the unit normal.
///
/// Lengths are multiplied by a power of two so that no vertex is farther than bounds::kExtent from the origin. In the
/// plane, coordinate (dropped axis + 2) mod 3 is constant along the x axis and grows with y. So above and below mean
/// the same in the frame and in the projection that drops an axis.
struct Frame {
  /// The largest distance of vertices and centres from the coordinate planes, in the frame's unit of length.
  static constexpr double kReach = 0x1p60;
  /// Below this exponent coordinates that matter may be subnormal. They are scaled up before anything else, and the
  /// caller's flush-to-zero setting must be suspended first.
  static constexpr int kSubnormal = -900;

  int exponent;            ///< frame lengths are true lengths times 2^-exponent
  double scale[2];         ///< two factors whose product is 2^-exponent
  double reachable;        ///< the limit for coordinates of centres and for radii up to which the frame may be used
  Vector3<double> origin;  ///< vertex 0, scaled
  Vector3<double> x, y, normal;
  double plane_height;  ///< the height of the plane above the origin
  EdgeTree edges;
};

/// The lifted polygon in double-doubles, in the frame's unit of length but along the axes of the input.
struct LiftedPolygon {
  Vector3<DoubleDouble> normal;     ///< each component N_k to kDoubleDoubleUnit |N_k| + kNormalUnderflow (bounds.h)
  double normal_maximum;            ///< an upper bound of the magnitudes of its components
  bool exact_normal;                ///< whether the normal above is exact
  std::vector<DoubleDouble> lifts;  ///< along the dropped axis, to bounds::kLift; empty if nothing is lifted
};

struct PreparedPolygon::Parts {
  explicit Parts(const Polygon& polygon);

  Polygon polygon;
  BigIntPolygon bigint;
  LiftedPolygon lifted;
  std::optional<Frame> frame;  ///< empty if scaling would lose bits, or beyond kMostEdges; then `exact` answers

  /// Returns the polygon prepared for `exact`. Prepares it on the first call; safe from several threads.
  [[nodiscard]] const exact::PreparedPolygon& exact() const;

 private:
  mutable std::once_flag exact_once_;
  mutable std::optional<exact::PreparedPolygon> exact_;
};

}  // namespace touchstone::filtered
