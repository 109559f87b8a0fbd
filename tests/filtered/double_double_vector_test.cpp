// SPDX-License-Identifier: GPL-3.0-or-later
// Dot and cross products of double-doubles against rationals: within what the recorded operations may be off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/workloads/random.h"
#include "robust/filtered/bounds.h"
#include "tests/filtered/exact_number.h"

namespace touchstone::filtered_tests {
namespace {

using filtered::DoubleDouble;
using filtered::Vector3;
using workloads::Random;

constexpr std::uint64_t kVectors = 300 * TOUCHSTONE_SAMPLES;

/// Of magnitude at most 1: with a tail as large as may be, near 1 or far below, or without a tail.
DoubleDouble component(Random& random) {
  double high = 2 * random.unit() - 1;
  if (random.coin()) high = std::copysign(1 - std::ldexp(random.unit(), -40), high);
  if (random.integer(0, 3) == 0) high = std::ldexp(high, static_cast<int>(random.integer(-60, 0)));
  if (random.integer(0, 3) == 0) return high;
  return filtered::two_sum(high, 0x1p-54 * high * (random.coin() ? 1 : 2 * random.unit() - 1));
}

Vector3<DoubleDouble> vector(Random& random) {
  const DoubleDouble x = component(random), y = component(random);
  return {x, y, component(random)};
}

/// A second vector for which a.b almost cancels, in half of the cases.
Vector3<DoubleDouble> partner(Random& random, const Vector3<DoubleDouble>& a) {
  Vector3<DoubleDouble> b = vector(random);
  if (random.coin() || std::abs(a.z.high) < 0.5) return b;
  b.z = -(a.x * b.x + a.y * b.y) / a.z;
  return std::abs(b.z.high) <= 1 ? b : vector(random);
}

mpq_class product(const DoubleDouble& a, const DoubleDouble& b) { return exactly(a) * exactly(b); }

TEST(FilteredDoubleDoubleVector, DotIsWithinEightUnits) {
  mpq_class largest = 0;
  for (std::uint64_t i = 0; i < kVectors; ++i) {
    Random random(2011, i);
    const Vector3<DoubleDouble> a = vector(random), b = partner(random, a);
    const DoubleDouble computed = dot(a, b);
    const mpq_class error = abs(exactly(computed) - (product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z)));
    EXPECT_LE(error, 8 * exactly(filtered::bounds::kDoubleDoubleUnit)) << "index " << i;
    EXPECT_EQ(computed.high + computed.low, computed.high) << "index " << i;
    largest = std::max(largest, error);
  }
  EXPECT_GT(largest, exactly(filtered::bounds::kDoubleDoubleUnit) / 2) << "the bound is far from what occurs";
}

TEST(FilteredDoubleDoubleVector, CrossIsWithinFourUnits) {
  for (std::uint64_t i = 0; i < kVectors; ++i) {
    Random random(2012, i);
    const Vector3<DoubleDouble> a = vector(random), b = random.coin() ? vector(random) : a;
    const Vector3<DoubleDouble> computed = cross(a, b);
    const mpq_class x = product(a.y, b.z) - product(a.z, b.y), y = product(a.z, b.x) - product(a.x, b.z);
    const mpq_class z = product(a.x, b.y) - product(a.y, b.x);
    const mpq_class bound = 4 * exactly(filtered::bounds::kDoubleDoubleUnit);
    EXPECT_LE(abs(exactly(computed.x) - x), bound) << "index " << i;
    EXPECT_LE(abs(exactly(computed.y) - y), bound) << "index " << i;
    EXPECT_LE(abs(exactly(computed.z) - z), bound) << "index " << i;
  }
}

}  // namespace
}  // namespace touchstone::filtered_tests
