// SPDX-License-Identifier: GPL-3.0-or-later
// The closest point of a triangle that is not prepared: the answers of exact, by every engine, seldom by big integers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>

#include "experiments/cases/workloads/random.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/filtered/detail/kernels.h"
#include "tests/robust/support/hard_cases.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;
using filtered::ClosestPoint;

ClosestPoint exact_closest(const Eigen::Vector3d& center, const Triangle& t) {
  const Answer answer = exact::answer({center, 0}, Polygon({t.a, t.b, t.c}));
  return {answer.nearest, answer.point, answer.distance, answer.contact_normal};
}

void expect_exact(const Eigen::Vector3d& center, const Triangle& triangle) {
  const ClosestPoint truth = exact_closest(center, triangle);
  filtered::StageCounts counts;
  filtered::NoCounts none;
  RC_ASSERT(filtered::closest(center, triangle) == truth);
  RC_ASSERT(filtered::closest(center, triangle, counts) == truth);
  RC_ASSERT(filtered::detail::closest(filtered::detail::baseline_kernels().plain, center, triangle, none) == truth);
}

RC_GTEST_PROP(FilteredClosest, IsExactInEveryOrderOfTheVertices, ()) {
  const Case c = *hard_triangles();
  const Triangle t = triangle_of(c.polygon);
  for (const Triangle& order : {Triangle{t.a, t.b, t.c}, {t.b, t.c, t.a}, {t.c, t.b, t.a}})
    expect_exact(c.ball.center, order);
}

/// Of any size from the beginning: small lattices hold few triangles.
int in_range(int lowest, int highest) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(lowest, highest + 1));
}

