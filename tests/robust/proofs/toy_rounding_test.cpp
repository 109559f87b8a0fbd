// SPDX-License-Identifier: GPL-3.0-or-later
// The rounding test of closest_point.h in arithmetic of 3 to 6 bits, for every double-double and every error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "robust/filtered/detail/signs/closest_point.h"
#include "tests/robust/proofs/toy.h"

namespace touchstone::proofs {
namespace {

using filtered::detail::surely_nearest;

/// All numbers of `bits` bits from 0 to `last`.
std::vector<std::int64_t> numbers_up_to(std::int64_t last, int bits) {
  std::vector<std::int64_t> numbers;
  for (std::int64_t number = 0; number <= last; ++number)
    if (rounded(number, bits, Rounding::Nearest) == number) numbers.push_back(number);
  return numbers;
}

/// The verdicts for errors of at least least_error u |low|, and the 0 of what is known exactly.
struct Verdicts {
  int sure = 0, wrong = 0, wrong_for_exact = 0;
};

/// Highs are all numbers of `bits` bits between two powers of two, both included; below the lower one numbers are
/// closer together. Rounding is monotone: if both ends of an interval round to `high`, so does all of it.
Verdicts verdicts_of(int bits, double least_error) {
  Toy::set_arithmetic(bits, Rounding::Nearest);
  const std::int64_t ulp = std::int64_t{1} << (bits + 4);
  const auto nearest = [](std::int64_t exact) { return Toy::of(exact).value; };
  const std::vector<std::int64_t> tails = numbers_up_to(ulp / 2, bits), errors = numbers_up_to(ulp, bits);
  Verdicts verdicts;
  for (std::int64_t high = (std::int64_t{1} << (bits - 1)) * ulp; high <= (std::int64_t{1} << bits) * ulp; high += ulp)
    for (const std::int64_t tail : tails)
      for (const std::int64_t low : {tail, -tail}) {
        if (nearest(high + low) != high) continue;
        for (const std::int64_t error : errors) {
          const double smallest = least_error * static_cast<double>(tail) / (1 << bits);
          if (error != 0 && static_cast<double>(error) < smallest) continue;
          if (!surely_nearest(Toy{high}, Toy{low}, Toy{error})) continue;
          ++verdicts.sure;
          const bool is_right = nearest(high + low - error) == high && nearest(high + low + error) == high;
          (error == 0 ? verdicts.wrong_for_exact : verdicts.wrong) += !is_right;
        }
      }
  return verdicts;
}

constexpr int kWidths[] = {3, 4, 5, 6};

TEST(ToyRounding, IsSureOfNoWrongDouble) {
  for (const int bits : kWidths) {
    const Verdicts verdicts = verdicts_of(bits, 2);
    EXPECT_GT(verdicts.sure, 0) << bits << " bits";
    EXPECT_EQ(verdicts.wrong, 0) << bits << " bits";
    EXPECT_EQ(verdicts.wrong_for_exact, 0) << bits << " bits";
  }
}

// Half of u |low| is the most for which twice the error may be lost in the tail.
TEST(ToyRounding, IsSureOfWrongDoublesWhereErrorsMayBeAFifthOfThat) {
  for (const int bits : kWidths) EXPECT_GT(verdicts_of(bits, 0.4).wrong, 0) << bits << " bits";
}

// The test would be of no use if it were seldom sure. Half a unit in the last place of `high` is 512.
TEST(ToyRounding, IsSureWhereTwiceTheErrorLeavesTheNearestDouble) {
  Toy::set_arithmetic(6, Rounding::Nearest);
  for (const std::int64_t low : numbers_up_to(400, 6))
    for (const std::int64_t error : numbers_up_to((500 - low) / 2, 6))
      EXPECT_TRUE(surely_nearest(Toy{40 << 10}, Toy{low}, Toy{error})) << low << " +- " << error;
}

}  // namespace
}  // namespace touchstone::proofs
