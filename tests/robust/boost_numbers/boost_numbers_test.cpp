// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers and the kernel of TOUCHSTONE_EXACT=OFF against GMP.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "robust/detail/exact_kernel.h"

namespace touchstone {
namespace {

using kernel_of_boost::Mpzf;
using kernel_of_boost::Vector_3;

Integer from(const mpz_class& x) { return Integer(x.get_str()); }

/// An integer of as many words as were drawn, 0 included.
mpz_class integer(const std::vector<std::uint32_t>& words) {
  mpz_class result = 0;
  for (const std::uint32_t word : words) result = (result << 32) + word;
  return result;
}

/// Any finite double.
double number(std::uint64_t bits) {
  const auto x = std::bit_cast<double>(bits);
  return std::isfinite(x) ? x : std::bit_cast<double>(bits & ~(std::uint64_t{1} << 62));
}

mpq_class exactly(const Mpzf& x) {
  const Rational r = rational(x);
  return mpq_class(mpz_class(numerator_of(r).str()), mpz_class(denominator_of(r).str()));
}

void expect_root(const mpz_class& a) {
  mpz_class expected, rest;
  mpz_sqrtrem(expected.get_mpz_t(), rest.get_mpz_t(), a.get_mpz_t());
  Integer root, remainder;
  take_root(from(a), root, remainder);
  RC_ASSERT(root == from(expected));
  RC_ASSERT(remainder == from(rest));
}

// A step of the root may end one above it; next to squares this shows.
RC_GTEST_PROP(BoostNumbers, TakeTheIntegerPartOfARoot, (const std::vector<std::uint32_t>& words)) {
  const mpz_class n = integer(words);
  expect_root(n);
  expect_root(n * n);
  expect_root(n * n + 1);
  expect_root(n * n + 2 * n);
  if (n > 0) expect_root(n * n - 1);
}

TEST(BoostNumbers, TakeSmallRoots) {
  for (int a = 0; a < 5000; ++a) {
    Integer root, remainder;
    take_root(a, root, remainder);
    ASSERT_TRUE(root * root <= a && (root + 1) * (root + 1) > a && remainder == a - root * root) << a;
  }
}

RC_GTEST_PROP(BoostNumbers, CountBitsAndShiftThem, (const std::vector<std::uint32_t>& words)) {
  const mpz_class n = integer(words);
  RC_ASSERT(bits(from(n)) == static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)));
  RC_ASSERT(shifted_up(from(n), 77) == from(n << 77));
  RC_ASSERT(shifted_down(from(n), 77) == from(n >> 77));
}

RC_GTEST_PROP(BoostNumbers, HoldEveryDoubleAndItsSumsAndProducts, (std::uint64_t i, std::uint64_t j, std::uint64_t k)) {
  const double a = number(i), b = number(j), c = number(k);
  const mpq_class x(a), y(b), z(c);
  RC_ASSERT(exactly(Mpzf(a)) == x);
  RC_ASSERT(exactly(Mpzf(a) + Mpzf(b)) == x + y);
  RC_ASSERT(exactly(Mpzf(a) * Mpzf(b) - Mpzf(c)) == x * y - z);
  RC_ASSERT(exactly(-Mpzf(a)) == -x);
  RC_ASSERT(kernel_of_boost::compare(Mpzf(a), Mpzf(b)) == (x < y ? -1 : x == y ? 0 : 1));
  RC_ASSERT(kernel_of_boost::sign(Mpzf(a)) == sgn(x));
  RC_ASSERT((Mpzf(a) < Mpzf(b)) == (x < y));
}

TEST(BoostNumbers, HoldZeroes) {
  EXPECT_TRUE(is_zero(Mpzf(0.0)) && is_zero(Mpzf(-0.0)) && is_zero(Mpzf()));
  EXPECT_EQ(Mpzf(0.0) + Mpzf(3.0), Mpzf(3));
  EXPECT_EQ(Mpzf(3.0) + Mpzf(0.0), Mpzf(3));
  EXPECT_TRUE(is_zero(Mpzf(0.1) - Mpzf(0.1)));
}

TEST(BoostNumbers, OrientPoints) {
  using kernel_of_boost::Point_2;
  const Point_2 a(0.1, 0.1), b(1.3, 0.2);
  EXPECT_EQ(orientation(a, b, Point_2(0.7, 1.1)), 1);
  EXPECT_EQ(orientation(b, a, Point_2(0.7, 1.1)), -1);
  EXPECT_EQ(orientation(Point_2(0.0, 0.0), Point_2(3.0, 1.0), Point_2(1.5, 0.5)), 0);
  EXPECT_EQ(orientation(Point_2(0.0, 0.0), Point_2(3.0, 1.0), Point_2(1.5, std::nextafter(0.5, 1))), 1);
  const Vector_3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0), origin(0.0, 0.0, 0.0);
  EXPECT_TRUE(coplanar(origin, x, y, x + y) && !coplanar(origin, x, y, z));
  EXPECT_TRUE(cross_product(x, y) - z == kernel_of_boost::NULL_VECTOR);
}

}  // namespace
}  // namespace touchstone
