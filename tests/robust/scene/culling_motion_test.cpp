// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of robust/scene/detail/culling_motion.h, against rationals: a box or triangle that a moving ball
// touches is never culled, nor is it held to be touched later than it is.
#include "robust/scene/detail/culling_motion.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "experiments/cases/workloads/ulp.h"
#include "tests/robust/support/draw_point.h"

namespace touchstone::scene_tests {
namespace {

using contact_tests::draw_point;
using workloads::Random;

/// A power of two, mostly near 1.
double draw_size(Random& random) {
  const int most = random.coin() ? 3 : random.coin() ? 40 : 300;
  return std::ldexp(1.0, static_cast<int>(random.integer(-most, most)));
}

/// The centre at a multiple of 1/8.
std::vector<mpq_class> center_at(const Motion& motion, int eighths) {
  std::vector<mpq_class> center;
  for (int k = 0; k < 3; ++k)
    center.push_back((mpq_class(motion.ball.center[k]) * (8 - eighths) + mpq_class(motion.to[k]) * eighths) / 8);
  return center;
}

mpq_class squared_distance(const Box& box, const std::vector<mpq_class>& center) {
  mpq_class sum = 0;
  for (int k = 0; k < 3; ++k) {
    const mpq_class below = mpq_class(box.low[k]) - center[static_cast<std::size_t>(k)],
                    above = center[static_cast<std::size_t>(k)] - mpq_class(box.high[k]);
    const mpq_class gap = std::max<mpq_class>({below, above, mpq_class(0)});
    sum += gap * gap;
  }
  return sum;
}

/// The least double that is not less than the root.
double root_rounded_up(const mpq_class& squared) {
  double root = std::sqrt(squared.get_d());
  while (mpq_class(root) * mpq_class(root) < squared)
    root = std::nextafter(root, std::numeric_limits<double>::infinity());
  return root;
}

struct MovingSample {
  Box box;
  Motion motion;  ///< touches the box at this time, by a double at most
  int eighths;
};

/// A motion past a box, along axes too, in ways short and long, and from far away.
MovingSample draw_moving_sample(std::uint64_t index) {
  Random random(2026, index, 94);
  const double size = std::ldexp(1.0, static_cast<int>(random.integer(-100, 100)));
  const Eigen::Vector3d corner = draw_point(random, size) + draw_point(random, size * draw_size(random));
  Eigen::Vector3d extent = draw_point(random, size).cwiseAbs();
  for (int k = 0; k < 3; ++k)
    if (random.integer(0, 3) == 0) extent[k] = 0;
  MovingSample sample{{corner, corner + extent}, {}, static_cast<int>(random.integer(0, 8))};
  Eigen::Vector3d way = draw_point(random, size * draw_size(random));
  for (int k = 0; k < 3; ++k)
    if (random.integer(0, 3) == 0) way[k] *= random.coin() ? 0 : 0x1p-31;
  Eigen::Vector3d at = random.coin() ? sample.box.low : sample.box.high;
  at += draw_point(random, size * draw_size(random));
  const double share = sample.eighths / 8.0;
  sample.motion = Motion({at - share * way, 0}, at + (1 - share) * way);
  sample.motion.ball.radius = root_rounded_up(squared_distance(sample.box, center_at(sample.motion, sample.eighths)));
  return sample;
}

/// Is the only box of a tree kept, and at which time?
bool keeps(const scene::detail::CullingMotion& culling, const BoxTree& tree, double time) {
  double earliest[BoxTree::kWidth];
  if ((culling.may_touch(tree.nodes().front(), earliest) & 1) == 0) return false;
  return earliest[0] <= time && culling.may_touch(earliest[0]);
}

TEST(CullingMotion, KeepsEveryBoxThatIsTouched) {
  std::uint64_t culled = 0, all = 200 * TOUCHSTONE_SAMPLES;
  for (std::uint64_t index = 0; index < all; ++index) {
    const MovingSample sample = draw_moving_sample(index);
    if (find_fault(sample.motion)) continue;
    const std::string what = "sample " + std::to_string(index);
    const std::vector<Box> boxes{sample.box};
    const BoxTree tree(boxes);
    const double time = sample.eighths / 8.0;
    scene::detail::CullingMotion culling(sample.motion, tree);
    EXPECT_TRUE(keeps(culling, tree, time)) << what;
    culling.end_at(time);
    EXPECT_TRUE(keeps(culling, tree, time)) << what << ", shortened";
    // A ball that is smaller is a miss more often than not.
    Motion smaller = sample.motion;
    smaller.ball.radius *= 0.5;
    culled += keeps(scene::detail::CullingMotion(smaller, tree), tree, 1) ? 0 : 1;
  }
  EXPECT_GT(culled, all / 4) << "it is blind";
}

// Near and far, so that floats and doubles cull.
TEST(CullingBall, KeepsEveryBoxThatIsTouched) {
  std::uint64_t culled = 0, all = 200 * TOUCHSTONE_SAMPLES;
  for (std::uint64_t index = 0; index < all; ++index) {
    const MovingSample sample = draw_moving_sample(index);
    Ball ball{sample.motion.to, 0};
    ball.radius = root_rounded_up(squared_distance(sample.box, center_at(sample.motion, 8)));
    if (!std::isfinite(ball.radius)) continue;
    const std::vector<Box> boxes{sample.box};
    const BoxTree tree(boxes);
    double key[BoxTree::kWidth];
    const scene::detail::CullingBall culling(ball, tree);
    EXPECT_EQ(culling.may_touch(tree.nodes().front()), 1U) << "sample " << index;
    EXPECT_EQ(culling.may_touch(tree.nodes().front(), key), 1U) << "sample " << index;
    EXPECT_TRUE(culling.may_touch(key[0])) << "sample " << index;
    scene::detail::CullingBall smaller(ball, tree);
    smaller.set_radius(ball.radius / 2, tree);
    culled += smaller.may_touch(tree.nodes().front()) == 0 ? 1 : 0;
  }
  EXPECT_GT(culled, all / 4) << "it is blind";
}

// Boxes that are stored without rounding, and a centre that floats hold: only the wide reach covers the roundings.
TEST(CullingBall, KeepsABoxThatIsTouchedWhereNothingElseIsRounded) {
  for (std::uint64_t index = 0; index < 20 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 95);
    const auto coordinate = [&] { return static_cast<double>(random.integer(1 << 15, (1 << 16) - 1)); };
    const double x = coordinate(), y = coordinate();
    const Eigen::Vector3d corner(x, y, coordinate());
    const std::vector<Box> boxes{{corner, Eigen::Vector3d::Constant(1 << 16)}};
    const BoxTree tree(boxes);
    const double radius = root_rounded_up(squared_distance(boxes[0], std::vector<mpq_class>(3, 0)));
    const scene::detail::CullingBall culling({{0, 0, 0}, radius}, tree);
    EXPECT_EQ(culling.may_touch(tree.nodes().front()), 1U) << "index " << index;
  }
}

// A ball 2^30 times as far away as the boxes are large is told from one that is a little smaller.
TEST(CullingBall, CullsFromFarAway) {
  const std::vector<Box> boxes{{{0, 0, 0}, {1, 1, 1}}};
  const BoxTree tree(boxes);
  EXPECT_EQ(scene::detail::CullingBall({{0x1p30, 0.5, 0.5}, 0x1p30 - 1}, tree).may_touch(tree.nodes().front()), 1U);
  EXPECT_EQ(scene::detail::CullingBall({{0x1p30, 0.5, 0.5}, 0x1p30 - 2}, tree).may_touch(tree.nodes().front()), 0U);
}

TEST(CullingMotion, MeetsNoMissingBoxes) {
  const std::vector<Box> boxes{{{0, 0, 0}, {1, 1, 1}}};
  const BoxTree tree(boxes);
  for (const Motion& motion : {Motion({{0, 0, 0}, 1}, {1, 2, 3}), Motion({{0, 0, 0}, 1}, {-1, -2, -3}),
                               Motion({{0, 0, 0}, 1}, {0, 0, 0}), Motion({{0, 0, 0}, 0x1p1023}, {0x1p1023, 0, 0})}) {
    EXPECT_EQ(scene::detail::CullingMotion(motion, tree).may_touch(tree.nodes().front()), 1U);
    EXPECT_EQ(scene::detail::CullingBall(motion.ball, tree).may_touch(tree.nodes().front()), 1U);
  }
}

// The times at which a ball comes to boxes in its way.
TEST(CullingMotion, KnowsWhenItComes) {
  const std::vector<Box> boxes{{{8, -1, -1}, {9, 1, 1}}};
  const BoxTree tree(boxes);
  const auto time = [&](const Motion& motion) {
    double earliest[BoxTree::kWidth];
    const unsigned kept = scene::detail::CullingMotion(motion, tree).may_touch(tree.nodes().front(), earliest);
    return (kept & 1) != 0 ? earliest[0] : 2;
  };
  EXPECT_NEAR(time(Motion({{0, 0, 0}, 1}, {16, 0, 0})), 7.0 / 16, 1e-9);
  EXPECT_NEAR(time(Motion({{16, 0, 0}, 1}, {0, 0, 0})), 6.0 / 16, 1e-9);
  EXPECT_EQ(time(Motion({{0, 0, 0}, 1}, {6.9, 0, 0})), 2);
  EXPECT_EQ(time(Motion({{0, 0, 0}, 1}, {16, 16, 0})), 2) << "passes the box along x before it comes to it along y";
  EXPECT_EQ(time(Motion({{8, 3, 0}, 1}, {-8, 3, 0})), 2);
  EXPECT_EQ(time(Motion({{8, 1, 0}, 1}, {-8, 3, 0})), 0);
}

TEST(Swept, MissesNoTriangleThatIsTouched) {
  std::uint64_t missed = 0, all = 200 * TOUCHSTONE_SAMPLES;
  for (std::uint64_t index = 0; index < all; ++index) {
    const MovingSample sample = draw_moving_sample(index);
    if (find_fault(sample.motion)) continue;
    const std::string what = "sample " + std::to_string(index);
    const Triangle corners{sample.box.low, sample.box.high, sample.box.low};  // with the sample's box
    scene::detail::Swept swept(sample.motion);
    EXPECT_FALSE(swept.misses({corners.a, corners.b, corners.c})) << what;
    swept.end_at(sample.eighths / 8.0);
    EXPECT_FALSE(swept.misses({corners.a, corners.b, corners.c})) << what << ", shortened";
    Motion smaller = sample.motion;
    smaller.ball.radius *= 0.5;
    missed += scene::detail::Swept(smaller).misses({corners.a, corners.b, corners.c}) ? 1 : 0;
  }
  EXPECT_GT(missed, all / 8) << "it is blind";
}

// Beyond the largest double a motion cannot be shortened: the whole way counts.
TEST(Swept, IsNotShortenedBeyondTheLargestDouble) {
  const double far = 0x1.8p1023;
  const Motion motion({{-far, 0, 0}, 0}, {far, 0, 0});
  scene::detail::Swept swept(motion);
  swept.end_at(0.5);
  EXPECT_FALSE(swept.misses({{0, -1, -1}, {0, 1, -1}, {0, 0, 1}}));
}

}  // namespace
}  // namespace touchstone::scene_tests
