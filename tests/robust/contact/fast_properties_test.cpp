// SPDX-License-Identifier: GPL-3.0-or-later
// The identities of geometry/contact/fast.h, and identity (9) of robust/exact/exact.h: `fast` is `exact` where the
// input is far from every boundary, or so small that nothing is rounded.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/contact/fast_error.h"
#include "robust/exact/exact.h"
#include "tests/robust/support/generators.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

using workloads::BallPlace;

/// Within the sizes that `fast` is safe for.
const Draw kSafe{.largest_exponent = 100};

// Identity (1): powers of two scale the lengths.
RC_GTEST_PROP(FastScaling, PowersOfTwoScaleTheLengthsOnly, ()) {
  const Case c = *rc::gen::oneOf(samples({.largest_exponent = 0}), grid_cases(2));
  const int exponent = *rc::gen::resize(100, rc::gen::inRange(-100, 101));
  const Case larger = scaled(c, exponent);
  RC_ASSERT(fast::answer(larger.ball, larger.polygon) == scaled(fast::answer(c.ball, c.polygon), exponent));
}

// Identity (2): growing r never loses a contact, an edge of edges_hit, or Intersects.
RC_GTEST_PROP(FastRadius, GrowingItLosesNothing, ()) {
  const Case c = *rc::gen::oneOf(samples(kSafe), grid_cases(2));
  const fast::PreparedPolygon<> polygon(c.polygon);
  const double factor = *rc::gen::element(1 + 0x1p-52, 1 + 0x1p-51, 1 + 0x1p-30, 1.5, 4.0);
  const Ball larger{c.ball.center, factor * c.ball.radius};
  const Answer before = fast::answer(c.ball, polygon), after = fast::answer(larger, polygon);
  RC_ASSERT(!fast::contact(c.ball, polygon) || fast::contact(larger, polygon));
  RC_ASSERT(after.relation >= before.relation);
  RC_ASSERT(fast::relation(larger, polygon) >= fast::relation(c.ball, polygon));
  RC_ASSERT(before.plane != PlaneSide::Intersects || after.plane == PlaneSide::Intersects);
  RC_ASSERT(
      std::includes(after.edges_hit.begin(), after.edges_hit.end(), before.edges_hit.begin(), before.edges_hit.end()));
}

/// The foot of the perpendicular, nearly.
Eigen::Vector3d rounded_foot(const Ball& ball, const fast::PreparedPolygon<>& polygon) {
  const auto& [normal, point] = polygon.plane();
  return ball.center - normal.dot(ball.center - point) / polygon.normal_squared() * normal;
}

/// Is the foot so near to an edge that rounding may put it on either side?
bool foot_on_boundary_but_for_rounding(const Case& c) {
  const double noise = 0x1p-40 * (extent(c.polygon) + c.polygon.vertex(0).cwiseAbs().maxCoeff());
  const Eigen::Vector3d foot = rounded_foot(c.ball, fast::PreparedPolygon<>(c.polygon));
  return !exact::edges_hit({foot, noise}, c.polygon).empty();
}

// Identity (3): mirroring in a coordinate plane mirrors the point, swaps front and back, and changes nothing else but
// the side of a boundary that rounding hides.
RC_GTEST_PROP(FastMirror, MirroringMirrorsThePointAndSwapsFrontAndBehind, ()) {
  const Case c = *rc::gen::oneOf(samples(kSafe), grid_cases(2));
  const PointMap mirror = mirror_along(*rc::gen::inRange(0, 3));
  const Case image = moved(c, mirror);
  Answer expected = fast::answer(c.ball, c.polygon);
  const Answer answer = fast::answer(image.ball, image.polygon);
  expected.point = mirror(expected.point);
  expected.contact_normal = mirror(expected.contact_normal);
  // The front swaps, and is the normal of a point of the polygon.
  if (same_point(expected.contact_normal, -answer.contact_normal)) expected.contact_normal = answer.contact_normal;
  if (expected.plane != PlaneSide::Intersects)
    expected.plane = expected.plane == PlaneSide::InFront ? PlaneSide::Behind : PlaneSide::InFront;
  if (answer.foot != expected.foot) {
    RC_ASSERT(foot_on_boundary_but_for_rounding(c));
    RC_ASSERT(answer.edges_hit == expected.edges_hit);
    RC_ASSERT(answer.plane == expected.plane);
    return;
  }
  RC_ASSERT(answer == expected);
}

