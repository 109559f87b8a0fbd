// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/edge_tree.h"
#include "robust/filtered/detail/length_unit.h"
#include "robust/filtered/detail/newell_plane.h"
#include "robust/filtered/detail/scaled_vertices.h"
#include "robust/filtered/detail/vector3.h"

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

  LengthUnit unit;         ///< of lengths in the frame
  double reachable;        ///< the limit for coordinates of centres and for radii up to which the frame may be used
  Vector3<double> origin;  ///< vertex 0, scaled
  Vector3<double> x, y, normal;
  double plane_height;  ///< the height of the plane above the origin
  int dropped_axis;     ///< along which vertices are lifted
};

/// A polygon in a frame.
struct FramedPolygon {
  Frame frame;
  /// Lifted and in the plane, to bounds::kFramePoint, kFrameDirection and kFrameLength.
  std::vector<EdgeTree::Edge> edges;
};

/// Returns the polygon in a frame in a plane that is `certain`; nothing if an edge is so short, or so steep above the
/// plane, that the bounds of `edges` would not hold. Requires round to nearest. Cost: linear.
[[nodiscard]] std::optional<FramedPolygon> framed(const Polygon& polygon, const std::vector<ScaledVertex>& vertices,
                                                  const LengthUnit& unit, const NewellPlane& plane);

}  // namespace touchstone::filtered
