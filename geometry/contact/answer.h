// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string_view>
#include <vector>

#include "../floating_point.h"
#include "../same_number.h"

/// What is asked about: balls, polygons, triangles, meshes and poses; and what an answer consists of. Each way to
/// answer is a namespace of its own.
namespace touchstone {

/// On which side of the supporting plane a closed ball lies; touching the plane is `Intersects`.
enum class PlaneSide { InFront, Behind, Intersects };

/// Where the foot of the perpendicular from the ball's centre lies with respect to the polygon.
enum class PointLocation { Inside, Boundary, Outside };

/// Ball against polygon: distance > r, = r, < r.
enum class Relation { Separate, Touching, Overlapping };

/// The feature that holds the closest point: the relative interior of the face or of an edge, or a vertex.
/// Among equal distances an edge comes before a vertex, then the lowest index. The face's index is 0.
struct Feature {
  /// The three kinds.
  enum class Kind { Face, Edge, Vertex } kind;  ///< which it is
  std::size_t index = 0;                        ///< of the edge or vertex in the polygon

  friend bool operator==(const Feature&, const Feature&) = default;
};

/// All that the contract asks about a ball and a polygon.
///
/// Lengths are in the unit of the input. `off_plane` is a property of the polygon alone. Equality is that of every
/// member, numbers by value.
struct Answer {
  PlaneSide plane;                     ///< the first test
  bool plane_tangent;                  ///< the centre is at distance r from the supporting plane
  PointLocation foot;                  ///< the second
  std::vector<std::size_t> edges_hit;  ///< the third: edges at distance <= r from the centre, ascending
  Relation relation;                   ///< distance against radius
  Feature nearest;                     ///< which holds the closest point
  Eigen::Vector3d point;               ///< the closest point of the polygon
  double distance;                     ///< from the centre to the polygon
  double off_plane;                    ///< the largest move of a vertex onto the supporting plane

  /// Do they touch?
  [[nodiscard]] bool contact() const { return relation != Relation::Separate; }
  friend bool operator==(const Answer& a, const Answer& b) {
    return a.plane == b.plane && a.plane_tangent == b.plane_tangent && a.foot == b.foot && a.edges_hit == b.edges_hit &&
           a.relation == b.relation && a.nearest == b.nearest && same_point(a.point, b.point) &&
           same_number(a.distance, b.distance) && same_number(a.off_plane, b.off_plane);
  }
};

/// @{
/// The words of the contract, such as `in_front`, `boundary`, `touching`, `edge`.
[[nodiscard]] std::string_view word(PlaneSide side);
[[nodiscard]] std::string_view word(PointLocation place);
[[nodiscard]] std::string_view word(Relation relation);
[[nodiscard]] std::string_view word(Feature::Kind kind);
/// @}

}  // namespace touchstone
