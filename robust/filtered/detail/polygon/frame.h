// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/numbers/length_unit.h"
#include "robust/filtered/detail/numbers/target.h"
#include "robust/filtered/detail/numbers/vector3.h"
#include "robust/filtered/detail/polygon/edge_tree.h"
#include "robust/filtered/detail/polygon/newell_plane.h"
#include "robust/filtered/detail/signs/edge_frame.h"

namespace touchstone::filtered::detail {

// Lifted edges in the frame of a prepared polygon, computed from two coordinates.

/// A vector in the plane of a frame.
template <class Number>
struct PlanarPoint {
  Number x, y;
};

/// The map from two coordinates of a vertex, from vertex 0, to the place of the lifted vertex in the frame.
template <class Number>
struct ShearOf {
  /// At most sqrt(2), sqrt(1/2), sqrt(2), because the dropped axis has the largest component of the normal.
  Number x_a, x_b, y_b;
  PlanarPoint<Number> origin;  ///< where vertex 0 is lifted to
};
using Shear = ShearOf<double>;

/// A unit direction and the length of what it was computed from.
template <class Number>
struct PlanarDirection {
  Number x, y, length;
};

/// Returns an edge with these differences of its coordinates.
template <class Number>
constexpr PlanarPoint<Number> sheared_edge(const ShearOf<Number>& shear, const Number& a, const Number& b) {
  return {shear.x_a * a + shear.x_b * b, shear.y_b * b};
}

/// Returns a vertex with these coordinates, from vertex 0.
template <class Number>
constexpr PlanarPoint<Number> sheared_vertex(const ShearOf<Number>& shear, const Number& a, const Number& b) {
  const PlanarPoint<Number> from_origin = sheared_edge(shear, a, b);
  return {from_origin.x + shear.origin.x, from_origin.y + shear.origin.y};
}

inline PlanarDirection<double> direction(const PlanarPoint<double>& edge) {
  const double length = std::sqrt(edge.x * edge.x + edge.y * edge.y);
  return {edge.x / length, edge.y / length, length};
}

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

// The plane of a frame in the caller's unit of length, for balls that need not be scaled.

/// Two doubles in one register.
using DoublePair = double __attribute__((vector_size(2 * sizeof(double))));

/// Scaling by a power of two changes nothing but what underflows, and bounds.h allows for that from Frame::kSubnormal
/// up. Up to kLargest, nothing overflows.
struct GivenPlane {
  static constexpr int kLargest = 900;  ///< of a frame's exponent

  double reach = -1;  ///< the limit for a ball's numbers; negative if there is no such plane
  double error = 0;   ///< of heights, less the part that grows with a ball's numbers
  double height = 0;  ///< of the plane above the origin
  DoublePair origin_xy{}, origin_z{}, normal_xy{}, normal_z{};  ///< the origin is vertex 0; second numbers of z are 0

  GivenPlane() = default;
  explicit GivenPlane(const Frame& frame);
};

inline namespace TOUCHSTONE_TARGET {

/// The height of a ball's centre above a given plane. Its bound grows with the distance from the origin of coordinates:
/// it costs less than that of HeightQuery, and decides less where a polygon is far from there. Valid as that is.
class GivenHeight {
 public:
  __attribute__((always_inline)) GivenHeight(const Ball& ball, const GivenPlane& plane) : ball_(ball), plane_(plane) {
    std::memcpy(&xy_, &ball.center[0], sizeof xy_);
    static_assert(sizeof(Ball) == 2 * sizeof(DoublePair), "the radius follows the centre");
    std::memcpy(&z_, &ball.center[2], sizeof z_);
    const DoublePair larger = larger_of(magnitude(xy_), magnitude(z_));
    widest_ = larger[0] > larger[1] ? larger[0] : larger[1];
  }
  /// Returns whether nothing overflows.
  [[nodiscard]] __attribute__((always_inline)) bool is_in_reach() const { return widest_ <= plane_.reach; }

  /// Sets the side of the plane, and returns whether it is certain. Requires a ball in reach.
  [[nodiscard]] __attribute__((always_inline)) bool find_side(PlaneSide& side) const {
    const double height = frame::height_of_pairs(xy_, z_, plane_.origin_xy, plane_.origin_z, plane_.normal_xy,
                                                 plane_.normal_z, plane_.height);
    const double above = std::abs(height), radius = ball_.radius;
    side = above > radius ? (height > 0 ? PlaneSide::InFront : PlaneSide::Behind) : PlaneSide::Intersects;
    // As in HeightQuery::knows_side.
    return std::abs(above - radius) > frame::given_height_error(widest_) + plane_.error;
  }

 private:
  static __attribute__((always_inline)) DoublePair magnitude(const DoublePair& a) {
    using Bits = std::int64_t __attribute__((vector_size(sizeof a)));
    return reinterpret_cast<DoublePair>(reinterpret_cast<Bits>(a) & (Bits{} + INT64_MAX));
  }
  static __attribute__((always_inline)) DoublePair larger_of(const DoublePair& a, const DoublePair& b) {
#if defined(__SSE2__)
    return _mm_max_pd(a, b);
#else
    return DoublePair{a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
#endif
  }

  const Ball& ball_;
  const GivenPlane& plane_;
  DoublePair xy_, z_;  ///< of the centre; the second number of z is the radius
  double widest_;      ///< the largest number of the ball
};

}  // namespace TOUCHSTONE_TARGET

}  // namespace touchstone::filtered::detail
