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
int exponent_of(const cases::Shapes& shapes) {
  double largest = 0;
  for (std::size_t i = 0; i < shapes.polygon.vertex_count(); ++i)
    largest = std::max(largest, (shapes.polygon.vertex(i) / 4 - shapes.polygon.vertex(0) / 4).cwiseAbs().maxCoeff());
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

std::optional<FlatCase> flat_case(const CaseView& view) {
  const cases::Shapes& shapes = view.shapes;
  const Polygon& polygon = shapes.polygon;
  const int exponent = exponent_of(shapes);
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
  const Vector3d center = shapes.ball().center, end = shapes.motion() ? shapes.motion()->to : center;
  result.foot = flat(center);
  result.foot_at_end = flat(end);
  result.height = scaled(center).dot(normal);
  result.height_at_end = scaled(end).dot(normal);
  result.radius = std::ldexp(shapes.ball().radius, -exponent);
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
