// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "experiments/cases/workloads/workload.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"

namespace touchstone::workloads {
namespace {

constexpr std::uint64_t kWaySeed = 2026, kWays = 60;

Sample drawn(Workload workload, Way way, std::uint64_t index) {
  workload.way = way;
  return sample(workload, kWaySeed, index);
}

Motion motion_of(const Sample& sample) { return {sample.ball, sample.to.value()}; }

Eigen::Vector3d middle(const Sample& sample) { return (sample.ball.center + *sample.to) / 2; }

// The polygon is that of the static sample, and the ball is at its place at the start, at the end or halfway.
TEST(Ways, LeadThroughThePlaceOfTheBall) {
  const Workload workload{.family = Family::L, .ball = BallPlace::LatticeTangent, .vertices = 6, .holes = 1};
  for (std::uint64_t i = 0; i < kWays; ++i) {
    const Sample still = sample(workload, kWaySeed, i);
    EXPECT_FALSE(still.to);
    for (const Way way : all_ways()) {
      if (way == Way::Static) continue;
      const Sample moving = drawn(workload, way, i), again = drawn(workload, way, i);
      EXPECT_EQ(moving.to, again.to);
      EXPECT_EQ(moving.ball.center, again.ball.center);
      EXPECT_TRUE(moving.polygon == still.polygon);
      EXPECT_FALSE(find_fault(motion_of(moving)));
      EXPECT_NE(moving.id.find("-" + std::string(to_string(way))), std::string::npos) << moving.id;
      EXPECT_EQ(moving.tags.back(), to_string(way));
      if (way != Way::Through) {
        EXPECT_EQ(moving.ball.radius, still.ball.radius);
      }
      if (way == Way::Rest || way == Way::Start || way == Way::Anywhere) {
        EXPECT_EQ(moving.ball.center, still.ball.center) << moving.id;
      }
      if (way == Way::Rest || way == Way::End) {
        EXPECT_EQ(*moving.to, still.ball.center) << moving.id;
      }
      if (way == Way::Across || way == Way::Along) {
        EXPECT_EQ(middle(moving), still.ball.center) << moving.id;
      }
    }
  }
}

// A tangent ball that passes across touches halfway, exactly: it grazes, or slides. Nothing touches before, except
// where the outline is not convex.
TEST(Ways, TangentBallsGrazeOrSlideHalfway) {
  const Workload workload{.family = Family::Convex, .ball = BallPlace::LatticeTangent, .vertices = 6};
  int momentary = 0, lasting = 0, before = 0;
  for (std::uint64_t i = 0; i < kWays; ++i) {
    const Sample moving = drawn(workload, Way::Across, i);
    const FirstContact first = exact::first_contact(motion_of(moving), moving.polygon);
    ASSERT_TRUE(first.contact()) << moving.id;
    if (first.time < 0.5)
      ++before;  // slid there
    else
      ++(first.momentary ? momentary : lasting);
  }
  EXPECT_GT(momentary, 4);
  EXPECT_GT(lasting + before, 5);
}

// The radius decides whether a ball passes: a double less than what just fits, and it passes everything nearby.
TEST(Ways, BallsPassThroughWhereTheyFit) {
  int passed = 0, stopped = 0;
  for (const int doubles : {-1, 0, 1})
    for (std::uint64_t i = 0; i < 3 * kWays; ++i) {
      const Workload workload{
          .family = Family::U, .ball = BallPlace::LatticeTangent, .vertices = 8, .holes = 1, .doubles = doubles};
      const Sample moving = drawn(workload, Way::Through, i);
      const double fit = exact::answer({middle(moving), 0}, moving.polygon).distance;
      const bool touches = exact::contact(motion_of(moving), moving.polygon);
      if (fit == 0) continue;
      if (doubles != 0) {
        EXPECT_EQ(touches, doubles > 0) << moving.id;
      }
      ++(touches ? stopped : passed);
    }
  EXPECT_GT(passed, 15);
  EXPECT_GT(stopped, 15);
}

}  // namespace
}  // namespace touchstone::workloads
