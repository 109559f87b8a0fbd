// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex that is found in a ball is in it. In rationals, by the number of roundings.
#include "robust/scene/detail/held_vertex.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::held_vertex {
namespace {

namespace held = scene::detail::held_vertex;

/// The most that the exact square of a distance may be, relative to that of the radius, if the computed one is less
/// than the limit. Each difference is rounded once, so its square twice; a product and two sums are rounded three times
/// at most, the limit twice. Underflow takes less than the smallest double from each of three products.
mpq_class largest_square(const mpq_class& narrow) {
  const mpq_class underflow = 4 * kSmallestDouble / power(mpq_class(held::kSmallest), 2);
  return (narrow * power(1 + kU, 2) + underflow) / power(1 - kU, 5);
}

TEST(HeldVertex, IsInTheBall) {
  EXPECT_LE(largest_square(held::kNarrow), 1);
  EXPECT_GT(largest_square(1 - (1 - mpq_class(held::kNarrow)) * 2 / 5), 1) << "it is loose";
}

}  // namespace
}  // namespace touchstone::proofs::held_vertex
