// SPDX-License-Identifier: GPL-3.0-or-later
// The identities of geometry/contact/fast_triangle.h, and that it says what `exact` says away from the threshold.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "geometry/contact/fast.h"
#include "geometry/contact/fast_error.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "tests/robust/support/generators.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

using workloads::BallPlace;
using workloads::Placement;

bool touches(const Case& c) { return fast::contact(c.ball, triangle_of(c.polygon)); }

/// Triangles of the workloads, some far from the origin, with balls about their thresholds and anywhere.
rc::Gen<Case> triangles() {
  return rc::gen::exec([] {
    workloads::Workload workload;
    workload.family = workloads::Family::Triangle;
    workload.placement = *rc::gen::element(Placement::LatticeFrame, Placement::Rotated);
    workload.ball =
        *rc::gen::element(BallPlace::Anywhere, BallPlace::NearFace, BallPlace::NearEdge, BallPlace::NearVertex);
    workload.origin_distance = *rc::gen::element(0.0, 0.0, 1.0, 0x1p10);
    const auto index = *rc::gen::resize(100, rc::gen::inRange<std::uint64_t>(0, 1'000'000));
    const auto sample = [&]() -> std::optional<workloads::Sample> {
      try {
        return workloads::sample(workload, 1, index);
      } catch (const std::invalid_argument&) {
        return std::nullopt;  // the triangle has no such ball
      }
    }();
    RC_PRE(sample.has_value());
    return Case{sample->id, sample->ball, sample->polygon};
  });
}

/// Small integers in a coordinate plane: no product is rounded, and touching is common.
rc::Gen<Case> small_triangles() {
  return rc::gen::exec([] {
    const int axis = *rc::gen::inRange(0, 3);
    const auto coordinate = [] { return static_cast<double>(*rc::gen::inRange(-3, 4)); };
    const auto point = [&](double height) {
      const double u = coordinate(), v = coordinate();
      Eigen::Vector3d p;
      p[axis] = height;
      p[(axis + 1) % 3] = u;
      p[(axis + 2) % 3] = v;
      return p;
    };
    const double height = coordinate();
    const Eigen::Vector3d a = point(height), b = point(height), c = point(height);
    RC_PRE(a != b && b != c && c != a);
    const Polygon polygon({a, b, c});
    RC_PRE(!exact::validate(polygon));
    return Case{"small integers", {point(coordinate()), std::abs(coordinate())}, polygon};
  });
}

// Right away from the threshold, whichever vertex comes first and however they turn.
RC_GTEST_PROP(FastTriangle, IsRightAwayFromTheThreshold, ()) {
  Case c = *triangles();
  c.ball.radius *= *rc::gen::element(0.75, 1.0, 1.25);
  const Answer answer = exact::answer(c.ball, c.polygon);
  const double bound = fast::contact_error({c.ball.center, answer.distance}, triangle_of(c.polygon));
  if (std::abs(answer.depth) <= 1.01 * bound)
    c.ball.radius = answer.distance + *rc::gen::element(-1.01, 1.01, 4.0) * bound;
  RC_PRE(c.ball.radius >= 0 && std::isfinite(bound));

  const bool contact = c.ball.radius > answer.distance;
  RC_ASSERT(touches(c) == contact);
  std::array<Eigen::Vector3d, 3> v{c.polygon.vertex(0), c.polygon.vertex(1), c.polygon.vertex(2)};
  for (int turn = 0; turn < 3; ++turn) {
    std::rotate(v.begin(), v.begin() + 1, v.end());
    RC_ASSERT(fast::contact(c.ball, Triangle{v[0], v[1], v[2]}) == contact);
    RC_ASSERT(fast::contact(c.ball, Triangle{v[2], v[1], v[0]}) == contact);
  }
}

// Touching counts: on small integers every answer is that of `exact`.
RC_GTEST_PROP(FastTriangle, IsExactOnSmallIntegers, ()) {
  const Case c = *small_triangles();
  RC_ASSERT(touches(c) == exact::contact(c.ball, c.polygon));
}

// Identity (1).
RC_GTEST_PROP(FastTriangle, PowersOfTwoChangeNothing, ()) {
  const Case c = *rc::gen::oneOf(triangles(), small_triangles());
  const int exponent = *rc::gen::resize(100, rc::gen::inRange(-100, 101));
  RC_ASSERT(touches(scaled(c, exponent)) == touches(c));
}

// Identity (2).
RC_GTEST_PROP(FastTriangle, GrowingTheRadiusLosesNoContact, ()) {
  Case c = *rc::gen::oneOf(triangles(), small_triangles());
  RC_PRE(touches(c));
  c.ball.radius *= *rc::gen::element(1 + 0x1p-52, 1 + 0x1p-30, 1.5, 4.0);
  RC_ASSERT(touches(c));
}

// Identity (3).
RC_GTEST_PROP(FastTriangle, MirroringChangesNothing, ()) {
  const Case c = *rc::gen::oneOf(triangles(), small_triangles());
  const Case image = moved(c, mirror_along(*rc::gen::inRange(0, 3)));
  RC_ASSERT(touches(image) == touches(c));
}

TEST(FastTriangle, TouchesFaceEdgesAndVertices) {
  const Triangle triangle{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  const Ball touching[] = {{{1, 2, 3}, 3},   {{1, 2, -3}, 3},  {{3, -3, 4}, 5},  {{-3, 3, -4}, 5},
                           {{-2, -3, 6}, 7}, {{10, -3, 6}, 7}, {{-3, 10, 6}, 7}, {{6, 6, 2}, 3.5}};
  for (const Ball& ball : touching) EXPECT_TRUE(fast::contact(ball, triangle)) << ball.center.transpose();
  for (std::size_t i = 0; i < 7; ++i) {
    const Ball smaller{touching[i].center, std::nextafter(touching[i].radius, 0.0)};
    EXPECT_FALSE(fast::contact(smaller, triangle)) << smaller.center.transpose();
  }
}

// A point may lie on the triangle, or off it.
TEST(FastTriangle, RadiusZeroIsAPoint) {
  const Triangle triangle{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  for (const Eigen::Vector3d& on : {Eigen::Vector3d(1, 1, 0), {4, 4, 0}, {0, 8, 0}, {3, 0, 0}})
    EXPECT_TRUE(fast::contact({on, 0}, triangle)) << on.transpose();
  for (const Eigen::Vector3d& off : {Eigen::Vector3d(1, 1, 0x1p-40), {5, 4, 0}, {0, 9, 0}, {-0x1p-40, 3, 0}})
    EXPECT_FALSE(fast::contact({off, 0}, triangle)) << off.transpose();
}

}  // namespace
}  // namespace touchstone::contact_tests
