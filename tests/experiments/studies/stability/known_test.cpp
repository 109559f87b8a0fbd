// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/known.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/experiments/studies/stability/small_study.h"

namespace touchstone::stability {
namespace {

// Published figures, found again: see the table for their limits.
TEST(StabilityKnown, WrongSignsBeginWhereTheyAreKnownTo) {
  const std::vector<std::string> names{"fast", "thesis", "filtered"};
  const std::uint64_t triangles = 4 * TOUCHSTONE_SAMPLES;
  const Onset onset = onset_of(names, triangles, 1);
  ASSERT_EQ(onset.methods(), (std::vector<std::string>{"ericson-absolute", "ericson", "fast", "thesis", "filtered"}));
  EXPECT_EQ(onset.triangles(), triangles);
  constexpr std::size_t kAbsolute = 0, kEricson = 1, kFast = 2, kThesis = 3, kFiltered = 4;
  for (const std::size_t method : {kAbsolute, kEricson, kFast, kThesis}) {
    const int first = onset.first(0, method, 0);  // about 2^-51 at zero
    EXPECT_GE(first, 46) << onset.methods()[method];
    EXPECT_LE(first, 52) << onset.methods()[method];
  }
  // 1e6 is 2^20: absolute coordinates lose twenty bits, differences none.
  for (const std::size_t method : {kAbsolute, kThesis}) {
    EXPECT_GE(onset.first(1, method, 0), 24) << onset.methods()[method];
    EXPECT_LE(onset.first(1, method, 0), 34) << onset.methods()[method];
    EXPECT_GT(2 * onset.failures(1, method, 36), triangles) << onset.methods()[method];
  }
  // The known 2^-36 is where two of five naive answers are wrong, not where the first is.
  EXPECT_NEAR(onset.first(0, kAbsolute, 0) - onset.first(1, kAbsolute, 0), 20, 3);
  EXPECT_NEAR(static_cast<double>(onset.wrong(1, kAbsolute, 36)) / static_cast<double>(2 * triangles), 0.38, 0.08);
  for (std::size_t method = 0; method < onset.methods().size(); ++method)
    for (int k = kCoarsest; k <= kFinest; ++k) {
      EXPECT_GE(onset.wrong(1, method, k), onset.failures(1, method, k));
      EXPECT_LE(onset.wrong(1, method, k), 2 * onset.failures(1, method, k));
    }
  EXPECT_EQ(onset.failures(1, kEricson, 36), 0U);
  EXPECT_EQ(onset.failures(1, kFast, 36), 0U);
  for (std::size_t distance = 0; distance < 2; ++distance) EXPECT_EQ(onset.first(distance, kFiltered, 0), 0);
}

// A product that is not rounded beside one that is: what is exactly zero is no more.
TEST(StabilityKnown, ContractionBreaksExactZeros) {
  const auto counts = count_contractions(200, 3);
  ASSERT_EQ(counts.size(), 8U);
  for (const ContractionCount& c : counts) {
    EXPECT_EQ(c.trials, 200U);
    EXPECT_LE(c.differ, c.plain_wrong + c.fused_wrong) << c.sign;
    if (c.family != "exactly zero") continue;
    EXPECT_GT(c.fused_wrong, c.plain_wrong) << c.sign;
    if (c.sign == "orientation" || c.sign == "side") {
      EXPECT_EQ(c.plain_wrong, 0U) << c.sign;
      EXPECT_GT(c.fused_wrong, 190U) << c.sign;
    }
  }
  // One double beside zero a fused product keeps what a rounded one loses.
  EXPECT_GT(counts[1].plain_wrong, counts[1].fused_wrong);
}

}  // namespace
}  // namespace touchstone::stability
