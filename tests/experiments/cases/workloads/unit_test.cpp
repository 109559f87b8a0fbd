// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/unit.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>

#include "robust/filtered/detail/numbers/integer.h"

namespace touchstone::workloads {
namespace {

// Against integers of 128 bits.
TEST(Unit, RoundsOnce) {
  const auto mm = find_unit("mm"), m = find_unit("m"), inch = find_unit("inch"), foot = find_unit("foot");
  EXPECT_EQ(converted(0.1, mm, mm), 0.1);
  EXPECT_EQ(converted(3, mm, m), 0.003);
  EXPECT_EQ(converted(0.003, m, mm), 3);
  EXPECT_EQ(converted(1, inch, mm), 25.4);
  EXPECT_EQ(converted(25.4, mm, inch), 1 - 0x1p-53);  // as a double 25.4 is less
  EXPECT_EQ(converted(-2, foot, inch), -24);

  std::uint64_t bits = 12345;
  for (int i = 0; i < 10'000; ++i) {
    bits = bits * 6364136223846793005U + 1442695040888963407U;
    const std::uint64_t whole = (bits >> 12) | (std::uint64_t{1} << 52);
    const auto product = static_cast<filtered::detail::Uint128>(whole) * 127 << 20;
    // 60 bits of quotient and a sticky one: the conversion rounds once.
    const auto quotient =
        static_cast<std::uint64_t>(product / 5 >> 22) | (product % (std::uint64_t{5} << 22) != 0 ? 1 : 0);
    EXPECT_EQ(converted(static_cast<double>(whole), inch, mm), static_cast<double>(quotient) * 4) << whole;
  }
}

// Against GMP's rationals: the quotient lies no farther from the result than from either neighbour.
TEST(Unit, RoundsOnceWhereDoublesEnd) {
  const auto mm = find_unit("mm"), m = find_unit("m"), inch = find_unit("inch"), foot = find_unit("foot"),
             um = find_unit("um");
  EXPECT_EQ(converted(5.043809979959526e-305, mm, m), 5.043809979959527e-308);
  EXPECT_EQ(converted(1e308, mm, foot), 1e308 / 304.8);
  EXPECT_TRUE(std::isinf(converted(1e308, m, mm)));
  std::uint64_t bits = 54321;
  for (int i = 0; i < 20'000; ++i) {
    bits = bits * 6364136223846793005U + 1442695040888963407U;
    const double mantissa = 1 + static_cast<double>(bits >> 12) * 0x1p-52;
    const double length = std::ldexp(i % 2 == 0 ? mantissa : -mantissa, i % 4 < 2 ? -1074 + i % 97 : 1023 - i % 29);
    for (const auto& [from, to] : {std::pair{mm, m}, {inch, foot}, {mm, foot}, {um, inch}, {foot, um}}) {
      const double result = converted(length, from, to);
      if (std::isinf(result)) continue;
      const mpq_class exact = mpq_class(length) * from.micrometres / to.micrometres;
      const auto off = [&](double x) -> mpq_class { return abs(mpq_class(x) - exact); };
      const double lower = std::nextafter(result, -HUGE_VAL), upper = std::nextafter(result, HUGE_VAL);
      if (std::isfinite(lower)) {
        EXPECT_LE(off(result), off(lower)) << length;
      }
      if (std::isfinite(upper)) {
        EXPECT_LE(off(result), off(upper)) << length;
      }
    }
  }
}

}  // namespace
}  // namespace touchstone::workloads
