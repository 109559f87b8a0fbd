// SPDX-License-Identifier: Apache-2.0
#pragma once

// The definitions of the templates of fast.h. fast.cpp instantiates them for float, double and long double; include
// this file for other scalars. A scalar must meet Eigen's requirements and have abs and sqrt in its namespace, and a
// conversion to double or a function to_double in its namespace.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/contact/fast.h"
#include "geometry/detail/required.h"

namespace touchstone::fast {
// A `Face` below is a PreparedPolygon, or what has the same members.
namespace detail {

template <class Scalar>
using Vector = Eigen::Matrix<Scalar, 3, 1>;

template <class Scalar>
Vector<Scalar> vertex(const Polygon& polygon, std::size_t i) {
  return polygon.vertex(i).template cast<Scalar>();
}

template <class Scalar>
double to_double(const Scalar& x) {
  return static_cast<double>(x);
}

template <class Scalar>
Eigen::Vector3d to_doubles(const Vector<Scalar>& v) {
  return {to_double(v.x()), to_double(v.y()), to_double(v.z())};
}

/// The ball in the scalar of the computation.
template <class Scalar>
struct Sphere {
  explicit Sphere(const Ball& ball)
      : center(required(ball).center.template cast<Scalar>()),
        radius_squared(Scalar(ball.radius) * Scalar(ball.radius)) {}
  Vector<Scalar> center;
  Scalar radius_squared;
};

/// A squared distance as a quotient, so that comparing it needs no division.
template <class Scalar>
struct Squared {
  Scalar numerator, denominator;
  bool operator<(const Squared& other) const { return numerator * other.denominator < other.numerator * denominator; }
  [[nodiscard]] bool within(Scalar radius_squared) const { return numerator <= radius_squared * denominator; }
};

template <class Scalar>
double root(const Squared<Scalar>& squared) {
  using std::sqrt;
  return to_double(sqrt(squared.numerator / squared.denominator));
}

/// Returns N.(c - g): the height of the centre above the plane, in units of |N|.
template <class Scalar, class Face>
Scalar height(const Sphere<Scalar>& sphere, const Face& polygon) {
  return polygon.plane().normal.dot(sphere.center - polygon.plane().point);
}

template <class Scalar, class Face>
Squared<Scalar> plane_distance(Scalar height, const Face& polygon) {
  return {height * height, polygon.normal_squared()};
}

/// An edge relative to the centre.
template <class Scalar>
struct EdgeView {
  EdgeView(const Sphere<Scalar>& sphere, const typename PreparedPolygon<Scalar>::Edge& seen)
      : edge(seen), from_start(sphere.center - seen.start), along(from_start.dot(seen.direction)) {}

  const typename PreparedPolygon<Scalar>::Edge& edge;
  Vector<Scalar> from_start;
  Scalar along;

