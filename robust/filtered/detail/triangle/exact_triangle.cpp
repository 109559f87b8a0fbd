// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/triangle/exact_triangle.h"

#include <utility>

#include "geometry/shapes/polygon.h"
#include "robust/detail/exact_kernel.h"
#include "robust/exact/motion.h"
#include "robust/exact/validate.h"
#include "robust/filtered/detail/numbers/permanent.h"
#include "robust/filtered/detail/signs/bigint_polygon.h"
#include "robust/filtered/detail/signs/bounds.h"

namespace touchstone::filtered::detail {

namespace {

using Number = kernel::Mpzf;  // integers times powers of two: the signs need no division

Vector3<Number> difference(const double* a, const double* b) {
  return {Number(a[0]) - Number(b[0]), Number(a[1]) - Number(b[1]), Number(a[2]) - Number(b[2])};
}

struct TriangleView {
  const BallTriangleView& view;
  int i;

  [[nodiscard]] Vector3<Number> to_center() const { return difference(view.center, view.vertex[i]); }
  [[nodiscard]] Vector3<Number> edge() const { return difference(view.vertex[(i + 1) % 3], view.vertex[i]); }
  [[nodiscard]] Vector3<Number> normal() const {
    return signs::normal(difference(view.vertex[1], view.vertex[0]), difference(view.vertex[2], view.vertex[1]));
  }
  [[nodiscard]] Number radius() const { return Number(view.radius()); }
  [[nodiscard]] static int axis() { return 0; }
};

Eigen::Vector3d point(const double* p) { return {p[0], p[1], p[2]}; }

Triangle triangle_of(const double (*vertex)[3]) { return {point(vertex[0]), point(vertex[1]), point(vertex[2])}; }
Motion motion_of(const MotionTriangleView& view) {
  return {{point(view.motion), view.radius()}, point(view.motion + 4)};
}

/// Returns whether some component of the normal is certainly not zero. A finite triangle is then valid.
bool has_surely_normal(const Triangle& t) {
  const Eigen::Vector3d u = t.b - t.a, v = t.c - t.a;
  const auto known = [](double difference) { return rounded_double(difference); };
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    if (certain_sign(known(u[i]) * known(v[j]) - known(u[j]) * known(v[i]), bounds::kTiny) != 0) return true;
  }
  return false;
}

/// Returns what integers find of the triangle's feature that is nearest to the ball's centre, or for a degenerate
/// triangle, of which there are no such integers, what `exact` does.
template <class FromIntegers, class FromExact>
auto rounded_of(const BallTriangleView& view, double radius, const FromIntegers& integers, const FromExact& exactly) {
  const Triangle triangle = triangle_of(view.vertex);
  const Ball ball{point(view.center), radius};
  if (is_degenerate(view.vertex)) return exactly(exact::answer(ball, exact::PreparedPolygon(triangle)));
  const Polygon polygon({triangle.a, triangle.b, triangle.c});
  return integers(BigIntPolygon(polygon), ball);
}

}  // namespace

bool is_degenerate(const double (*vertex)[3]) {
  const Triangle t = triangle_of(vertex);
  if (has_surely_normal(t)) return false;
  if (t.a == t.b || t.b == t.c || t.c == t.a) return true;  // exact
  for (int axis = 0; axis < 3; ++axis)
    if (bigint_turn(vertex[0], vertex[1], vertex[2], axis) != 0) return false;
  return true;
}

int bigint_sign(SignKind kind, const BallTriangleView& view, int edge) {
  return expression_sign(kind, TriangleView{view, edge});
}

int bigint_turn(const double* a, const double* b, const double* p, int axis) {
  return sign(cross(difference(b, a), difference(p, a))[axis]);
}

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
  return rounded_of(
      view, 0, [&](const BigIntPolygon& triangle, const Ball& ball) { return triangle.point(ball, feature, axis); },
      [axis](const Answer& answer) -> double { return answer.point[axis]; });
}

double bigint_distance(const BallTriangleView& view, const Feature& feature) {
  return rounded_of(
      view, 0, [&](const BigIntPolygon& triangle, const Ball& ball) { return triangle.distance(ball, feature); },
      [](const Answer& answer) { return answer.distance; });
}

Eigen::Vector3d bigint_normal(const BallTriangleView& view, const Feature& feature) {
  return rounded_of(
      view, 0, [&](const BigIntPolygon& triangle, const Ball& ball) { return triangle.contact_normal(ball, feature); },
      [](const Answer& answer) { return answer.contact_normal; });
}

double bigint_depth(const BallTriangleView& view, double radius, const Feature& feature) {
  return rounded_of(
      view, radius, [&](const BigIntPolygon& triangle, const Ball& ball) { return triangle.depth(ball, feature); },
      [](const Answer& answer) { return answer.depth; });
}

bool exact_motion_contact(const MotionTriangleView& view) {
  return exact::contact(motion_of(view), triangle_of(view.vertex));
}
FirstContact exact_first_contact(const MotionTriangleView& view) {
  return exact::first_contact(motion_of(view), triangle_of(view.vertex));
}

void expect_valid(const Triangle& t, Degenerate degenerate) {
  const bool accepts_degenerate = degenerate == Degenerate::AsSegments;
  if (t.a.allFinite() && t.b.allFinite() && t.c.allFinite() && (accepts_degenerate || has_surely_normal(t))) return;
  if (auto rejection = exact::validate(Polygon({t.a, t.b, t.c}))) throw Rejected(std::move(*rejection));
}

}  // namespace touchstone::filtered::detail
