// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/bigint_triangle.h"

#include "robust/filtered/detail/bigint_polygon.h"
#include "robust/filtered/detail/bigint_sign.h"

namespace touchstone::filtered {
namespace {

Eigen::Vector3d vector(const double* p) { return {p[0], p[1], p[2]}; }

Polygon polygon(const BallTriangleView& view) {
  return Polygon({vector(view.vertex[0]), vector(view.vertex[1]), vector(view.vertex[2])});
}

Ball ball(const BallTriangleView& view) { return {vector(view.center), view.radius()}; }

}  // namespace

Feature bigint_nearest(const BallTriangleView& view) {
  const auto sign = [&view](SignKind kind, std::size_t i) { return bigint_sign(kind, view, static_cast<int>(i)); };
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

double bigint_point(const BallTriangleView& view, const Feature& feature, int axis) {
  const Polygon triangle = polygon(view);
  return BigIntPolygon(triangle).point(ball(view), feature, axis);
}

double bigint_distance(const BallTriangleView& view, const Feature& feature) {
  const Polygon triangle = polygon(view);
  return BigIntPolygon(triangle).distance(ball(view), feature);
}

}  // namespace touchstone::filtered
