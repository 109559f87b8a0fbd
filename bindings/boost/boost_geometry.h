// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/geometry/core/access.hpp>
#include <boost/geometry/core/closure.hpp>
#include <boost/geometry/core/coordinate_dimension.hpp>
#include <boost/geometry/core/coordinate_type.hpp>
#include <boost/geometry/core/exterior_ring.hpp>
#include <boost/geometry/core/interior_rings.hpp>
#include <boost/geometry/core/point_type.hpp>
#include <boost/geometry/core/tag.hpp>
#include <boost/geometry/core/tags.hpp>
#include <concepts>
#include <limits>
#include <string>
#include <vector>

#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/pose.h"
#include "../../geometry/shapes/rejection.h"
#include "../../robust/scene/posing.h"

/// Touchstone for the polygons of Boost.Geometry: its own and those that are adapted to it.
namespace touchstone::boost_geometry {

/// A type of polygons with holes.
template <class P>
concept AnyPolygon = std::same_as<typename boost::geometry::tag<P>::type, boost::geometry::polygon_tag>;

/// A type of polygons in the plane whose coordinates are exact as doubles: doubles, floats and integers of 32 bits.
template <class P>
concept PlanePolygon = AnyPolygon<P> && boost::geometry::dimension<P>::value == 2 &&
                       std::numeric_limits<typename boost::geometry::coordinate_type<P>::type>::digits <= 53;

/// @{
/// Returns the polygon in space: lift(p) is the Eigen::Vector3d for the point p. For a pose this is the posed point
/// (x, y, 0), of which each coordinate is rounded once (scene::posed): the polygon is that of the rounded vertices.
///
/// Vertices have the order and the numbers of the points, ring by ring, from the outer one on. If the type closes its
/// rings, the last point of a ring repeats the first and adds no vertex. Rings may run either way, whatever the type
/// says. The front is the side from which the outer ring runs counter-clockwise: a clockwise ring, the usual one of
/// Boost, has its front against the third axis of the pose.
///
/// Throws Rejected with `malformed-case`, naming the ring, for one that is not closed although its type says so; and
/// what Polygon and scene::posed throw. Whether loops cross is left to exact::validate. Cost: linear; see scene::posed.
template <AnyPolygon P, class Lift>
[[nodiscard]] Polygon polygon(const P& flat, const Lift& lift) {
  const auto loop = [&lift](const auto& ring, const std::string& name) {
    Loop lifted;
    for (const auto& p : ring) lifted.push_back(lift(p));
    if (boost::geometry::closure<P>::value == boost::geometry::open || lifted.empty()) return lifted;
    if (lifted.front() != lifted.back())
      throw Rejected({RejectionCode::MalformedCase, name + " is not closed: its last point is not its first"});
    lifted.pop_back();
    return lifted;
  };
  const Loop outer = loop(boost::geometry::exterior_ring(flat), "the outer ring");
  std::vector<Loop> holes;
  for (const auto& ring : boost::geometry::interior_rings(flat))
    holes.push_back(loop(ring, "hole " + std::to_string(holes.size())));
  return Polygon(outer, holes);
}
template <PlanePolygon P>
[[nodiscard]] Polygon polygon(const P& flat, const Pose& pose = {}) {
  return polygon(flat, [&pose](const auto& p) {
    const Eigen::Vector3d in_plane(boost::geometry::get<0>(p), boost::geometry::get<1>(p), 0);
    return scene::posed(pose, in_plane);
  });
}
/// @}

}  // namespace touchstone::boost_geometry