  [[nodiscard]] bool before() const { return along <= 0; }
  [[nodiscard]] bool after() const { return along >= edge.length_squared; }
  [[nodiscard]] Squared<Scalar> start_distance() const { return {from_start.squaredNorm(), Scalar(1)}; }
  [[nodiscard]] Squared<Scalar> line_distance() const {
    return {from_start.cross(edge.direction).squaredNorm(), edge.length_squared};
  }
};

template <class Scalar, class Face>
Squared<Scalar> edge_distance(const Sphere<Scalar>& sphere, const Face& polygon, std::size_t i) {
  const EdgeView<Scalar> view(sphere, polygon.edges()[i]);
  if (view.before()) return view.start_distance();
  if (view.after()) return EdgeView<Scalar>(sphere, polygon.edges()[polygon.next(i)]).start_distance();
  return view.line_distance();
}

template <class Scalar, class Face>
PlaneSide plane_side(Scalar height, const Sphere<Scalar>& sphere, const Face& polygon) {
  if (plane_distance(height, polygon).within(sphere.radius_squared)) return PlaneSide::Intersects;
  return height > 0 ? PlaneSide::InFront : PlaneSide::Behind;
}

/// Returns the way from the centre down to the foot, taken backwards, in coordinate k.
template <class Scalar, class Face>
Scalar up_from_foot(Scalar height, const Face& polygon, int k) {
  return (height / polygon.normal_squared()) * polygon.plane().normal[k];
}

/// Returns a coordinate of a point as seen from the foot. Subtracts the centre first, then goes up from the foot.
template <class Scalar>
Scalar seen_from_foot(const Scalar& point, const Scalar& center, const Scalar& up) {
  return point - center + up;
}

/// Returns the product of an edge's length and the foot's distance from its line: positive if the foot is on its left.
template <class Scalar>
Scalar side_of_foot(const Scalar& start_u, const Scalar& start_v, const Scalar& direction_u,
                    const Scalar& direction_v) {
  return start_u * direction_v - start_v * direction_u;
}

/// Counts the edges that the ray from the foot along u crosses, in the projection to (u, v) that drops the third axis.
template <class Scalar, class Face>
PointLocation foot(Scalar height, const Sphere<Scalar>& sphere, const Face& polygon) {
  const int u = (polygon.dropped_axis() + 1) % 3, v = (polygon.dropped_axis() + 2) % 3;
  const Scalar up_u = up_from_foot(height, polygon, u), up_v = up_from_foot(height, polygon, v);
  bool inside = false;
  for (std::size_t i = 0; i < polygon.edges().size(); ++i) {
    const auto& edge = polygon.edges()[i];
    const Vector<Scalar>& end = polygon.edges()[polygon.next(i)].start;
    const Scalar start_v = seen_from_foot(edge.start[v], sphere.center[v], up_v);
    const Scalar end_v = seen_from_foot(end[v], sphere.center[v], up_v);
    const bool upwards = start_v <= 0 && end_v > 0, downwards = start_v > 0 && end_v <= 0;
    if (!upwards && !downwards && start_v != 0 && end_v != 0) continue;  // rounded, but their signs are exact
    const Scalar start_u = seen_from_foot(edge.start[u], sphere.center[u], up_u);
    const Scalar end_u = seen_from_foot(end[u], sphere.center[u], up_u);
    // Far from the foot the rounded ends tell alone, as they do of the next edge: the direction of an edge that is
    // nearly parallel to the ray may disagree with them.
    if (start_u < 0 && end_u < 0) continue;
    if (start_u > 0 && end_u > 0) {
      inside = inside != (upwards || downwards);
      continue;
    }
    const Scalar side = side_of_foot(start_u, start_v, edge.direction[u], edge.direction[v]);
    if (side == 0) {  // doubles detect the boundary only as a rounded zero
      const Scalar along = -(start_u * edge.direction[u] + start_v * edge.direction[v]);
      const Scalar length = edge.direction[u] * edge.direction[u] + edge.direction[v] * edge.direction[v];
      if (along >= 0 && along <= length) return PointLocation::Boundary;
    }
    if ((upwards && side > 0) || (downwards && side < 0)) inside = !inside;
  }
  return inside ? PointLocation::Inside : PointLocation::Outside;
}

template <class Scalar>
struct Nearest {
  Feature feature;
  Squared<Scalar> distance;
};

/// Returns the nearest edge or vertex. Edges are compared first, so that on a tie the earlier candidate wins.
template <class Scalar, class Face>
Nearest<Scalar> nearest_on_boundary(const Sphere<Scalar>& sphere, const Face& polygon) {
  // Infinity is the quotient 1 / 0: in some arithmetics products with an infinite scalar are not numbers.
  Nearest<Scalar> edge{{Feature::Kind::Edge, 0}, {1, 0}}, vertex{{Feature::Kind::Vertex, 0}, {1, 0}};
  for (std::size_t i = 0; i < polygon.edges().size(); ++i) {
    const EdgeView<Scalar> view(sphere, polygon.edges()[i]);
    if (view.start_distance() < vertex.distance) vertex = {{Feature::Kind::Vertex, i}, view.start_distance()};
    if (!view.before() && !view.after() && view.line_distance() < edge.distance)
      edge = {{Feature::Kind::Edge, i}, view.line_distance()};
  }
  return vertex.distance < edge.distance ? vertex : edge;
}

template <class Scalar, class Face>
Nearest<Scalar> nearest_feature(Scalar height, PointLocation place, const Sphere<Scalar>& sphere, const Face& polygon) {
  if (place == PointLocation::Inside) return {{Feature::Kind::Face, 0}, plane_distance(height, polygon)};
  return nearest_on_boundary(sphere, polygon);
}

template <class Scalar>
Relation relation(const Squared<Scalar>& distance, Scalar radius_squared) {
  if (!distance.within(radius_squared)) return Relation::Separate;
  return distance.numerator < radius_squared * distance.denominator ? Relation::Overlapping : Relation::Touching;
}

template <class Scalar, class Face>
Vector<Scalar> closest_point(Scalar height, const Feature& feature, const Sphere<Scalar>& sphere, const Face& polygon) {
  if (feature.kind == Feature::Kind::Face)
    return sphere.center - (height / polygon.normal_squared()) * polygon.plane().normal;
  const auto& edge = polygon.edges()[feature.index];
  if (feature.kind == Feature::Kind::Vertex) return edge.start;
  return edge.start + (EdgeView<Scalar>(sphere, edge).along / edge.length_squared) * edge.direction;
}

/// Returns the Newell sum of a loop, as seen from its first vertex.
template <class Vector>
Vector newell_sum(const std::vector<Vector>& relative, std::size_t count) {
  Vector sum = Vector::Zero();
  for (std::size_t i = 0; i < count; ++i) sum += relative[i].cross(relative[i + 1 == count ? 0 : i + 1]);
  return sum;
}

/// Returns the direction from a feature's closest point to the centre, of length 1; that of the front if they coincide.
template <class Scalar, class Face>
Vector<Scalar> contact_normal(Scalar height, const Feature& feature, const Sphere<Scalar>& sphere,
                              const Face& polygon) {
  using std::sqrt;
  const Vector<Scalar>& normal = polygon.plane().normal;
  const Vector<Scalar> away = sphere.center - closest_point(height, feature, sphere, polygon);
  const Scalar squared = away.squaredNorm();
  if (feature.kind != Feature::Kind::Face && squared > 0) return away / Scalar(sqrt(squared));
  const Scalar length = sqrt(polygon.normal_squared());
  return normal / (height < 0 ? Scalar(-length) : length);
}

}  // namespace detail

template <class Scalar>
PreparedPolygon<Scalar>::PreparedPolygon(const Polygon& polygon) {
  const std::size_t count = polygon.vertex_count(), outer = polygon.loop_end(0);
  const Vector origin = detail::vertex<Scalar>(polygon, 0);
  std::vector<Vector> relative(count);
  for (std::size_t i = 0; i < count; ++i) relative[i] = detail::vertex<Scalar>(polygon, i) - origin;

  plane_.point = origin;
  plane_.normal = detail::newell_sum(relative, outer);
  Scalar products = 0;  // the magnitude of the products that are summed to the normal
  for (std::size_t i = 0; i < outer; ++i)
    products += relative[i].cwiseAbs().maxCoeff() * relative[polygon.next(i)].cwiseAbs().maxCoeff();
  normal_squared_ = plane_.normal.squaredNorm();
  dropped_axis_ = touchstone::dropped_axis(plane_.normal);

  std::vector<Scalar> heights(count);
  Scalar mean = 0;
  for (std::size_t i = 0; i < count; ++i) heights[i] = plane_.normal.dot(relative[i]);
  for (std::size_t i = 0; i < outer; ++i) mean += heights[i];
  mean /= Scalar(static_cast<double>(outer));

  using std::abs;
  // Heights below their rounding error count as 0: lifting by noise would move vertices of planar loops.
  Scalar extent = 0;
  for (const Vector& r : relative) extent = std::max(extent, r.cwiseAbs().maxCoeff());
  const Scalar noise = 8 * std::numeric_limits<Scalar>::epsilon() * products * extent;
  const bool planar = std::all_of(heights.begin(), heights.end(), [&](Scalar h) { return abs(h) <= noise; });
  off_plane_ = Scalar(0);
  if (!planar) {
    for (std::size_t i = 0; i < count; ++i) {
      const Scalar displacement = (mean - heights[i]) / plane_.normal[dropped_axis_];
      relative[i][dropped_axis_] += displacement;
      off_plane_ = std::max<Scalar>(off_plane_, abs(displacement));
    }
    plane_.point = origin + relative[0];
  }

  edges_.resize(count);
  next_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    next_[i] = polygon.next(i);
    Edge& edge = edges_[i];
    edge.start = planar ? detail::vertex<Scalar>(polygon, i) : Vector(origin + relative[i]);
    edge.direction = relative[next_[i]] - relative[i];
    // Subtract exact input once, not twice.
    if (planar) edge.direction = detail::vertex<Scalar>(polygon, next_[i]) - detail::vertex<Scalar>(polygon, i);
    edge.length_squared = edge.direction.squaredNorm();
  }
}

