// SPDX-License-Identifier: GPL-3.0-or-later
// Moving balls in plain floating point: the guarantees of geometry/contact/fast_motion.h, and how near it comes.
#include "geometry/contact/fast_motion.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/contact/fast_triangle.h"
#include "robust/exact/motion.h"
#include "tests/robust/support/hand_cases.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

/// Compares all members; times and points within rounding errors.
void expect_near(const FirstContact& found, const FirstContact& expected, double error, const std::string& id) {
  EXPECT_EQ(found.kind, expected.kind) << id;
  EXPECT_EQ(found.momentary, expected.momentary) << id;
  EXPECT_EQ(found.feature, expected.feature) << id;
  if (expected.contact()) {
    EXPECT_NEAR(found.time, expected.time, error) << id;
  }
  EXPECT_LE((found.point - expected.point).norm(), error) << id;
  EXPECT_LE((found.contact_normal - expected.contact_normal).norm(), error) << id;
  EXPECT_NEAR(found.depth, expected.depth, error) << id;
}

/// Whether all sizes are safe, also for float.
bool is_safe(const MovingHandCase& c) {
  return c.given.motion.to.norm() < 100 && c.given.motion.ball.center.norm() < 100;
}

template <class Scalar>
void expect_hand_cases(double error) {
  for (const MovingHandCase& c : moving_hand_cases()) {
    if (!is_safe(c)) continue;
    const auto& [given, expected] = c;
    const fast::PreparedPolygon<Scalar> polygon(given.polygon);
    expect_near(fast::first_contact(given.motion, polygon), expected, error, given.id);
    EXPECT_EQ(fast::contact(given.motion, polygon), expected.contact()) << given.id;
  }
}

TEST(FastMotionCases, AreThoseDerivedByHandInDoubles) { expect_hand_cases<double>(1e-15); }
TEST(FastMotionCases, AreThoseDerivedByHandInFloats) { expect_hand_cases<float>(1e-6); }
TEST(FastMotionCases, AreThoseDerivedByHandInLongDoubles) { expect_hand_cases<long double>(1e-15); }

TEST(FastMotionCases, AnUnpreparedPolygonIsPrepared) {
  for (const auto& [given, expected] : moving_hand_cases()) {
    const fast::PreparedPolygon<> polygon(given.polygon);
    EXPECT_EQ(fast::first_contact(given.motion, given.polygon), fast::first_contact(given.motion, polygon)) << given.id;
    EXPECT_EQ(fast::contact(given.motion, given.polygon), fast::contact(given.motion, polygon)) << given.id;
  }
}

bool is_triangle(const Polygon& polygon) { return polygon.vertex_count() == 3; }

/// Triangles, mostly in small integers.
rc::Gen<MovingCase> moving_triangles() {
  return rc::gen::map(any_moving_case(), [](MovingCase c) {
    c.polygon = Polygon({c.polygon.vertex(0), c.polygon.vertex(1), c.polygon.vertex(2)});
    return c;
  });
}

// Guarantee (1).
RC_GTEST_PROP(FastMotion, ContactIsThatOfTheFirstContact, ()) {
  const MovingCase c = *any_moving_case();
  const fast::PreparedPolygon<> polygon(c.polygon);
  const fast::PreparedPolygon<float> float_polygon(c.polygon);
  RC_ASSERT(fast::contact(c.motion, polygon) == fast::first_contact(c.motion, polygon).contact());
  RC_ASSERT(fast::contact(c.motion, float_polygon) == fast::first_contact(c.motion, float_polygon).contact());
  if (is_triangle(c.polygon)) {
    const Triangle triangle = triangle_of(c.polygon);
    RC_ASSERT(fast::contact(c.motion, triangle) == fast::first_contact(c.motion, triangle).contact());
  }
}

// Guarantee (2).
RC_GTEST_PROP(FastMotion, StartsAsTheStaticBall, ()) {
  const MovingCase c = *moving(samples({.largest_exponent = 0}));
  const fast::PreparedPolygon<> polygon(c.polygon);
  const FirstContact first = fast::first_contact(c.motion, polygon);
  RC_ASSERT(fast::contact(c.motion.ball, polygon) == (first.kind == FirstContactKind::Start));
  RC_PRE(first.kind == FirstContactKind::Start);
  const Answer answer = fast::answer(c.motion.ball, polygon);
  RC_ASSERT(first == at_start(answer));
  if (is_triangle(c.polygon))
    RC_ASSERT(fast::contact(c.motion.ball, triangle_of(c.polygon)) ==
              (fast::first_contact(c.motion, triangle_of(c.polygon)).kind == FirstContactKind::Start));
}

/// Whether the time is one that the kind allows.
bool is_legal(const FirstContact& first) {
  switch (first.kind) {
    case FirstContactKind::Start: return first.time == 0;
    case FirstContactKind::Way: return first.time >= 0 && first.time <= 1;
    case FirstContactKind::None: break;
  }
  return first.time == std::numeric_limits<double>::infinity();
}