// The questions one by one are the keys of the whole answer, in each scalar.
template <class Scalar>
void single_questions_agree(const Case& c) {
  const fast::PreparedPolygon<Scalar> polygon(c.polygon);
  const Answer a = fast::answer(c.ball, polygon);
  RC_ASSERT(fast::plane_side(c.ball, polygon) == a.plane);
  RC_ASSERT(fast::foot(c.ball, polygon) == a.foot);
  RC_ASSERT(fast::edges_hit(c.ball, polygon) == a.edges_hit);
}

RC_GTEST_PROP(FastTogether, SingleQuestionsAgreeWithTheWholeAnswer, ()) {
  const Case c = *samples({.largest_exponent = 0});
  single_questions_agree<float>(c);
  single_questions_agree<double>(c);
  single_questions_agree<long double>(c);
  const fast::PreparedPolygon<> polygon(c.polygon);
  RC_ASSERT(fast::answer(c.ball, c.polygon) == fast::answer(c.ball, polygon));
  RC_ASSERT(fast::contact(c.ball, c.polygon) == fast::contact(c.ball, polygon));
  RC_ASSERT(fast::relation(c.ball, c.polygon) == fast::relation(c.ball, polygon));
  RC_ASSERT(fast::plane_side(c.ball, c.polygon) == fast::plane_side(c.ball, polygon));
  RC_ASSERT(fast::foot(c.ball, c.polygon) == fast::foot(c.ball, polygon));
  RC_ASSERT(fast::edges_hit(c.ball, c.polygon) == fast::edges_hit(c.ball, polygon));
}

bool same_decisions(const Answer& a, const Answer& b) {
  return a.plane == b.plane && a.plane_tangent == b.plane_tangent && a.foot == b.foot && a.edges_hit == b.edges_hit &&
         a.relation == b.relation && a.nearest == b.nearest;
}

/// How far numbers may be off, and decisions be wrong: the bound of fast_error.h, and 2^-20 of the size (the larger of
/// polygon and distance) where this has none, as of lifted loops.
double reach(const Case& c, const Answer& here) {
  const double bound = fast::contact_error({c.ball.center, here.distance}, fast::PreparedPolygon<>(c.polygon));
  if (std::isfinite(bound)) return bound + fast::error::kOffPlane * here.off_plane;
  return 0x1p-20 * std::max({extent(c.polygon), here.distance, c.ball.radius});
}

/// The exact decisions stay the same where the radius, or the centre along any axis, changes by twice the reach both
/// ways. A boundary through the ball's own place would lie between two of these.
bool far_from_every_boundary(const Case& c, const Answer& here, const exact::PreparedPolygon& polygon) {
  const double step = 2 * reach(c, here);
  const auto same = [&](const Eigen::Vector3d& center, double radius) {
    return radius >= 0 && same_decisions(exact::answer({center, radius}, polygon), here);
  };
  for (const double s : {-step, step}) {
    if (!same(c.ball.center, c.ball.radius + s)) return false;
    for (int axis = 0; axis < 3; ++axis)
      if (!same(c.ball.center + s * Eigen::Vector3d::Unit(axis), c.ball.radius)) return false;
  }
  return true;
}