/// A point of a small lattice: what lies on lines, planes and vertices is not rare, nor are right angles.
Eigen::Vector3d lattice_point(int size) {
  const auto coordinate = [size] { return static_cast<double>(in_range(-size, size)); };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

RC_GTEST_PROP(FilteredClosest, IsExactOnSmallLatticesOfEveryScale, ()) {
  const int size = in_range(1, 5), exponent = in_range(-1074, 1019);
  const auto scaled = [exponent](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return v.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
  };
  const Triangle t{scaled(lattice_point(size)), scaled(lattice_point(size)), scaled(lattice_point(size))};
  const Eigen::Vector3d ab = t.b - t.a;
  RC_PRE(ab != Eigen::Vector3d::Zero() && t.a != t.c && t.b != t.c);
  RC_PRE(!exact::validate(Polygon({t.a, t.b, t.c})));
  expect_exact(scaled(lattice_point(size)), t);
}

/// Needles: the third vertex is some doubles off the line of the others, so that most bits of the normal are lost; and
/// differences of coordinates are not doubles, so that none of its bits comes by itself.
RC_GTEST_PROP(FilteredClosest, IsExactForNeedles, ()) {
  const auto real = [] {
    return std::ldexp(static_cast<double>(*rc::gen::arbitrary<std::int64_t>()), -in_range(62, 91));
  };
  const auto point = [&real] {
    const double x = real(), y = real(), z = real();
    return Eigen::Vector3d(x, y, z);
  };
  const Eigen::Vector3d a = point(), b = point(), center = point();
  Eigen::Vector3d c = a + (b - a) * (in_range(1, 999) / 1e3);
  const int axis = in_range(0, 2);
  c[axis] += c[axis] * std::ldexp(1.0, -in_range(20, 52));
  RC_PRE(a != b && b != c && a != c);
  RC_PRE(!exact::validate(Polygon({a, b, c})));
  for (const Triangle& t : {Triangle{a, b, c}, {b, c, a}, {c, a, b}}) {
    expect_exact(center, t);
    expect_exact((a + b + c) / 3 + center * 1e-9, t);
  }
}

// One double off a line, so that the normal has lost 50 bits: double-doubles must not be sure of a point of the face.
TEST(FilteredClosest, LeavesFacesOfNeedlesToBigIntegers) {
  const Eigen::Vector3d a(0.1, 0.2, 0.3), b(1.1, 0.7, 2.3);
  Eigen::Vector3d c = (a + b) / 2;
  c.y() = std::nextafter(c.y(), 1);
  const Triangle needle{a, b, c};
  const Ball center{(a + b + c) / 3, 0};
  const auto question = filtered::detail::view_of(center, needle);
  filtered::StageCounts counts;
  ClosestPoint closest;
  filtered::detail::baseline_kernels().counted.triangle_closest(question, closest, nullptr, counts);
  EXPECT_EQ(closest.feature.kind, Feature::Kind::Face);
  EXPECT_GT(counts.decided_by(filtered::Stage::BigInteger), 0U);
}

// A point on an edge at 45 degrees is the mean of two coordinates: in one of eight cases, halfway between two doubles.
TEST(FilteredClosest, LeavesPointsHalfwayBetweenDoublesToShortIntegers) {
  const Eigen::Vector3d start(-300, 12'345, 7);
  filtered::StageCounts counts;
  for (const double turn : {1.0, -1.0}) {
    const Triangle t{start, start + Eigen::Vector3d(4096, turn * 4096, 0), start - Eigen::Vector3d(0, 0, 4096)};
    for (std::uint64_t i = 0; i < 1000; ++i) {
      workloads::Random random(2026, i, 95);
      const double x = 1024 * (1 + random.unit()), y = 1024 * (1 + random.unit()), z = 1024 * random.unit();
      const Eigen::Vector3d center = start + Eigen::Vector3d(x, turn * y, z);
      const ClosestPoint truth = exact_closest(center, t);
      EXPECT_EQ(truth.feature, (Feature{Feature::Kind::Edge, 0}));
      EXPECT_EQ(filtered::closest(center, t, counts), truth) << "index " << i;
    }
  }
  EXPECT_GT(counts.decided_by(filtered::Stage::FixedInteger), 300U);
  EXPECT_EQ(counts.decided_by(filtered::Stage::BigInteger), 0U);
}

// With e = (q, 1) the first coordinate is w + (w' q - w) / (q^2 + 1): 3 / 2 of 1 / (q^2 + 1) below w + 1 / 2.
TEST(FilteredClosest, TellsPointsFromThoseHalfwayBetweenDoubles) {
  constexpr double q = 0x1p40, w = 0x1p52 + q + 1, other = (w - 1) / q + q / 2;
  const Triangle t{{0, 0, 0}, {q * 0x1p20, 0x1p20, 0}, {0, 0, -q}};
  const Eigen::Vector3d center(w, other, q);
  EXPECT_EQ(exact_closest(center, t).point.x(), w);
  EXPECT_EQ(filtered::closest(center, t), exact_closest(center, t));
}

// The double-doubles would be of no use if they were seldom sure.
RC_GTEST_PROP(FilteredClosest, NeedsNoBigIntegersForOrdinaryTriangles, ()) {
  const auto real = [] { return static_cast<double>(in_range(-1'000'000, 1'000'000)) / 7e5; };
  const int exponent = *rc::gen::element(0, -900, 900);
  const auto point = [&] {
    const double x = real(), y = real(), z = real();
    return Eigen::Vector3d(std::ldexp(x, exponent), std::ldexp(y, exponent), std::ldexp(z, exponent));
  };
  const Triangle t{point(), point(), point()};
  const Eigen::Vector3d unit = (t.b - t.a) * std::ldexp(1.0, -exponent),
                        other = (t.c - t.a) * std::ldexp(1.0, -exponent);
  RC_PRE(unit.squaredNorm() * other.squaredNorm() - std::pow(unit.dot(other), 2) > 1e-6);
  filtered::StageCounts counts;
  (void)filtered::closest(point(), t, counts);
  RC_ASSERT(counts.decided_by(filtered::Stage::BigInteger) == 0U);
  RC_ASSERT(counts.decided_by(filtered::Stage::DoubleDouble) > 0U);
}

}  // namespace
}  // namespace touchstone::filtered_tests
