// SPDX-License-Identifier: GPL-3.0-or-later
// Steps: places lie on the way, more steps never miss more, and the exact sweep misses nothing that they find.
#include "experiments/studies/motions/steps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robust/exact/motion.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::motions {
namespace {

using run_tests::kNeverStop;
using run_tests::kSilent;

const Polygon& square() {
  static const Polygon polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  return polygon;
}

TEST(Places, AreTheEndsAndEqualStepsBetween) {
  const Motion motion{{{0, 0, 8}, 1}, {0, 4, 0}};
  EXPECT_EQ(place_of(motion, 0, 0).center, motion.ball.center);
  EXPECT_EQ(place_of(motion, 0, 1).center, motion.to);
  EXPECT_EQ(place_of(motion, 2, 1).center, Eigen::Vector3d(0, 1, 6));
  EXPECT_EQ(place_of(motion, 2, 1).radius, 1);
}

// Falls through the square from a height of 5 to -6: some steps bring the centre within the radius of it.
TEST(Steps, FindAContactFromTheirNumberOn) {
  const filtered::PreparedPolygon polygon(square());
  const Motion falls{{{2, 2, 5}, 0.4}, {2, 2, -6}};
  const auto level = first_level_that_touches(falls, polygon);
  ASSERT_TRUE(level);
  for (std::size_t k = 0; k <= kMostLevel; ++k) {
    bool touches = false;
    for (std::size_t i = 0; i <= std::size_t{1} << k; ++i)
      touches |= std::abs(5 - 11.0 * static_cast<double>(i) / static_cast<double>(1 << k)) <= 0.4;
    EXPECT_EQ(touches_at_steps(falls, k, polygon), touches) << k;
    EXPECT_EQ(*level <= k, touches) << k;
  }
  EXPECT_GT(*level, 1U);
}

TEST(Steps, OfAPointMissAFaceThatTheyDoNotHit) {
  const filtered::PreparedPolygon polygon(square());
  EXPECT_FALSE(first_level_that_touches({{{2, 2, 1}, 0}, {2, 2, -2}}, polygon));
  EXPECT_EQ(first_level_that_touches({{{2, 2, 1}, 0}, {2, 2, -1}}, polygon), 1U);
  EXPECT_EQ(first_level_that_touches({{{2, 2, 0}, 0}, {2, 2, -1}}, polygon), 0U);
}

TEST(Passes, AreAsLongAsTheirPolygons) {
  for (std::uint64_t n = 0; n < 30; ++n) {
    const auto pass = draw_pass(8, 5, n);
    ASSERT_TRUE(pass) << n;
    EXPECT_NEAR((pass->to - pass->from).norm() / pass->extent, 1, 1e-9) << n;
    EXPECT_EQ(pass->of(0.25).ball.radius, pass->extent / 4) << n;
    EXPECT_EQ(draw_pass(8, 5, n)->to, pass->to) << n;
  }
}

Misses counted(std::uint64_t passes) {
  Misses misses;
  count_misses({.vertices = 8, .seed = 4, .passes = passes}, {kNeverStop, kSilent}, misses);
  return misses;
}

TEST(Misses, AreFewerWithMoreStepsAndLargerBalls) {
  const Misses misses = counted(400);
  EXPECT_EQ(misses.passes(), 400U);
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < kRadii.size(); ++i) {
    const Contacts& contacts = misses.of[i];
    EXPECT_TRUE(std::ranges::is_sorted(contacts.missed, std::greater())) << i;
    EXPECT_LE(contacts.missed.front(), contacts.all) << i;
    EXPECT_GE(contacts.all, before) << i;
    before = contacts.all;
  }
  EXPECT_GT(misses.of.front().all, 20U);
  EXPECT_EQ(misses.of.front().missed.back(), misses.of.front().all);  // a point on the face, in doubles: never
  EXPECT_EQ(misses.of.back().missed.back(), 0U);
}

// Each count again, one by one, by exact.
TEST(Misses, AreWhatTheExactSweepFindsAndStepsDoNot) {
  Misses again;
  for (std::uint64_t n = 0; n < 40; ++n) {
    const auto pass = draw_pass(8, 4, n);
    ++again.samples;
    const filtered::PreparedPolygon polygon(pass->polygon);
    for (std::size_t i = 0; i < kRadii.size(); ++i) {
      const Motion motion = pass->of(kRadii[i]);
      const bool touches = exact::contact(motion, pass->polygon);
      again.of[i].all += touches ? 1 : 0;
      for (std::size_t level = 0; level <= kMostLevel; ++level)
        again.of[i].missed[level] += touches && !touches_at_steps(motion, level, polygon) ? 1 : 0;
      again.of[i].beside += !touches && touches_at_steps(motion, kMostLevel, polygon) ? 1 : 0;
    }
  }
  EXPECT_EQ(counted(40), again);
}

TEST(Cost, IsThatOfBothSweepsAndOfAllSteps) {
  const auto cost = measure_cost({.vertices = 6, .seed = 1, .repetitions = 1}, 14, kNeverStop, kSilent);
  ASSERT_EQ(cost.candidates.size(), kMostLevel + 3);
  EXPECT_EQ(cost.candidates[0].name, kContact);
  EXPECT_EQ(cost.candidates[1].name, kFirstContact);
  EXPECT_EQ(cost.candidates[2].name, "1 step");
  EXPECT_EQ(cost.candidates.back().name, "1024 steps");
  for (const auto& measured : cost.candidates) EXPECT_EQ(measured.nanoseconds.size(), 1U);
}

}  // namespace
}  // namespace touchstone::motions