/// Samples whose radius has left the threshold, some by no more than the reach.
rc::Gen<Case> off_the_threshold() {
  const Draw draw{.balls = {BallPlace::Anywhere, BallPlace::NearFace, BallPlace::NearEdge, BallPlace::NearVertex},
                  .farthest = 0x1p10,
                  .largest_exponent = 100};
  return rc::gen::exec([draw] {
    Case c = *samples(draw);
    const Answer answer = exact::answer(c.ball, c.polygon);
    c.ball.radius *= *rc::gen::element(0.25, 0.75, 1.0, 1.25, 2.0);
    c.ball.radius = std::max(0.0, c.ball.radius + *rc::gen::element(-3, 0, 3) * reach(c, answer));
    return c;
  });
}

/// Numbers agree up to the reach, and what coordinates are rounded to.
template <class Scalar>
void expect_equal_when_far(const Case& c, const Answer& expected) {
  const fast::PreparedPolygon<Scalar> polygon(c.polygon);
  const Answer actual = fast::answer(c.ball, polygon);
  const double noise = reach(c, expected) + 0x1p-50 * (extent(c.polygon) + c.polygon.vertex(0).cwiseAbs().maxCoeff() +
                                                       c.ball.center.cwiseAbs().maxCoeff());
  RC_ASSERT(same_decisions(actual, expected));
  RC_ASSERT((actual.point - expected.point).cwiseAbs().maxCoeff() <= noise);
  RC_ASSERT(std::abs(actual.distance - expected.distance) <= noise);
  RC_ASSERT(std::abs(actual.depth - expected.depth) <= noise);
  RC_ASSERT((actual.contact_normal - expected.contact_normal).norm() * expected.distance <= 2 * noise);
  RC_ASSERT(std::abs(actual.off_plane - expected.off_plane) <= noise);
  RC_ASSERT(fast::contact(c.ball, polygon) == expected.contact());
  RC_ASSERT(fast::relation(c.ball, polygon) == expected.relation);
}

// Identity (9) of `exact`: equal far from every boundary.
RC_GTEST_PROP(FastAgainstExact, EqualFarFromEveryBoundary, ()) {
  const Case c = *off_the_threshold();
  const exact::PreparedPolygon polygon(c.polygon);
  const Answer expected = exact::answer(c.ball, polygon);
  RC_PRE(far_from_every_boundary(c, expected, polygon));
  expect_equal_when_far<double>(c, expected);
  expect_equal_when_far<long double>(c, expected);
}

// Small integers in an axis-parallel plane: nothing that decides is rounded, so ties, touching and boundaries agree.
RC_GTEST_PROP(FastAgainstExact, EqualOnSmallIntegers, ()) {
  const Case c = *grid_cases();
  const Answer expected = exact::answer(c.ball, c.polygon), actual = fast::answer(c.ball, c.polygon);
  RC_ASSERT(same_decisions(actual, expected));
  RC_ASSERT((actual.point - expected.point).cwiseAbs().maxCoeff() <= 0x1p-48);
  RC_ASSERT(std::abs(actual.distance - expected.distance) <= 0x1p-48);
  RC_ASSERT(std::abs(actual.depth - expected.depth) <= 0x1p-48);
  RC_ASSERT((actual.contact_normal - expected.contact_normal).norm() <= 0x1p-48);
  RC_ASSERT(actual.off_plane == 0);
  RC_ASSERT(fast::contact(c.ball, c.polygon) == expected.contact());
  RC_ASSERT(fast::relation(c.ball, c.polygon) == expected.relation);
}

// Loops that are planar by construction are left where they are, whatever the frame: the lift is not noise.
RC_GTEST_PROP(FastLift, LeavesPlanarLoopsWhereTheyAre, ()) {
  const Case c =
      *samples({.placements = {workloads::Placement::LatticeFrame}, .largest_warp = 0, .largest_exponent = 100});
  const fast::PreparedPolygon<> polygon(c.polygon);
  RC_ASSERT(polygon.off_plane() == 0);
  for (std::size_t i = 0; i < c.polygon.vertex_count(); ++i) RC_ASSERT(polygon.edges()[i].start == c.polygon.vertex(i));
}

}  // namespace
}  // namespace touchstone::contact_tests
