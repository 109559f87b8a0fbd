// SPDX-License-Identifier: GPL-3.0-or-later
// Dot and cross products of double-doubles against rationals: within their bounds, which robust/proofs proves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/random.h"
#include "robust/filtered/detail/numbers/lane_vector.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "tests/robust/filtered/exact_number.h"

namespace touchstone::filtered_tests {
namespace {

using filtered::detail::DoubleDouble;
using filtered::detail::Vector3;
using workloads::Random;

constexpr std::uint64_t kVectors = 300 * TOUCHSTONE_SAMPLES;

/// Of magnitude at most 1: with a tail as large as may be, near 1 or far below, or without a tail.
DoubleDouble component(Random& random) {
  double high = 2 * random.unit() - 1;
  if (random.coin()) high = std::copysign(1 - std::ldexp(random.unit(), -40), high);
  if (random.integer(0, 3) == 0) high = std::ldexp(high, static_cast<int>(random.integer(-60, 0)));
  if (random.integer(0, 3) == 0) return high;
  return filtered::detail::two_sum(high, 0x1p-54 * high * (random.coin() ? 1 : 2 * random.unit() - 1));
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

mpq_class product_sum(const Vector3<DoubleDouble>& a, const Vector3<DoubleDouble>& b) {
  return product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z);
}

const mpq_class kDotError =
    exactly(filtered::detail::bounds::kDot) * exactly(filtered::detail::bounds::kDoubleDoubleUnit);
const mpq_class kCrossError =
    exactly(filtered::detail::bounds::kCross) * exactly(filtered::detail::bounds::kDoubleDoubleUnit);

TEST(FilteredDoubleDoubleVector, DotIsWithinItsBound) {
  mpq_class largest = 0;
  for (std::uint64_t i = 0; i < kVectors; ++i) {
    Random random(2011, i);
    const Vector3<DoubleDouble> a = vector(random), b = partner(random, a);
    const DoubleDouble computed = dot(a, b);
    const mpq_class error = abs(exactly(computed) - product_sum(a, b));
    EXPECT_LE(error, kDotError) << "index " << i;
    EXPECT_EQ(computed.high + computed.low, computed.high) << "index " << i;
    largest = std::max(largest, error);
  }
  EXPECT_GT(largest, exactly(filtered::detail::bounds::kDoubleDoubleUnit) / 2) << "the bound is far from what occurs";
}

TEST(FilteredDoubleDoubleVector, CrossIsWithinItsBound) {
  for (std::uint64_t i = 0; i < kVectors; ++i) {
    Random random(2012, i);
    const Vector3<DoubleDouble> a = vector(random), b = random.coin() ? vector(random) : a;
    const Vector3<DoubleDouble> computed = cross(a, b);
    const mpq_class x = product(a.y, b.z) - product(a.z, b.y), y = product(a.z, b.x) - product(a.x, b.z);
    const mpq_class z = product(a.x, b.y) - product(a.y, b.x);
    EXPECT_LE(abs(exactly(computed.x) - x), kCrossError) << "index " << i;
    EXPECT_LE(abs(exactly(computed.y) - y), kCrossError) << "index " << i;
    EXPECT_LE(abs(exactly(computed.z) - z), kCrossError) << "index " << i;
  }
}

filtered::detail::LaneVector in_lanes(const Vector3<DoubleDouble>& v) {
  return {
      {filtered::detail::pack(v.x.high, v.y.high, v.z.high, 0), filtered::detail::pack(v.x.low, v.y.low, v.z.low, 0)}};
}

void expect_same(const DoubleDouble& a, const DoubleDouble& b) {
  EXPECT_EQ(a.high, b.high);
  EXPECT_EQ(a.low, b.low);
}

// The operations are the same except for the last one, which normalises without an error; so are all bits.
TEST(FilteredDoubleDoubleVector, IsTheSameInLanesOnceNormalised) {
  for (std::uint64_t i = 0; i < kVectors; ++i) {
    Random random(2014, i);
    const Vector3<DoubleDouble> a = vector(random), b = partner(random, a), apart = cross(a, b);
    const DoubleDouble sum = dot(in_lanes(a), in_lanes(b)).sum;
    expect_same(filtered::detail::two_sum(sum.high, sum.low), dot(a, b));
    double high[filtered::detail::kLanes], low[filtered::detail::kLanes];
    const filtered::detail::LaneVector together = cross(in_lanes(a), in_lanes(b));
    store(high, together.lanes.high), store(low, together.lanes.low);
    for (int axis = 0; axis < 3; ++axis) expect_same(filtered::detail::two_sum(high[axis], low[axis]), apart[axis]);
  }
}

/// Requires that no bit is lost.
Vector3<DoubleDouble> scaled(const Vector3<DoubleDouble>& v, int exponent) {
  const auto word = [exponent](double x) { return std::ldexp(x, exponent); };
  return {{word(v.x.high), word(v.x.low)}, {word(v.y.high), word(v.y.low)}, {word(v.z.high), word(v.z.low)}};
}

TEST(FilteredDoubleDoubleVector, UnderflowAddsLessThanOneOperationOfTheModelMay) {
  const mpq_class allowed(1, mpz_class(1) << 1069);
  mpq_class largest = 0;
  for (std::uint64_t i = 0; i < kVectors; ++i) {
    Random random(2013, i);
    const int exponent = static_cast<int>(random.integer(-1090, -900));
    const mpq_class maxima(1, mpz_class(1) << static_cast<unsigned>(-exponent));
    const Vector3<DoubleDouble> a = scaled(vector(random), exponent / 2);
    const Vector3<DoubleDouble> b = scaled(vector(random), exponent - exponent / 2);
    const mpq_class of_dot = abs(exactly(dot(a, b)) - product_sum(a, b)) - kDotError * maxima;
    const mpq_class of_cross =
        abs(exactly(cross(a, b).z) - (product(a.x, b.y) - product(a.y, b.x))) - kCrossError * maxima;
    EXPECT_LE(of_dot, allowed) << "index " << i;
    EXPECT_LE(of_cross, allowed) << "index " << i;
    largest = std::max({largest, of_dot, of_cross});
  }
  EXPECT_GT(largest, allowed / 64) << "no product underflows";
}

}  // namespace
}  // namespace touchstone::filtered_tests
