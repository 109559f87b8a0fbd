// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex that is found in a ball is in it: in rationals, over the operations that are compiled.
#include "robust/scene/detail/held_vertex.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "tests/robust/proofs/ratio.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::held_vertex {
namespace {

namespace held = scene::detail::held_vertex;
using Nearest = Ratio<53>;

/// A difference of two coordinates.
const Nearest kDifference = Nearest{}.rounded();

/// The most that the exact square of a distance may be, relative to that of the radius, if the computed one is less
/// than the limit: `wider` times what the ratios allow. Underflow takes less than the smallest double from each of
/// three products of the square, and from the limit.
mpq_class largest_square(const mpq_class& wider) {
  const Nearest square = dot(filtered::detail::Vector3<Nearest>{kDifference, kDifference, kDifference},
                             filtered::detail::Vector3<Nearest>{kDifference, kDifference, kDifference});
  const Nearest limit = held::squared_limit(Nearest{});
  const mpq_class underflow = 4 * kSmallestDouble / power(mpq_class(held::kSmallest), 2);
  return (wider * limit.most + underflow) / square.least;
}

TEST(HeldVertex, IsInTheBall) {
  EXPECT_LE(largest_square(1), 1);
  EXPECT_GT(largest_square(1 + (1 - mpq_class(held::kNarrow)) * 3 / 5), 1) << "it is loose";
}

// The sign of a difference is that of its exact value.
TEST(HeldVertex, IsFoundByItsSquare) {
  for (const double beyond : {-1.0, 1.0}) EXPECT_EQ(held::beyond<double>({2, 3, 6}, 49 - beyond), beyond);
  EXPECT_EQ(held::beyond<double>({2, 3, 6}, held::squared_limit(7.0)), 49 - 49 * held::kNarrow);
}

}  // namespace
}  // namespace touchstone::proofs::held_vertex
