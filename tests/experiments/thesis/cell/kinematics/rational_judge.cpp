// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/thesis/cell/kinematics/rational_judge.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace touchstone::kinematics {
namespace {

RationalPoint rational(const Eigen::Vector3d& v) { return {mpq_class(v.x()), mpq_class(v.y()), mpq_class(v.z())}; }

mpq_class dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {mpq_class(a[1] * b[2] - a[2] * b[1]), mpq_class(a[2] * b[0] - a[0] * b[2]),
          mpq_class(a[0] * b[1] - a[1] * b[0])};
}

/// a + s b.
RationalPoint moved(const RationalPoint& a, const mpq_class& s, const RationalPoint& b) {
  return {mpq_class(a[0] + s * b[0]), mpq_class(a[1] + s * b[1]), mpq_class(a[2] + s * b[2])};
}

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) { return moved(a, -1, b); }

mpq_class squared_distance_from_segment(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
  const RationalPoint along = minus(b, a);
  mpq_class t = dot(minus(p, a), along) / dot(along, along);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const RationalPoint rest = minus(p, moved(a, t, along));
  return dot(rest, rest);
}

}  // namespace

ArcPoint exact_point(const Arc& arc, const mpq_class& tangent) {
  const RationalPoint n = rational(arc.axis), v = minus(rational(arc.start), rational(arc.point));
  const mpq_class t = tangent, whole = 1 + t * t * dot(n, n);
  const mpq_class cosine = (2 - whole) / whole, sine_by_length = 2 * t / whole;
  const RationalPoint along = moved({0, 0, 0}, mpq_class(dot(v, n) / dot(n, n)), n), across = minus(v, along);
  RationalPoint point = moved(rational(arc.point), 1, along);
  point = moved(point, cosine, across);
  point = moved(point, sine_by_length, cross(n, v));
  const double half = std::atan(t.get_d() * std::sqrt(dot(n, n).get_d()));
  return {half * 360 / std::numbers::pi, point};
}

ArcPoint exact_point_near(const Arc& arc, double degrees) {
  return exact_point(arc, mpq_class(std::tan(degrees * std::numbers::pi / 360) / arc.axis.norm()));
}

mpq_class squared_distance(const RationalPoint& point, const Polygon& polygon) {
  const std::size_t outer = polygon.loop_end(0);
  RationalPoint normal{0, 0, 0}, mean{0, 0, 0};
  for (std::size_t i = 0; i < outer; ++i) {
    normal = moved(normal, 1, cross(rational(polygon.vertex(i)), rational(polygon.vertex(polygon.next(i)))));
    mean = moved(mean, mpq_class(1, outer), rational(polygon.vertex(i)));
  }
  std::size_t k = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (abs(normal[axis]) > abs(normal[k])) k = axis;
  std::vector<RationalPoint> lifted;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
    lifted.push_back(rational(polygon.vertex(i)));
    lifted.back()[k] -= dot(normal, minus(lifted.back(), mean)) / normal[k];
  }
  const mpq_class height = dot(normal, minus(point, mean));
  const RationalPoint foot = moved(point, mpq_class(-height / dot(normal, normal)), normal);
  const std::size_t i = k == 0 ? 1 : 0, j = k == 2 ? 1 : 2;
  bool inside = false;
  mpq_class least = -1;
  for (std::size_t edge = 0; edge < lifted.size(); ++edge) {
    const RationalPoint &a = lifted[edge], &b = lifted[polygon.next(edge)];
    const mpq_class distance = squared_distance_from_segment(point, a, b);
    if (least < 0 || distance < least) least = distance;
    if ((a[j] > foot[j]) == (b[j] > foot[j])) continue;
    if (foot[i] < a[i] + (foot[j] - a[j]) / (b[j] - a[j]) * (b[i] - a[i])) inside = !inside;
  }
  return inside ? mpq_class(height * height / dot(normal, normal)) : least;
}

bool touches(const RationalPoint& center, double radius, const scene::Faces& faces) {
  const mpq_class reach = mpq_class(radius) * mpq_class(radius);
  for (const Triangle& t : faces.triangles)
    if (squared_distance(center, Polygon({t.a, t.b, t.c})) <= reach) return true;
  for (const Polygon& polygon : faces.polygons)
    if (squared_distance(center, polygon) <= reach) return true;
  return false;
}

}  // namespace touchstone::kinematics
