// SPDX-License-Identifier: GPL-3.0-or-later
// What bounds.h says of triangles in lanes, in rationals over the operations that are compiled.
//
// Lengths are in the group's units, with S = 1: every error is a sum of lengths times coefficients that are not
// negative, all coordinates and limits are at most S or 2 S, and the bounds grow with S.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/filtered/detail/sets/triangle_groups.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/triangle/triangle_lanes.h"
#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/ratio.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::lanes {
namespace {

const mpq_class kUnit = bounds::kFloatUnit, kSteps = TriangleGroup::kSteps;
const ErrorModel kFloats{kUnit, bounds::kFloatTiny, true};
const ErrorBound kZero{&kFloats, 0, 0, 0};

ErrorBound known(const mpq_class& magnitude, const mpq_class& error) {
  return known_within(kFloats, magnitude, error * kUnit);
}

/// What a ball's subnormal number that was flushed to zero may have been worth, times the largest scale.
const mpq_class kFlushed = mpq_class(0x1p-122);

/// A coordinate in steps, as doubles compute it, by its ratio to the exact one.
Ratio<52> coordinate_in_steps() {
  const lane::Seen<Ratio<52>> seen({}, {}, {});
  return lane::in_steps<Ratio<52>>(seen.in_units, {});
}

/// The square of a centre's distance from the group's origin.
Ratio<52> squared_distance() {
  const Ratio<52> coordinate = lane::Seen<Ratio<52>>({}, {}, {}).in_units;
  return lane::squared_distance(coordinate, coordinate, coordinate);
}

TEST(Lanes, GroupsAreMissedForCertain) {
  const Ratio<52> radius = Ratio<52>{}.rounded();  // scaled
  EXPECT_LE(squared_distance().most, lane::square_of_reach(radius).least);
}

// A ball of up to twice the group's radius is larger by at most what is computed and an error for which vertices have
// room. That of a larger ball is relative: it falls with the radius.
TEST(Lanes, GroupsAreWithinBallsForCertain) {
  static const ErrorModel doubles{bounds::kUnit, kSmallestDouble, true};
  const auto excess = [](const mpq_class& least, const mpq_class& most) {
    return lane::excess(ErrorBound{&doubles, least, most, 0}, ErrorBound{&doubles, 1, 1, 0});
  };
  EXPECT_LE(excess(0, 2).error, mpq_class(TriangleGroup::kSpare) / 2);
  const mpq_class most = 1 + excess(2, 2).error;
  EXPECT_LE((lane::square_of_excess(Ratio<52>{1, most}).most), squared_distance().least);
}

// The rounding to a float, and what was flushed before.
TEST(Lanes, CentresAreKnown) {
  const mpq_class error = coordinate_in_steps().most * (1 + kUnit) - 1 + kFlushed + mpq_class(bounds::kFloatTiny);
  EXPECT_LE(error, bounds::kLaneCentre * kUnit);
  EXPECT_GT(error, bounds::kLaneCentre * kUnit * 15 / 16) << "it is loose";
}

// A stored vertex is exact, and at most 1 from the origin.
TEST(Lanes, VerticesAreKnownAsSeenFromTheCentre) {
  const ErrorBound centre = known(1, bounds::kLaneCentre), vertex{&kFloats, 1, 0, 0};
  const ErrorBound seen = vertex - centre;
  EXPECT_LE(seen.error, 2 * bounds::kLaneVertex * kUnit);
}

// Each coordinate is rounded to the nearest step.
TEST(Lanes, StoredVerticesAreNearTheGivenOnes) {
  const mpq_class apart = root_above(3) * (1 / (2 * kSteps) + coordinate_in_steps().most - 1);
  EXPECT_LE(apart, bounds::kLaneStored);
  EXPECT_GT(apart, mpq_class(bounds::kLaneStored) * 99 / 100) << "it is loose";
}

// The proofs of the two constants leave 1/32. A vertex seen from the centre exceeds 2 S by its own error, and so does
// the bound computed with it.
TEST(Lanes, MagnitudesMayExceedTheirBounds) {
  const mpq_class excess = 1 + 2 * mpq_class(bounds::kLaneVertex) * kUnit;
  for (const double constant : {bounds::kLanePoint, bounds::kLaneProduct})
    EXPECT_LE((mpq_class(constant) - mpq_class(1, 32)) * excess, constant);
}

/// The relative error of the computed length of a point.
const mpq_class kLength = lane::length(Vector3<Ratio<23>>{}, Ratio<23>{}).most - 1;

/// The limits for a radius of S, as doubles compute them.
lane::Limits<ErrorBound> limits() {
  static const ErrorModel doubles{bounds::kUnit, kSmallestDouble, true};
  const auto exactly = [](const mpq_class& number) { return ErrorBound{&doubles, number, number, 0}; };
  return {exactly(1), exactly(1), exactly(kSteps)};
}
/// The radius, which is at most S, and the error.
const mpq_class kLargestLimit = limits().outer.high / kSteps;

/// By how much limits of lengths may be wrong: those of doubles, rounded to a float.
mpq_class error_of_limits() {
  const ErrorBound outer = limits().outer;
  return (outer.error + kUnit * outer.magnitude()) / kSteps + kFlushed;
}

TEST(Lanes, LimitsAllowForTheErrorOfDistances) {
  const mpq_class error = mpq_class(bounds::kLaneStored) + bounds::kLaneDistance * kUnit;
  const lane::Limits<ErrorBound> of = limits();
  EXPECT_LE(abs(of.outer.low / kSteps - (1 + error)), of.outer.error / kSteps);
  EXPECT_LE(abs(of.inner.high / kSteps - (1 - error)), of.inner.error / kSteps);
  EXPECT_LE(of.inner.error, of.outer.error);
}

// Weights whose sum exceeds 1 by a rounding are those of a point beyond the triangle, by that share of an edge, which
// is at most 2.
TEST(Lanes, TouchedTrianglesAreNear) {
  const mpq_class beyond = 2 * kUnit;
  const mpq_class of_point = root_above(3) * 2 * mpq_class(bounds::kLanePoint) * kUnit;
  const mpq_class needed = beyond + of_point + kLength * (1 + kLength) + error_of_limits();
  EXPECT_LE(needed, bounds::kLaneDistance * kUnit);
}

// The support is the sum of two products. It is at most 4 times the direction's length: no coordinate of a vertex seen
// from the centre is more than 2 S, and 12 is less than 4^2. It is compared with a product of the limit and that
// length. The direction may be any: that of a point, or one from a centre's way. Of a way, the lesser support of both
// ends is that of the whole way, and S is the larger one.
TEST(Lanes, MissedTrianglesAreFar) {
  const mpq_class of_products = 2 * 2 * mpq_class(bounds::kLaneProduct) * kUnit, of_sum = 4 * (1 + of_products) * kUnit;
  const mpq_class of_comparison = (1 + kLength) * (1 + kUnit) - 1;
  const mpq_class bound = mpq_class(bounds::kLaneDistance) * kUnit;
  const mpq_class needed = of_products + of_sum + of_comparison * kLargestLimit + error_of_limits();
  EXPECT_LE(needed, bound);
  EXPECT_GT(needed, bound * 15 / 16) << "it is loose";
}

// What is added to the square is much less than the square of a step; so is what products lose to underflow, divided by
// a direction's length. Where a triangle is missed it is at least this long, since the computed length and limit are
// not less. Directions from a way are less than 3 times as long as centres are far: `farthest` covers them.
TEST(Lanes, UnderflowDoesNotMatter) {
  const mpq_class least_limit = bounds::kLaneStored * kSteps / 2, least_length = root_above(bounds::kLaneTiny) / 2;
  const mpq_class farthest = 8 * mpq_class(TriangleGroup::kReach) * kSteps;
  const mpq_class least_point = least_limit * least_length / farthest;
  // What sums and products lose that do not round. The support is the sum of two such products.
  static const ErrorModel underflow{0, bounds::kFloatTiny, true};
  const ErrorBound any = known_within(underflow, farthest, 0);
  const mpq_class of_product =
      lane::product(Vector3<ErrorBound>{any, any, any}, Vector3<ErrorBound>{any, any, any}).error;
  const mpq_class of_sum = underflow.underflow;
  EXPECT_LE((2 * of_product + of_sum) / least_point / kSteps, kUnit / 256);
  EXPECT_LE(of_product + of_sum, mpq_class(bounds::kLaneTiny) * kUnit);
}

// No product of steps overflows: centres within reach, in steps, and what is added to their distances.
TEST(Lanes, DoNotOverflow) {
  const mpq_class farthest = 8 * mpq_class(TriangleGroup::kReach) * kSteps;
  EXPECT_LE(3 * power(farthest, 2), mpq_class(0x1p126));
}

}  // namespace
}  // namespace touchstone::proofs::lanes
