// SPDX-License-Identifier: Apache-2.0
#include "geometry/contact/thesis.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/detail/required.h"

namespace touchstone::thesis {
namespace {

template <class Scalar>
using Vector = Eigen::Matrix<Scalar, 3, 1>;

template <class Scalar>
using Edge = typename PreparedPolygon<Scalar>::Edge;

/// Divides without looking, so that zero gives NaN; Eigen's normalized() looks.
template <class Scalar>
Vector<Scalar> unit(const Vector<Scalar>& v) {
  return v / v.norm();
}

template <class Scalar>
Vector<Scalar> normal_from_three_vertices(const Polygon& polygon) {
  const Vector<Scalar> p0 = polygon.vertex(0).cast<Scalar>();
  const Vector<Scalar> p1 = polygon.vertex(1).cast<Scalar>();
  const Vector<Scalar> p2 = polygon.vertex(2).cast<Scalar>();
  return unit<Scalar>((p2 - p0).cross(p1 - p0));
}

template <class Scalar>
Vector<Scalar> newell_normal(const Polygon& polygon) {
  Vector<Scalar> sum = Vector<Scalar>::Zero();
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
    sum += polygon.vertex(i).cast<Scalar>().cross(polygon.vertex(polygon.next(i)).cast<Scalar>());
  return unit(sum);
}

template <class Scalar>
Edge<Scalar> make_edge(const Polygon& polygon, std::size_t i) {
  const Vector<Scalar> start = polygon.vertex(i).cast<Scalar>();
  const Vector<Scalar> end = polygon.vertex(polygon.next(i)).cast<Scalar>();
  const Vector<Scalar> along = end - start;
  return {start, end, unit(along), along.norm()};
}

template <class Scalar>
Vector<Scalar> center(const Ball& ball) {
  return required(ball).center.cast<Scalar>();
}

template <class Scalar>
bool within(Scalar distance, const Ball& ball, Comparison comparison) {
  const auto radius = static_cast<Scalar>(ball.radius);
  return comparison == Comparison::Strict ? distance < radius : distance <= radius;
}

/// Step (2): s.
template <class Scalar>
Scalar height(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  return polygon.normal().dot(center<Scalar>(ball)) + polygon.offset();
}

/// The angle between u and v, 0 where it is NaN.
template <class Scalar>
double angle(const Vector<Scalar>& u, const Vector<Scalar>& v, const PreparedPolygon<Scalar>& polygon) {
  const Options& options = polygon.options();
  const double magnitude = options.arc == Arc::Cosine
                               ? std::acos(static_cast<double>(u.dot(v) / (u.norm() * v.norm())))
                               : std::atan2(static_cast<double>(u.cross(v).norm()), static_cast<double>(u.dot(v)));
  if (std::isnan(magnitude)) return 0;
  const bool negative = options.angles == Angles::Signed && polygon.normal().dot(u.cross(v)) < 0;
  return negative ? -magnitude : magnitude;
}

/// Step (3) for the loop of the edges [begin, end).
template <class Scalar>
bool inside_loop(const Vector<Scalar>& q, const PreparedPolygon<Scalar>& polygon, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Edge<Scalar>& edge = polygon.edges()[i];
    sum += angle<Scalar>(edge.start - q, edge.end - q, polygon);
  }
  return std::abs(sum) >= polygon.options().match_factor * (2 * std::numbers::pi);
}

template <class Scalar>
Vector<Scalar> closest_point(const Edge<Scalar>& edge, const Vector<Scalar>& point) {
  const Scalar along = (point - edge.start).dot(edge.direction);
  if (along <= 0) return edge.start;
  if (along >= edge.length) return edge.end;
  return edge.start + along * edge.direction;
}

/// Step (4) for one edge.
template <class Scalar>
bool hits(const Ball& ball, const Edge<Scalar>& edge, Comparison comparison) {
  const Vector<Scalar> c = center<Scalar>(ball);
  return within<Scalar>((closest_point<Scalar>(edge, c) - c).norm(), ball, comparison);
}

}  // namespace

template <class Scalar>
PreparedPolygon<Scalar>::PreparedPolygon(const Polygon& polygon, const Options& options)
    : options_(options),
      normal_(options.normal == Normal::Newell ? newell_normal<Scalar>(polygon)
                                               : normal_from_three_vertices<Scalar>(polygon)),
      offset_(-normal_.dot(polygon.vertex(0).cast<Scalar>())) {
  edges_.reserve(polygon.vertex_count());
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) edges_.push_back(make_edge<Scalar>(polygon, i));
  loop_ends_.reserve(polygon.loop_count());
  for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop) loop_ends_.push_back(polygon.loop_end(loop));
}

template <class Scalar>
PlaneSide plane_side(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  const Scalar s = height(ball, polygon);
  if (within(std::abs(s), ball, polygon.options().comparison)) return PlaneSide::Intersects;
  return s >= static_cast<Scalar>(ball.radius) ? PlaneSide::InFront : PlaneSide::Behind;
}

template <class Scalar>
PointLocation foot(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  const Vector<Scalar> q = center<Scalar>(ball) - height(ball, polygon) * polygon.normal();
  const std::vector<std::size_t>& ends = polygon.loop_ends();
  if (!inside_loop(q, polygon, 0, ends[0])) return PointLocation::Outside;
  for (std::size_t hole = 1; hole < ends.size(); ++hole)
    if (inside_loop(q, polygon, ends[hole - 1], ends[hole])) return PointLocation::Outside;
  return PointLocation::Inside;
}

template <class Scalar>
std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  std::vector<std::size_t> hit;
  for (std::size_t i = 0; i < polygon.edges().size(); ++i)
    if (hits<Scalar>(ball, polygon.edges()[i], polygon.options().comparison)) hit.push_back(i);
  return hit;
}

template <class Scalar>
bool contact(const Ball& ball, const PreparedPolygon<Scalar>& polygon) {
  if (plane_side(ball, polygon) != PlaneSide::Intersects) return false;
  if (foot(ball, polygon) == PointLocation::Inside) return true;
  return std::any_of(polygon.edges().begin(), polygon.edges().end(),
                     [&](const Edge<Scalar>& edge) { return hits<Scalar>(ball, edge, polygon.options().comparison); });
}

template class PreparedPolygon<float>;
template PlaneSide plane_side(const Ball&, const PreparedPolygon<float>&);
template PointLocation foot(const Ball&, const PreparedPolygon<float>&);
template std::vector<std::size_t> edges_hit(const Ball&, const PreparedPolygon<float>&);
template bool contact(const Ball&, const PreparedPolygon<float>&);

template class PreparedPolygon<double>;
template PlaneSide plane_side(const Ball&, const PreparedPolygon<double>&);
template PointLocation foot(const Ball&, const PreparedPolygon<double>&);
template std::vector<std::size_t> edges_hit(const Ball&, const PreparedPolygon<double>&);
template bool contact(const Ball&, const PreparedPolygon<double>&);

}  // namespace touchstone::thesis
