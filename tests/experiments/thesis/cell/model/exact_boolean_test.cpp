// SPDX-License-Identifier: GPL-3.0-or-later
// Boolean operations on boxes and cylinders: exact volumes, insides as the primitives say, closed surfaces.
#include "experiments/thesis/cell/model/exact_boolean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "experiments/cases/workloads/random.h"
#include "tests/experiments/thesis/cell/model/solids.h"

namespace touchstone::cell {
namespace {

using Operation = Boolean::Operation;
using workloads::Random;

constexpr std::uint64_t kSeed = 51;
constexpr std::uint64_t kSolids = TOUCHSTONE_SAMPLES / 4 + 5;

std::size_t holes(const Boundary& boundary) {
  std::size_t sum = 0;
  for (const auto& face : boundary.faces) sum += face.size() - 1;
  return sum;
}

/// How much more often an edge is run through in one direction than in the other, summed over all edges.
std::size_t unmatched_edges(const Boundary& boundary) {
  using Point = std::array<double, 3>;
  std::map<std::pair<Point, Point>, int> excess;
  for (const auto& face : boundary.faces)
    for (const Loop& loop : face)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Eigen::Vector3d &from = loop[i], &to = loop[(i + 1) % loop.size()];
        const Point a{from.x(), from.y(), from.z()}, b{to.x(), to.y(), to.z()};
        if (a < b)
          ++excess[{a, b}];
        else
          --excess[{b, a}];
      }
  return static_cast<std::size_t>(
      std::count_if(excess.begin(), excess.end(), [](const auto& e) { return e.second != 0; }));
}

// All vertices are on the sphere, with the poles and, for a multiple of four, the equator's axes among them.
TEST(BoundaryOf, ASphereIsClosedAndWithinIt) {
  for (const int sides : {3, 8, 10}) {
    const Boundary boundary = boundary_of({Sphere{{1, 2, 3}, 2, sides}});
    EXPECT_EQ(unmatched_edges(boundary), 0U);
    EXPECT_EQ(holes(boundary), 0U);
    EXPECT_EQ(boundary.faces.size(), static_cast<std::size_t>(sides * ((sides + 3) / 4 * 2)));
    double highest = -9, lowest = 9;
    for (const auto& face : boundary.faces)
      for (const Eigen::Vector3d& p : face.front()) {
        EXPECT_NEAR((p - Eigen::Vector3d(1, 2, 3)).norm(), 2, 1e-12);
        highest = std::max(highest, p.z());
        lowest = std::min(lowest, p.z());
      }
    EXPECT_EQ(highest, 5);
    EXPECT_EQ(lowest, 1);
    const double volume = 4.0 / 3 * std::numbers::pi * 8;
    EXPECT_GT(boundary.volume.get_d(), 0);
    EXPECT_LT(boundary.volume.get_d(), volume);
    if (sides == 10) {
      EXPECT_GT(boundary.volume.get_d(), 0.85 * volume);
    }
  }
}

TEST(CirclePoints, LieOnTheCircleNextToTheRegularPolygon) {
  for (const int sides : {3, 4, 5, 7, 12, 24, 32, 999, 1000}) {
    const auto points = circle_points(sides);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(sides));
    for (int k = 0; k < sides; ++k) {
      const auto& [cosine, sine, denominator] = points[static_cast<std::size_t>(k)];
      EXPECT_EQ(mpz_class(cosine) * cosine + mpz_class(sine) * sine, mpz_class(denominator) * denominator) << sides;
      const double angle = 2 * std::numbers::pi * k / sides, d = static_cast<double>(denominator);
      EXPECT_LE(std::hypot(static_cast<double>(cosine) / d - std::cos(angle),
                           static_cast<double>(sine) / d - std::sin(angle)),
                0x1p-20)
          << sides << " " << k;
    }
  }
}

TEST(CirclePoints, AQuarterTurnMapsThemToThemselvesWhereFourDividesTheSides) {
  const auto points = circle_points(20);
  for (std::size_t k = 0; k < 20; ++k) {
    EXPECT_EQ(points[(k + 5) % 20].cosine, -points[k].sine);
    EXPECT_EQ(points[(k + 5) % 20].sine, points[k].cosine);
  }
}

TEST(ExactBoolean, ABoxHasItsSixFacesOrientedOutwards) {
  const Boundary boundary = boundary_of(box({1, 2, 3}, {4, 6, 8}));
  EXPECT_EQ(boundary.faces.size(), 6U);
  EXPECT_EQ(boundary.volume, 60);
  EXPECT_NEAR(winding_number(boundary.faces, {2, 3, 4}), 1, 1e-12);
  EXPECT_NEAR(winding_number(boundary.faces, {0, 3, 4}), 0, 1e-12);
}

TEST(ExactBoolean, ACylindersVolumeIsThatOfItsExactPolygonTimesItsLength) {
  for (const int sides : {3, 8, 24}) {
    mpq_class twice_area = 0;
    const auto points = circle_points(sides);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto &a = points[i], &b = points[(i + 1) % points.size()];
      twice_area += mpq_class(mpz_class(a.cosine) * b.sine - mpz_class(a.sine) * b.cosine,
                              mpz_class(a.denominator) * b.denominator);
    }
    twice_area.canonicalize();
    for (const int axis : {0, 1, 2}) {
      const Boundary boundary = boundary_of(cylinder(axis, {1, 2, 3}, -5, 1.5, sides));
      EXPECT_EQ(boundary.volume, twice_area / 2 * 9 / 4 * 5) << sides << " " << axis;
      EXPECT_EQ(boundary.faces.size(), static_cast<std::size_t>(sides) + 2);
    }
  }
}

