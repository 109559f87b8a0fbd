// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string_view>
#include <vector>

#include "../floating_point.h"
#include "../same_number.h"

/// Exact contact between balls and planar polygons: shapes, poses, meshes and answers. Each way to compute the answers
/// has a namespace of its own.
namespace touchstone {

/// The side of the supporting plane on which a closed ball lies. A ball that touches the plane intersects it.
enum class PlaneSide { InFront, Behind, Intersects };

/// The location of a point of the supporting plane with respect to the polygon: of the foot of the perpendicular from
/// the ball's centre.
enum class PointLocation { Inside, Boundary, Outside };

/// The distance from the ball's centre to the polygon against the radius: distance > r, = r, < r.
enum class Relation { Separate, Touching, Overlapping };

/// The feature that contains the closest point: the relative interior of the face or of an edge, or a vertex.
///
/// Of several features at the same distance an edge is preferred to a vertex, then the lowest index is. The index of
/// the face is 0.
struct Feature {
  /// The kinds of features.
  enum class Kind { Face, Edge, Vertex } kind;  ///< the kind of this one
  std::size_t index = 0;                        ///< the number of the edge or vertex in the polygon

  friend bool operator==(const Feature&, const Feature&) = default;
};

/// The full answer about a ball and a polygon, as the contract defines it.
///
/// Lengths are in the unit of the input. `off_plane` is a property of the polygon alone. Two answers are equal if all
/// their members are, numbers compared by value.
struct Answer {
  PlaneSide plane;                     ///< test 1
  bool plane_tangent;                  ///< the centre is at distance r from the supporting plane
  PointLocation foot;                  ///< test 2
  std::vector<std::size_t> edges_hit;  ///< test 3: the edges at distance <= r from the centre, ascending
  Relation relation;                   ///< the distance against the radius
  Feature nearest;                     ///< the feature that contains the closest point
  Eigen::Vector3d point;               ///< the closest point of the polygon
  double distance;                     ///< from the centre to the polygon
  double off_plane;                    ///< the largest displacement of a vertex onto the supporting plane
  /// The direction from `point` to the centre, of length 1; if they coincide, that of the front, or 0 without one.
  Eigen::Vector3d contact_normal = Eigen::Vector3d::Zero();
  double depth = 0;  ///< the radius less the distance: negative if they are separate

  /// Returns whether ball and polygon touch or overlap.
  [[nodiscard]] bool contact() const { return relation != Relation::Separate; }
  friend bool operator==(const Answer& a, const Answer& b) {
    return a.plane == b.plane && a.plane_tangent == b.plane_tangent && a.foot == b.foot && a.edges_hit == b.edges_hit &&
           a.relation == b.relation && a.nearest == b.nearest && same_point(a.point, b.point) &&
           same_number(a.distance, b.distance) && same_point(a.contact_normal, b.contact_normal) &&
           same_number(a.depth, b.depth) && same_number(a.off_plane, b.off_plane);
  }
};

/// The point of a polygon that is closest to a centre.
struct ClosestPoint {
  Feature feature;                                           ///< the feature that contains it
  Eigen::Vector3d point;                                     ///< as in Answer
  double distance;                                           ///< as in Answer
  Eigen::Vector3d contact_normal = Eigen::Vector3d::Zero();  ///< as in Answer

  friend bool operator==(const ClosestPoint& a, const ClosestPoint& b) {
    return a.feature == b.feature && same_point(a.point, b.point) && same_number(a.distance, b.distance) &&
           same_point(a.contact_normal, b.contact_normal);
  }
};

/// @{
/// Returns the word of the contract, such as `in_front`, `boundary`, `touching`, `edge`.
[[nodiscard]] std::string_view to_string(PlaneSide side);
[[nodiscard]] std::string_view to_string(PointLocation place);
[[nodiscard]] std::string_view to_string(Relation relation);
[[nodiscard]] std::string_view to_string(Feature::Kind kind);
/// @}

}  // namespace touchstone