template <class Scalar>
PlaneSide plane_side(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  const detail::Sphere<Scalar> sphere(ball);
  return detail::plane_side(detail::height(sphere, polygon), sphere, polygon);
}

template <class Scalar>
PointLocation foot(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  const detail::Sphere<Scalar> sphere(ball);
  return detail::foot(detail::height(sphere, polygon), sphere, polygon);
}

template <class Scalar>
std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  const detail::Sphere<Scalar> sphere(ball);
  std::vector<std::size_t> hit;
  for (std::size_t i = 0; i < polygon.edges().size(); ++i)
    if (detail::edge_distance(sphere, polygon, i).within(sphere.radius_squared)) hit.push_back(i);
  return hit;
}

template <class Scalar>
bool contact(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  const detail::Sphere<Scalar> sphere(ball);
  const Scalar height = detail::height(sphere, polygon);
  if (detail::plane_side(height, sphere, polygon) != PlaneSide::Intersects) return false;
  if (detail::foot(height, sphere, polygon) != PointLocation::Outside) return true;
  for (std::size_t i = 0; i < polygon.edges().size(); ++i)
    if (detail::edge_distance(sphere, polygon, i).within(sphere.radius_squared)) return true;
  return false;
}

template <class Scalar>
Relation relation(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  const detail::Sphere<Scalar> sphere(ball);
  const Scalar height = detail::height(sphere, polygon);
  if (detail::plane_side(height, sphere, polygon) != PlaneSide::Intersects) return Relation::Separate;
  const PointLocation place = detail::foot(height, sphere, polygon);
  return detail::relation(detail::nearest_feature(height, place, sphere, polygon).distance, sphere.radius_squared);
}

