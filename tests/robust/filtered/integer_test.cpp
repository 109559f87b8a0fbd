// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of fixed width against GMP's: random words, and all that is extreme.
#include <gtest/gtest.h>

#include <vector>

#include "experiments/cases/workloads/random.h"
#include "tests/robust/filtered/exact_number.h"

namespace touchstone::filtered_tests {
namespace {

using filtered::detail::Integer;
using workloads::Random;

template <int... Widths>
struct Bits {};
// On both sides of every word's end; and widths that no word ends at.
using AllWidths = Bits<1, 21, 31, 32, 43, 62, 63, 64, 65, 94, 126, 127, 128, 129, 191, 192, 193, 256, 300>;

/// Of magnitude below 2^bits: extremes, powers of two and their neighbours, words of ones or zeros, random ones.
std::vector<mpz_class> numbers(int bits, std::uint64_t seed) {
  const mpz_class limit = mpz_class(1) << static_cast<unsigned>(bits);
  std::vector<mpz_class> result{0, 1, limit - 1, limit / 2, limit / 2 - 1};
  Random random(seed, static_cast<std::uint64_t>(bits));
  for (int i = 0; i < 12; ++i) {
    mpz_class value = 0;
    for (int k = 0; k <= bits / 64; ++k) {
      const std::uint64_t words[] = {0, ~std::uint64_t{0}, std::uint64_t{1} << 63, 1, random.bits(), random.bits()};
      value = (value << 64) + mpz_class(std::to_string(words[random.integer(0, 5)]));
    }
    result.push_back(value % limit);
  }
  const std::size_t count = result.size();
  for (std::size_t i = 0; i < count; ++i) result.emplace_back(-result[i]);
  return result;
}

template <int A>
void expect_values() {
  for (const mpz_class& x : numbers(A, 1)) {
    const auto a = integer<A>(x);
    EXPECT_EQ(exactly(a), x) << A << " bits";
    EXPECT_EQ(a.sign(), sgn(x)) << x << " in " << A << " bits";
    EXPECT_EQ(a.negative(), x < 0) << x << " in " << A << " bits";
    EXPECT_EQ(exactly(filtered::detail::narrowed<A>(integer<A + 1>(x))), x) << A << " bits";
    EXPECT_EQ(exactly(filtered::detail::narrowed<A>(integer<A + 70>(x))), x) << A << " bits";
  }
}

/// What two numbers give, out of the template that each pair of widths is an instance of.
struct Results {
  mpz_class sum, difference, product;
  int difference_sign, product_sign;
};

void expect_results(const mpz_class& x, const mpz_class& y, const Results& results, int a, int b) {
  const auto what = [&] { return testing::Message() << x << " of " << a << " bits, " << y << " of " << b << " bits"; };
  EXPECT_EQ(results.sum, x + y) << what();
  EXPECT_EQ(results.difference, x - y) << what();
  EXPECT_EQ(results.product, x * y) << what();
  EXPECT_EQ(results.difference_sign, (x > y) - (x < y)) << what();
  EXPECT_EQ(results.product_sign, sgn(x) * sgn(y)) << what();
}

template <int A, int B>
void expect_operations() {
  const auto as = numbers(A, 2), bs = numbers(B, 3);
  for (const mpz_class& x : as)
    for (const mpz_class& y : bs) {
      const auto a = integer<A>(x);
      const auto b = integer<B>(y);
      const auto difference = a - b;
      const auto product = a * b;
      expect_results(x, y, {exactly(a + b), exactly(difference), exactly(product), difference.sign(), product.sign()},
                     A, B);
    }
}

template <int A, int... Bs>
void expect_operations_with(Bits<Bs...>) {
  (expect_operations<A, Bs>(), ...);
}

template <int... As>
void expect_all(Bits<As...> widths) {
  (expect_values<As>(), ...);
  (expect_operations_with<As>(widths), ...);
}

TEST(FilteredInteger, IsTheIntegersAtEveryWidth) { expect_all(AllWidths{}); }

// The type of a result is wide enough for all that its operands can give.
TEST(FilteredInteger, ResultsHaveTheirWidths) {
  const auto a = integer<62>((mpz_class(1) << 62) - 1);
  const auto sum = a + a;
  const auto product = a * a * (a * a);
  static_assert(std::is_same_v<decltype(sum), const Integer<63>>);
  static_assert(std::is_same_v<decltype(product), const Integer<248>>);
  const mpz_class x = (mpz_class(1) << 62) - 1;
  EXPECT_EQ(exactly(sum), 2 * x);
  EXPECT_EQ(exactly(product), x * x * x * x);
}

}  // namespace
}  // namespace touchstone::filtered_tests
