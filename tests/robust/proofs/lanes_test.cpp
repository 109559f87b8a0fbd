// SPDX-License-Identifier: GPL-3.0-or-later
// What bounds.h says of triangles in lanes, in rationals over the operations that are compiled.
//
// Lengths are in the group's units, with S = 1: every error is a sum of lengths times coefficients that are not
// negative, all lengths are at most S or 2 S, and the bounds grow with S.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/filtered/detail/bounds.h"
#include "robust/filtered/detail/triangle_groups.h"
#include "robust/filtered/detail/triangle_lanes.h"
#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::filtered::proofs {
namespace {

const mpq_class kUnit = bounds::kFloatUnit, kSteps = TriangleGroup::kSteps;
const ErrorModel kFloats{kUnit, bounds::kFloatTiny, true};
const ErrorBound kZero{&kFloats, 0, 0, 0};

ErrorBound known(const mpq_class& magnitude, const mpq_class& error) {
  return known_within(kFloats, magnitude, error * kUnit);
}

/// What a ball's subnormal number that was flushed to zero may have been worth, times the largest scale.
const mpq_class kFlushed = mpq_class(0x1p-122);

// A difference and a product in doubles, the rounding to a float, and what was flushed before.
TEST(Lanes, CentresAreKnown) {
  const mpq_class in_doubles = power(1 + mpq_class(bounds::kUnit), 2);
  const mpq_class error = in_doubles * (1 + kUnit) - 1 + kFlushed + mpq_class(bounds::kFloatTiny);
  EXPECT_LE(error, bounds::kLaneCentre * kUnit);
}

// The factor is rounded once to a double and once to a float, its product with a coordinate once.
TEST(Lanes, StepsCostTwoRoundings) {
  const mpq_class error = (1 + mpq_class(bounds::kUnit)) * power(1 + kUnit, 2) - 1 + mpq_class(bounds::kFloatTiny);
  EXPECT_LE(error, bounds::kLaneStep * kUnit);
}

/// The relative error of a root whose square was rounded `roundings` times.
mpq_class relative_error_of_root(std::size_t roundings) { return root_above(power(1 + kUnit, roundings)) - 1; }

/// By how much the computed distance from the foot to an edge may be wrong.
mpq_class error_to_edge(const mpq_class& edge_error, const mpq_class& longest) {
  const ErrorBound depth = known(2, edge_error), along = known(2, edge_error), half = known(1, bounds::kLanePrepared);
  const ErrorBound overshoot = maximum(magnitude(along) - half, kZero);
  // A product, and a fused or unfused product and sum.
  return root_above(power(depth.error, 2) + power(overshoot.error, 2)) + relative_error_of_root(3) * longest;
}

/// By how much the computed distance may be wrong for a foot outside; for one inside it is the height.
mpq_class error_of_distance(const mpq_class& edge_error) {
  const mpq_class longest = 2 + mpq_class(1, 16);
  return root_above(power(mpq_class(bounds::kLaneCoordinate) * kUnit, 2) +
                    power(error_to_edge(edge_error, longest), 2)) +
         relative_error_of_root(2) * longest + root_above(8 * mpq_class(bounds::kFloatTiny));
}

// The bound is the radius and the error in doubles, in steps, squared, and rounded to a float.
TEST(Lanes, DistancesAreKnownToTheirBound) {
  const mpq_class edge_error = 2 * mpq_class(bounds::kLaneEdge), bound = mpq_class(bounds::kLaneDistance) * kUnit;
  const mpq_class largest_radius = 1 + bound;  // S is the radius and 1
  const mpq_class of_limits = (power(1 + mpq_class(bounds::kUnit), 6) * (1 + kUnit) - 1) * largest_radius + kFlushed;
  const mpq_class needed = error_of_distance(edge_error) + of_limits;
  EXPECT_LE(needed, bound);
  EXPECT_GT(needed, bound * 15 / 16) << "it is loose";
}

// The proofs of the two constants leave 1/32. A centre has been rounded, and so has the foot, whose coordinates exceed
// 2 S by their own error.
const mpq_class kProvedEdge = mpq_class(bounds::kLaneEdge) - mpq_class(1, 32);
TEST(Lanes, MagnitudesMayExceedTheirBounds) {
  const mpq_class centre = 1 + mpq_class(bounds::kLaneCentre) * kUnit;
  EXPECT_LE((mpq_class(bounds::kLaneCoordinate) - mpq_class(1, 32)) * centre, bounds::kLaneCoordinate);
  const mpq_class foot = 1 + (mpq_class(bounds::kLaneCoordinate) / 2 + mpq_class(bounds::kLaneStep)) * kUnit;
  EXPECT_LE(kProvedEdge * foot, bounds::kLaneEdge);
  // A foot outside has a negative exact depth for some edge, so its computed one is below the limit, a product of
  // doubles that is rounded to a float; likewise inside.
  EXPECT_LE(kProvedEdge * foot, bounds::kLaneEdge * (1 - kUnit) * power(1 - mpq_class(bounds::kUnit), 5));
}

// No square of steps overflows: centres within reach, in steps, and what is added to their distances.
TEST(Lanes, DoNotOverflow) {
  const mpq_class farthest = 8 * mpq_class(TriangleGroup::kReach) * kSteps;
  EXPECT_LE(3 * power(farthest, 2), mpq_class(0x1p126));
}

}  // namespace
}  // namespace touchstone::filtered::proofs
