// SPDX-License-Identifier: GPL-3.0-or-later
// The bound of distances from triangles, in rationals over the operations that are compiled.
#include "robust/scene/detail/distance_bound.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/proofs/error_bound.h"
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

// The sum of the weights is 1 except for four roundings; a point that is so much farther is the point of the triangle,
// times that. Then a square is rounded three times, its root once, and the bound three times; the square may lose less
// to underflow than the error of the point has to spare.
TEST(DistanceBound, CoversTheRoundingOfTheDistance) {
  EXPECT_LE(power(1 + kU, 4 + 2 + 1 + 3) / power(1 - kU, 1), mpq_class(bound::kWide));
  EXPECT_GT(power(1 + kU, 20), mpq_class(bound::kWide)) << "it is loose";
  const mpq_class spare = mpq_class(bound::kPoint) - error_of_point();
  EXPECT_LE(3 * kSmallestDouble, power(spare * mpq_class(bound::kSmallest), 2));
}

}  // namespace
}  // namespace touchstone::proofs::distance_bound
