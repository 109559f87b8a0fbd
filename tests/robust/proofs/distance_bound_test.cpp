// SPDX-License-Identifier: GPL-3.0-or-later
// The bound of distances from triangles, in rationals over the operations that are compiled.
#include "robust/scene/detail/distance_bound.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/ratio.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::distance_bound {
namespace {

namespace bound = scene::detail::distance_bound;

// Beside coordinates of up to 1, where m is at least kSmallest.
const ErrorModel kNearest{kU, kSmallestDouble / power(mpq_class(bound::kSmallest), 2), true};

/// The error of a point that is combined from three vertices, each known to u, with weights as they are.
mpq_class error_of_point() {
  const ErrorBound coordinate = known_within(kNearest, 1, kU), weight{&kNearest, 0, 1, 0};
  const Vector3<ErrorBound> vertex{coordinate, coordinate, coordinate};
  const mpq_class one = bound::combined(weight, vertex, weight, vertex, weight, vertex).x.error;
  return root_above(3 * one * one);
}

TEST(DistanceBound, CoversThePoint) {
  EXPECT_LE(error_of_point(), mpq_class(bound::kPoint));
  EXPECT_GT(error_of_point(), mpq_class(bound::kPoint) * 7 / 8) << "it is loose";
}

TEST(DistanceBound, AddsTheErrorOfThePoint) {
  const auto exactly = [](double number) { return ErrorBound{&kNearest, number, number, 0}; };
  for (const double computed : {0.0, 0x1p-50, 1.0})
    for (const double largest : {0x1p-50, 1.0, 1000.0})
      EXPECT_GE(bound::not_below(exactly(computed), exactly(largest)).low, computed + error_of_point() * largest);
}

/// The computed bound of a distance, by its ratio to the distance of the point that is combined.
const Ratio<53> kBound = bound::not_below(square_root(bound::squared_distance(Vector3<Ratio<53>>{})), Ratio<53>{});

/// The sum of the weights, which without rounding is 1: shares of their sum, or a number and what it leaves of 1.
const Ratio<53> kSum = maximum(Ratio<53>{} / bound::sum_of(Ratio<53>{}, {}, {}), Ratio<53>{}.rounded());

// A point with weights of another sum is a point of the triangle, times that sum.
TEST(DistanceBound, CoversTheRoundingOfTheDistance) {
  EXPECT_GE(kBound.least * kSum.least, 1);
  EXPECT_LT(kBound.least * kSum.least, 1 + 9 * kU) << "it is loose";
}

// Squares lose less to underflow than the error of the point has to spare.
TEST(DistanceBound, CoversTheUnderflowOfSquares) {
  const mpq_class spare = mpq_class(bound::kPoint) - error_of_point();
  EXPECT_LE(3 * kSmallestDouble, power(spare * mpq_class(bound::kSmallest), 2));
}

}  // namespace
}  // namespace touchstone::proofs::distance_bound