template <class Scalar>
Answer answer(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  using detail::to_double;
  const detail::Sphere<Scalar> sphere(ball);
  const Scalar height = detail::height(sphere, polygon);
  const PointLocation place = detail::foot(height, sphere, polygon);
  const auto nearest = detail::nearest_feature(height, place, sphere, polygon);
  const auto plane = detail::plane_distance(height, polygon);
  const PlaneSide side = detail::plane_side(height, sphere, polygon);
  const bool meets_plane = side == PlaneSide::Intersects;
  const double distance = detail::root(nearest.distance);
  return {
      .plane = side,
      .plane_tangent = detail::relation(plane, sphere.radius_squared) == Relation::Touching,
      .foot = place,
      .edges_hit = edges_hit(ball, polygon),
      .relation = meets_plane ? detail::relation(nearest.distance, sphere.radius_squared) : Relation::Separate,
      .nearest = nearest.feature,
      .point = detail::to_doubles(detail::closest_point(height, nearest.feature, sphere, polygon)),
      .distance = distance,
      .off_plane = to_double(polygon.off_plane()),
      .contact_normal = detail::to_doubles<Scalar>(detail::contact_normal(height, nearest.feature, sphere, polygon)),
      .depth = ball.radius - distance};
}

}  // namespace touchstone::fast
