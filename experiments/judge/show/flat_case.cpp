// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/show/flat_case.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace touchstone::show {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Returns the exponent of the power of two that brings the largest coordinate near 1.
int exponent_of(const Polygon& polygon) {
  double largest = 0;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
    largest = std::max(largest, (polygon.vertex(i) / 4 - polygon.vertex(0) / 4).cwiseAbs().maxCoeff());
  return largest > 0 ? std::ilogb(largest) + 2 : 0;
}

}  // namespace

std::vector<std::pair<double, double>> FlatCase::section() const {
  const Vector2d across(-along.y(), along.x());
  std::vector<double> crossings;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector2d a = loop[i] - foot, b = loop[(i + 1) % loop.size()] - foot;
      const double from = a.dot(across), to = b.dot(across);
      if ((from > 0) == (to > 0)) continue;
      crossings.push_back((a + from / (from - to) * (b - a)).dot(along));
    }
  std::ranges::sort(crossings);
  std::vector<std::pair<double, double>> parts;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) parts.emplace_back(crossings[i], crossings[i + 1]);
  return parts;
}

std::vector<std::pair<Vector2d, Vector2d>> FlatCase::other_sections() const {
  const Vector2d across(-along.y(), along.x());
  std::vector<std::pair<Vector2d, Vector2d>> parts;
  for (const auto& face : other_faces) {
    std::vector<Vector2d> crossings;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vector3d &a = face[i], &b = face[(i + 1) % face.size()];
      const double from = (a.head<2>() - foot).dot(across), to = (b.head<2>() - foot).dot(across);
      if ((from > 0) == (to > 0)) continue;
      const Vector3d met = a + from / (from - to) * (b - a);
      crossings.emplace_back((met.head<2>() - foot).dot(along), met.z());
    }
    std::ranges::sort(crossings, [](const Vector2d& a, const Vector2d& b) {
      return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
    });
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) parts.emplace_back(crossings[i], crossings[i + 1]);
  }
  return parts;
}

std::optional<FlatCase> flat_case(const CaseView& view) {
  const Polygon& polygon = view.polygon();
  const int exponent = exponent_of(polygon);
  const Vector3d origin = polygon.vertex(0);
  const auto scaled = [&](const Vector3d& point) -> Vector3d {
    return (point - origin).unaryExpr([&](double x) { return std::ldexp(x, -exponent); });
  };
  Vector3d normal = Vector3d::Zero();
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
    normal += scaled(polygon.vertex(i)).cross(scaled(polygon.vertex(polygon.next(i))));
  const Vector3d edge = scaled(polygon.vertex(1));
  Vector3d right = edge - normal.normalized() * edge.dot(normal.normalized());
  if (!(normal.norm() > 0) || !(right.norm() > 0)) return std::nullopt;
  normal.normalize();
  right.normalize();
  const Vector3d up = normal.cross(right);
  const auto flat = [&](const Vector3d& point) { return Vector2d(scaled(point).dot(right), scaled(point).dot(up)); };

  FlatCase result;
  for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop) {
    auto& points = result.loops.emplace_back();
    for (std::size_t i = polygon.loop_begin(loop); i < polygon.loop_end(loop); ++i)
      points.push_back(flat(polygon.vertex(i)));
  }
  for (const Polygon& face : faces_of(view.shapes)) {
    if (&face == &polygon) continue;
    auto& points = result.other_faces.emplace_back();
    for (std::size_t i = 0; i < face.vertex_count(); ++i) {
      const Vector2d place = flat(face.vertex(i));
      points.emplace_back(place.x(), place.y(), scaled(face.vertex(i)).dot(normal));
    }
  }
  const Vector3d center = view.ball().center, end = view.motion() ? view.motion()->to : center;
  result.foot = flat(center);
  result.foot_at_end = flat(end);
  result.height = scaled(center).dot(normal);
  result.height_at_end = scaled(end).dot(normal);
  result.radius = std::ldexp(view.ball().radius, -exponent);
  if (view.truth.point) result.touched = flat(*view.truth.point);
  if (view.truth.time && std::isfinite(*view.truth.time)) result.time = view.truth.time;

  const Vector2d way = result.foot_at_end - result.foot;
  const Vector2d to_point = result.touched.value_or(result.foot) - result.foot_at(result.time.value_or(0));
  result.along = Vector2d::UnitX();
  if (way.norm() > 1e-9)
    result.along = way.normalized();
  else if (to_point.norm() > 1e-9 * result.radius)
    result.along = to_point.normalized();
  const bool finite = result.foot.allFinite() && result.foot_at_end.allFinite() && std::isfinite(result.height) &&
                      std::isfinite(result.height_at_end) && std::isfinite(result.radius) && result.along.allFinite();
  return finite ? std::optional(result) : std::nullopt;
}

}  // namespace touchstone::show