// Guarantee (3), at any size: products overflow and underflow.
RC_GTEST_PROP(FastMotion, NoTimeIsNaN, ()) {
  const auto number = [] {
    const auto mantissa = static_cast<double>(*rc::gen::inRange(-100, 101));
    return std::ldexp(
        mantissa, *rc::gen::resize(100, rc::gen::element(-1074, -600, -300, -150, 0, 0, 0, 150, 300, 600, 1000, 1017)));
  };
  const auto point = [&] {
    const double x = number(), y = number(), z = number();
    return Eigen::Vector3d(x, y, z);
  };
  const Triangle triangle{point(), point(), point()};
  const Motion motion{{point(), std::abs(number())}, point()};
  RC_ASSERT(is_legal(fast::first_contact(motion, triangle)));
  RC_PRE(triangle.a != triangle.b && triangle.b != triangle.c && triangle.c != triangle.a);
  const Polygon polygon({triangle.a, triangle.b, triangle.c});
  RC_ASSERT(is_legal(fast::first_contact(motion, polygon)));
  RC_ASSERT(is_legal(fast::first_contact(motion, fast::PreparedPolygon<float>(polygon))));
}

// Guarantee (4).
RC_GTEST_PROP(FastMotion, PowersOfTwoScaleThePointOnly, ()) {
  const MovingCase c = *moving(rc::gen::oneOf(grid_cases(), grid_cases(2)));
  const int exponent = *rc::gen::resize(100, rc::gen::inRange(-100, 100));
  const Case larger = scaled(Case{c.id, c.motion.ball, c.polygon}, exponent);
  const auto scale = [exponent](const Eigen::Vector3d& v) { return Eigen::Vector3d(std::ldexp(1.0, exponent) * v); };
  FirstContact expected = fast::first_contact(c.motion, c.polygon);
  expected.point = scale(expected.point);
  expected.depth = std::ldexp(expected.depth, exponent);
  RC_ASSERT(fast::first_contact({larger.ball, scale(c.motion.to)}, larger.polygon) == expected);
}

/// Whether a radius that differs by the share 2^-30 of the polygon's size changes when the ball touches by more than a
/// little.
bool is_near_boundary(const MovingCase& c, const FirstContact& first) {
  const exact::PreparedPolygon polygon(c.polygon);
  const PlaneSide side = exact::plane_side(c.motion.ball, polygon);
  for (const double sign : {-1, 1}) {
    Motion motion = c.motion;
    motion.ball.radius = std::max(0.0, motion.ball.radius + sign * 0x1p-30 * extent(c.polygon));
    // Where the plane is tangent at the start up to rounding, fast may lose it, and whatever is touched later.
    if (exact::plane_side(motion.ball, polygon) != side) return true;
    const FirstContact other = exact::first_contact(motion, polygon);
    if (other.kind != first.kind || (first.contact() && std::abs(other.time - first.time) > 0x1p-20)) return true;
  }
  return false;
}

// Away from boundaries the answer is the exact one, except for roundings.
RC_GTEST_PROP(FastMotion, IsNearTheExactAnswerAwayFromBoundaries, ()) {
  const MovingCase c =
      *moving(samples({.balls = {workloads::BallPlace::Anywhere}, .farthest = 1, .largest_exponent = 0}));
  const FirstContact expected = exact::first_contact(c.motion, c.polygon);
  RC_PRE(c.motion.ball.radius > 0 && !is_near_boundary(c, expected));
  const FirstContact found = fast::first_contact(c.motion, c.polygon);
  RC_ASSERT(found.kind == expected.kind);
  if (found.contact()) RC_ASSERT(std::abs(found.time - expected.time) <= 0x1p-20);
}

RC_GTEST_PROP(FastMotion, TrianglesAreNearTheExactAnswerAwayFromBoundaries, ()) {
  MovingCase c = *moving_triangles();
  RC_PRE(c.id.find("-e") == std::string::npos);
  const double area =
      (c.polygon.vertex(1) - c.polygon.vertex(0)).cross(c.polygon.vertex(2) - c.polygon.vertex(0)).norm();
  RC_PRE(area > 0x1p-10 * extent(c.polygon) * extent(c.polygon));
  const FirstContact expected = exact::first_contact(c.motion, c.polygon);
  RC_PRE(c.motion.ball.radius > 0 && c.motion.ball.center.norm() < 0x1p10 * extent(c.polygon));
  RC_PRE(!is_near_boundary(c, expected));
  const FirstContact found = fast::first_contact(c.motion, triangle_of(c.polygon));
  RC_ASSERT(found.kind == expected.kind);
  if (found.contact()) RC_ASSERT(std::abs(found.time - expected.time) <= 0x1p-20);
}

}  // namespace
}  // namespace touchstone::contact_tests
