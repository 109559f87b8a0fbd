// SPDX-License-Identifier: GPL-3.0-or-later
// Evidence beside the proofs: the same expressions in toy arithmetic of 4 to 8 bits, against exact integers. What the
// error calculus gives at the toy's unit must hold, and must not be far from what is met.
#include "tests/robust/proofs/toy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>

#include "tests/robust/proofs/toy_bounds.h"
#include "tests/robust/proofs/toy_sample.h"

namespace touchstone::proofs {
namespace {

using workloads::Random;

constexpr std::uint64_t kSamples = std::uint64_t{300} * TOUCHSTONE_SAMPLES, kMostSteps = 3000;
constexpr std::uint64_t kSeed = 2026;

/// The largest share of its bound that an error has taken, for each constant.
class Shares {
 public:
  void add(std::string_view constant, double share) {
    double& largest = largest_[std::string(constant)];
    largest = std::max(largest, share);
  }
  /// What was met violates a constant that is smaller by such a factor.
  void expect_at_least(const std::map<std::string, double>& floors) const {
    EXPECT_EQ(largest_.size(), floors.size());
    for (const auto& [constant, floor] : floors) {
      ASSERT_TRUE(largest_.contains(constant)) << constant;
      EXPECT_GE(largest_.at(constant), floor) << constant << " looks loose";
      std::printf("%-12s %.3f of its bound\n", constant.c_str(), largest_.at(constant));
    }
  }

 private:
  std::map<std::string, double> largest_;
};

/// The share of its bound that the error of one sample takes.
template <class Expression>
double share_of(const ToySample& sample, const Claim& claim, const Expression& expression, double bound) {
  const Exact error = std::abs(expression(sample.computed).value - expression(sample.exact));
  if (error == 0) return 0;
  return static_cast<double>(error) / (bound * sample.product(claim.maxima));
}

TEST(Toy, RoundsAsAFloatingPointNumberDoes) {
  EXPECT_EQ(rounded(17, 4, Rounding::Nearest), 16);
  EXPECT_EQ(rounded(19, 4, Rounding::Nearest), 20);
  EXPECT_EQ(rounded(31, 4, Rounding::Nearest), 32);
  EXPECT_EQ(rounded(17, 4, Rounding::Up), 18);
  EXPECT_EQ(rounded(-17, 4, Rounding::Up), -16);
  EXPECT_EQ(rounded(17, 4, Rounding::Down), 16);
  EXPECT_EQ(rounded(-17, 4, Rounding::Down), -18);
  EXPECT_EQ(rounded(-19, 4, Rounding::TowardZero), -18);
  EXPECT_EQ(rounded(-15, 4, Rounding::Down), -15);
}

TEST(Toy, RandomErrorsStayWithinTheBounds) {
  for_each_arithmetic([](int bits, Rounding rounding) {
    const std::vector<double> bounds = bounds_at(std::ldexp(1.0, 1 - bits));
    for (std::uint64_t index = 0; index < kSamples; ++index) {
      Random random(kSeed, index);
      const auto sample = sample_of(exact_inputs(draw_operands(random)));
      std::size_t i = 0;
      for_each_claim([&](const Claim& claim, const auto& expression) {
        ASSERT_LE(share_of(sample, claim, expression, bounds[i++]), 1)
            << claim.constant << " " << claim.instance << ": " << bits << " bits, rounding "
            << static_cast<int>(rounding) << ", sample " << index;
      });
    }
  });
}

// Operands are drawn again one by one; what makes the error smaller is taken back.
TEST(Toy, ErrorsThatAreDrivenUpStayWithinTheBoundsAndShowThemNotLoose) {
  Shares shares;
  for_each_arithmetic([&](int bits, Rounding rounding) {
    const std::vector<double> bounds = bounds_at(std::ldexp(1.0, 1 - bits));
    std::uint64_t i = 0;
    for_each_claim([&](const Claim& claim, const auto& expression) {
      Random random(kSeed, i, 1);
      const double bound = bounds[i++];
      Operands operands = draw_operands(random);
      double largest = 0;
      for (std::uint64_t step = 0; step < kMostSteps; ++step) {
        Operands other = operands;
        for (Exact count = random.integer(1, 3); count > 0; --count)
          other[static_cast<std::size_t>(random.integer(0, other.size() - 1))] = draw_operand(random);
        const auto sample = sample_of(exact_inputs(other));
        const double share = share_of(sample, claim, expression, bound);
        ASSERT_LE(share, 1) << claim.constant << " " << claim.instance << ": " << bits << " bits, rounding "
                            << static_cast<int>(rounding) << ", step " << step;
        if (share < largest) continue;
        largest = share;
        operands = other;
      }
      shares.add(claim.constant, largest);
    });
  });
  shares.expect_at_least({{"kVertex", 0.45},     {"kAlong", 0.5},       {"kBeyond", 0.3},     {"kLine", 0.2},
                          {"kNormal", 0.5},      {"kFront", 0.25},      {"kPlane", 0.11},     {"kSide", 0.2},
                          {"kAbove", 0.11},      {"kCoordinate", 0.45}, {"kEdgeFrame", 0.2},  {"kLanePoint", 0.3},
                          {"kLaneProduct", 0.2}, {"kLineAhead", 0.2},   {"kApart", 0.2},      {"kLines", 0.05},
                          {"kOnEdge", 0.1},      {"kOnWay", 0.1},       {"kRoundedDot", 0.4}, {"kRoundedCross", 0.4}});
}

}  // namespace
}  // namespace touchstone::proofs