// A pin that stands on a plate leaves its foot as a hole of the plate's face, a bore two, and a blind hole one.
TEST(ExactBoolean, WhereACylinderLeavesAFaceThereIsAHole) {
  const Solid plate = box({0, 0, 0}, {10, 10, 2});
  const Solid pin = cylinder(2, {5, 5, 2}, 3, 2, 16), bore = cylinder(2, {5, 5, -1}, 4, 2, 16),
              blind = cylinder(2, {5, 5, 1}, 4, 2, 16);
  const Boundary with_pin = boundary_of(combined(Operation::Union, {plate, pin}));
  EXPECT_EQ(with_pin.faces.size(), 6U + 16 + 1);
  EXPECT_EQ(holes(with_pin), 1U);
  const Boundary with_bore = boundary_of(combined(Operation::Difference, {plate, bore}));
  EXPECT_EQ(with_bore.faces.size(), 6U + 16);
  EXPECT_EQ(holes(with_bore), 2U);
  const Boundary with_blind = boundary_of(combined(Operation::Difference, {plate, blind}));
  EXPECT_EQ(with_blind.faces.size(), 6U + 16 + 1);
  EXPECT_EQ(holes(with_blind), 1U);
}

TEST(ExactBoolean, FacesThatBecomeCoplanarBecomeOne) {
  const Boundary bar = boundary_of(combined(Operation::Union, {box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {3, 1, 1})}));
  EXPECT_EQ(bar.faces.size(), 6U);
  for (const auto& face : bar.faces) EXPECT_EQ(face.front().size(), 4U);
}

TEST(ExactBoolean, WhatOnlyTouchesLeavesNothing) {
  const Solid left = box({0, 0, 0}, {1, 1, 1}), right = box({1, 0, 0}, {2, 1, 1});
  EXPECT_TRUE(boundary_of(combined(Operation::Intersection, {left, right})).faces.empty());
  EXPECT_EQ(boundary_of(combined(Operation::Difference, {left, right})).faces.size(), 6U);
}

TEST(ExactBoolean, APoseThatMirrorsIsRefused) {
  Solid mirrored = box({0, 0, 0}, {1, 1, 1});
  mirrored.pose.rotation(0, 0) = -1;
  EXPECT_THROW((void)boundary_of(mirrored), std::invalid_argument);
}

// |A or B| + |A and B| = |A| + |B|, |A without B| + |A and B| = |A|: exactly, so that no sliver is lost or kept twice.
TEST(ExactBoolean, VolumesAddUpExactly) {
  for (std::uint64_t i = 0; i < kSolids; ++i) {
    Random random(kSeed, i);
    const Solid a = random_primitive(random), b = random_primitive(random);
    const mpq_class both = boundary_of(combined(Operation::Intersection, {a, b})).volume;
    const mpq_class first = boundary_of(a).volume, second = boundary_of(b).volume;
    EXPECT_EQ(boundary_of(combined(Operation::Union, {a, b})).volume + both, first + second)
        << "seed " << kSeed << ", " << i;
    EXPECT_EQ(boundary_of(combined(Operation::Difference, {a, b})).volume + both, first)
        << "seed " << kSeed << ", " << i;
  }
}

TEST(ExactBoolean, AUnionDoesNotDependOnTheOrderOfItsParts) {
  for (std::uint64_t i = 0; i < kSolids; ++i) {
    Random random(kSeed, i, 1);
    const Solid a = random_primitive(random), b = random_primitive(random);
    EXPECT_EQ(boundary_of(combined(Operation::Union, {a, b})).faces,
              boundary_of(combined(Operation::Union, {b, a})).faces)
        << "seed " << kSeed << ", " << i;
  }
}

// A point is inside the result exactly where the operations on "inside of the primitives" say so, and the surface is
// closed: every edge is run through as often in one direction as in the other.
TEST(ExactBoolean, TheInsideIsThatOfThePrimitivesAndTheSurfaceIsClosed) {
  constexpr int kPoints = 100;
  int inside = 0, outside = 0;
  for (std::uint64_t i = 0; i < kSolids; ++i) {
    Random random(kSeed, i, 2);
    const Solid solid = random_solid(random);
    const Boundary boundary = boundary_of(solid);
    EXPECT_EQ(unmatched_edges(boundary), 0U) << "seed " << kSeed << ", " << i;
    for (int k = 0; k < kPoints; ++k) {
      const auto coordinate = [&] { return 24 * random.unit() - 12; };
      const double x = coordinate(), y = coordinate(), z = coordinate();
      const Side side = side_of(solid, {x, y, z});
      if (side == Side::TooNear) continue;
      ++(side == Side::Inside ? inside : outside);
      EXPECT_NEAR(winding_number(boundary.faces, {x, y, z}), side == Side::Inside ? 1 : 0, 1e-6)
          << "seed " << kSeed << ", " << i << ", point " << x << " " << y << " " << z;
    }
  }
  EXPECT_GT(inside, 0);
  EXPECT_GT(outside, inside);
}

}  // namespace
}  // namespace touchstone::cell
