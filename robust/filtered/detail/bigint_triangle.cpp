// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/bigint_triangle.h"

#include "robust/filtered/detail/bigint_polygon.h"
#include "robust/filtered/detail/bigint_sign.h"

namespace touchstone::filtered {
namespace {

Eigen::Vector3d vector(const double* p) { return {p[0], p[1], p[2]}; }

Polygon polygon(const TriangleQuestion& question) {
  return Polygon({vector(question.vertex[0]), vector(question.vertex[1]), vector(question.vertex[2])});
}

Ball ball(const TriangleQuestion& question) { return {vector(question.center), question.radius()}; }

}  // namespace

Feature unlimited_nearest(const TriangleQuestion& question) {
  const auto sign = [&question](SignKind kind, std::size_t i) {
    return unlimited_sign(kind, question, static_cast<int>(i));
  };
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (sign(SignKind::Side, i) > 0) continue;
    inside = false;
    if (sign(SignKind::Along, i) > 0 && sign(SignKind::Beyond, i) < 0) return {Feature::Kind::Edge, i};
  }
  if (inside) return {Feature::Kind::Face, 0};
  for (std::size_t i = 0; i < 2; ++i)
    if (sign(SignKind::Along, i) <= 0 && sign(SignKind::Beyond, (i + 2) % 3) >= 0) return {Feature::Kind::Vertex, i};
  return {Feature::Kind::Vertex, 2};
}

double unlimited_point(const TriangleQuestion& question, const Feature& feature, int axis) {
  const Polygon triangle = polygon(question);
  return UnlimitedPolygon(triangle).point(ball(question), feature, axis);
}

double unlimited_distance(const TriangleQuestion& question, const Feature& feature) {
  const Polygon triangle = polygon(question);
  return UnlimitedPolygon(triangle).distance(ball(question), feature);
}

}  // namespace touchstone::filtered
