// SPDX-License-Identifier: GPL-3.0-or-later
// What bounds.h says of lifts, closest points and distances in double-doubles, in rationals.
//
// Maxima are 1: every error is at most the one that it is with them, times the maxima. Products of two errors are far
// below what a factor of 1 + 2^-20 adds, except where a direction is hardly known: for needles.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/signs/closest_point.h"
#include "robust/filtered/detail/signs/signs.h"
#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::closest {
namespace {

const mpq_class kDouble = bounds::kDoubleDoubleUnit, kSecondOrder = mpq_class(0x1p-20) + 1;
const mpq_class kQuotient = bounds::kQuotient * kDouble;  // of roots, too
const ErrorModel kDoubleDoubles{kDouble, 0, true, SumsOfProducts{bounds::kDot, bounds::kCross}};

ErrorBound within(const mpq_class& magnitude, const mpq_class& error) {
  return known_within(kDoubleDoubles, magnitude, error);
}
Vector3<ErrorBound> vector_within(const mpq_class& magnitude, const mpq_class& error) {
  return {within(magnitude, error), within(magnitude, error), within(magnitude, error)};
}
const mpq_class kRootOfThree = root_above(3);

/// The error of n / N_k for the largest component N_k of a normal that is known to a unit.
mpq_class error_of_share(const ErrorBound& n) {
  return (n.error + n.magnitude() * (kDouble + kQuotient)) * kSecondOrder;
}

// The plane's height over N_k is at most 3/4, vertices are within 1/4 of vertex 0.
TEST(LiftBounds, HoldForVertices) {
  const ErrorBound height = within(mpq_class(3, 4), mpq_class(3, 4) * kDouble);
  const ErrorBound lift = height - dot(vector_within(1, kDouble), vector_within(mpq_class(1, 4), 0));
  EXPECT_LE(error_of_share(lift), bounds::kLift);
  EXPECT_GT(error_of_share(lift), mpq_class(bounds::kLift) / 2) << "it is loose";
  // Seen from a ball: with this maximum, or one as large as the difference is. A sum is off by 3 u^2 = 3/8 units.
  const mpq_class sum = mpq_class(3, 8) * kDouble;
  EXPECT_LE(bounds::kLift + sum * bounds::kLiftedMaximum, kDouble * bounds::kLiftedMaximum);
}

TEST(LiftBounds, HoldForEdges) {
  const mpq_class of_slope = error_of_share(within(1, kDouble));
  EXPECT_LE(of_slope, bounds::kSlope * kDouble);
  EXPECT_GT(of_slope, bounds::kSlope * kDouble * mpq_class(15, 16)) << "it is loose";
  const ErrorBound slope = within(1, bounds::kSlope * kDouble), edge = within(1, 0);
  const ErrorBound lifted = slope * edge + slope * edge;
  EXPECT_LE(lifted.error, bounds::kLiftedEdge);
  EXPECT_GT(lifted.error, mpq_class(bounds::kLiftedEdge) / 2) << "it is loose";
  EXPECT_LE(bounds::kLiftedEdge, kDouble * bounds::kLiftedMaximum);
}

/// A direction D and the way `to_center` from it to the centre, as closest_point.h has them, with errors in each
/// component.
struct Situation {
  mpq_class direction, direction_error, from_error;
};
const Situation kExactEdge{1, 0, 0};
/// At most 4 times the largest component before it was lifted.
const Situation kEdgeOffItsPlane{mpq_class(4) / mpq_class(bounds::kLiftedMaximum), kDouble, kDouble};
const Situation kNormalOfTriangle{1, bounds::kNormal* kDouble, 0};
const Situation kNormalOfPolygon{1, kDouble, kDouble};
const Situation kEvery[] = {kExactEdge, kEdgeOffItsPlane, kNormalOfTriangle, kNormalOfPolygon};

/// What D.D and |D| may be off relatively, if |D| = length.
mpq_class error_of_square(const Situation& s, const mpq_class& length) {
  // A component is at most the length, so the rounding of the sum of squares is relative to it.
  const ErrorBound rounding = dot(vector_within(1, 0), vector_within(1, 0));
  return 2 * kRootOfThree * s.direction_error / length + rounding.error;
}

mpq_class error_of_product(const Situation& s) {
  return dot(vector_within(s.direction, s.direction_error), vector_within(1, s.from_error)).error;
}

/// The step is D.to_center (1 / D.D) D_k; its errors in units of |D_k| / D.D, without those of D_k. |D.to_center| is at
/// most |D| times the root of 3, and |D| at most that times the largest component: the shorter D is, the less its
/// errors' share counts.
mpq_class error_of_step(const Situation& s) {
  const mpq_class longest = kRootOfThree * s.direction, product = kRootOfThree * longest;
  return (error_of_product(s) + product * (error_of_square(s, longest) + kQuotient + 2 * kDouble)) * kSecondOrder;
}

// Each component of a polygon's normal is known to a unit of itself, so each square to two.
TEST(ClosestBounds, HoldForTheNormalOfAPolygon) {
  const mpq_class found = (2 * kDouble + error_of_square(kExactEdge, 1) + kQuotient) * kSecondOrder;
  EXPECT_LE(found, bounds::kPerSquare * kDouble);
  EXPECT_GT(found, bounds::kPerSquare * kDouble * mpq_class(15, 16)) << "it is loose";
}

TEST(ClosestBounds, HoldForSteps) {
  for (const Situation& s : kEvery) EXPECT_LE(error_of_step(s), bounds::kClosest / 2);
  // What D_k itself is off, times D.to_center / D.D: below 1 for edges, below the root of 3 over |D| for normals. A
  // polygon's normal is known to a unit of each component (normal_test.cpp): that is a unit of the step.
  EXPECT_LE(kEdgeOffItsPlane.direction_error, bounds::kClosest / 2);
  EXPECT_LE(kRootOfThree * kNormalOfTriangle.direction_error * kSecondOrder, bounds::kClosest / 2);
  EXPECT_LE(3 * kNormalOfPolygon.direction_error, bounds::kClosest / 8);
}

// Known to a unit of its maximum alone, the component of a normal would not do: the step's bound shrinks with it.
TEST(ClosestBounds, AskForNormalsKnownComponentByComponent) {
  const mpq_class component = 0x1p-20;
  EXPECT_GT(kRootOfThree * kNormalOfPolygon.direction_error, bounds::kClosest * component);
}

// Results are known to two units of themselves besides, of which their own rounding takes 3 u^2 + 13 u^3. The rest is
// more than what underflow does to a component, to the product that it goes into, and to the share that it takes.
TEST(ClosestBounds, AllowForComponentsThatUnderflow) {
  const mpq_class own_rounding = 3 * power(kU, 2) + 13 * power(kU, 3);
  const mpq_class left_over = (2 * kDouble - own_rounding) * mpq_class(kSmallestResult);
  const mpq_class farthest = bounds::kLargest, shortest = kShortestDirection, operation = power(mpq_class(1, 2), 1021);
  const mpq_class share = kRootOfThree * farthest / shortest;  // D.to_center / D.D, for |D| at least `shortest`
  const mpq_class largest_normal = 2 * power(farthest, 2);
  const mpq_class of_component = share * mpq_class(bounds::kNormalUnderflow);
  // D.to_center, D.D and their quotient; then the product, and the bound's own terms.
  const mpq_class of_share = 4 * operation * (1 / power(shortest, 2) + share / power(shortest, 2) + 1);
  EXPECT_LE((of_component + of_share * largest_normal + 8 * operation) * kSecondOrder, left_over);
}

// The roots of (D.to_center)^2 (1 / D.D) and |D x to_center|^2 (1 / D.D), in units of 1 / |D| and of themselves.
TEST(ClosestBounds, HoldForDistances) {
  for (const Situation& s : kEvery) {
    const Vector3<ErrorBound> moment =
        cross(vector_within(s.direction, s.direction_error), vector_within(1, s.from_error));
    const mpq_class numerator = std::max<mpq_class>(error_of_product(s), kRootOfThree * moment.x.error);
    // The value is at most the root of 3; what D's errors do to its length counts against 1 / |D|.
    const mpq_class of_length = kRootOfThree * kRootOfThree * s.direction_error;
    EXPECT_LE((numerator + of_length) * kSecondOrder, bounds::kClosest / 2);
  }
  const Situation exact{1, 0, 0};
  // A sum of squares, times one over a sum of squares; the root halves what that is off, and adds its own.
  const mpq_class of_itself = (2 * error_of_square(exact, 1) + kQuotient + kDouble) / 2 + kQuotient;
  EXPECT_LE(of_itself * kSecondOrder, bounds::kClosest);
  // From a vertex: the root of a sum of squares; what is lifted is known to a unit of the maximum.
  EXPECT_LE((error_of_square(exact, 1) + kQuotient) * kSecondOrder, bounds::kClosest);
  EXPECT_LE(kEdgeOffItsPlane.from_error * kSecondOrder, bounds::kClosest);
}

// N_k / |N| as N_k sqrt(1 / N.N), in units of m_N / |N| and of itself.
TEST(ClosestBounds, HoldForNormalsOfTheFace) {
  const mpq_class of_maximum = (1 + kRootOfThree) * kNormalOfTriangle.direction_error;
  EXPECT_LE(of_maximum * kSecondOrder, bounds::kClosest / 2);
  const mpq_class own = kQuotient + kDouble;  // of the root and the product
  EXPECT_LE(((error_of_square(kExactEdge, 1) + kQuotient) / 2 + own) * kSecondOrder, bounds::kClosest / 2);
  EXPECT_LE((kDouble + bounds::kPerSquare * kDouble / 2 + own) * kSecondOrder, bounds::kClosest / 2);
}

// (c - p) / d: the bound holds 2 / 3 of the error of d more than is needed, and that is kClosest d at least.
TEST(ClosestBounds, HoldForNormalsOffTheFace) {
  EXPECT_LE((kQuotient + kDouble) * kSecondOrder, bounds::kClosest * mpq_class(2, 3) / 2);
}

// Every error holds two units of its value, or kClosest of it, and a tail is at most u of that: what Enclosed asks for.
TEST(ClosestBounds, AreWideEnoughForTheRoundingTest) {
  EXPECT_GE(2 * kDouble, 2 * kU * kU);
  EXPECT_GE(mpq_class(bounds::kClosest), 2 * kU * kU);
}

// A normal that is shorter than 8 times its error may be wrong altogether. Then step and distance, exact and computed,
// are still no longer than `to_center`, at most the root of 3, and the bound is more than two of them. For longer ones
// what was computed stands for what is exact, and products of errors count: five factors of at most 1 + 1/8, above in
// the errors and below in the bound.
TEST(ClosestBounds, AreNotSureOfNeedles) {
  const mpq_class error = kRootOfThree * kNormalOfTriangle.direction_error;
  EXPECT_GE(bounds::kClosest / (9 * error), 2 * kRootOfThree);
  EXPECT_LT(bounds::kClosest / 4 / (9 * error), 2 * kRootOfThree) << "it is loose";
  EXPECT_LE(error_of_step(kNormalOfTriangle) * power(mpq_class(9, 8), 5), bounds::kClosest / 2);
}

}  // namespace
}  // namespace touchstone::proofs::closest
