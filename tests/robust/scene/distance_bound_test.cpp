// SPDX-License-Identifier: GPL-3.0-or-later
// Upper bounds of distances from triangles, against contact as the filtered path decides it.
#include "robust/scene/detail/distance_bound.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robust/filtered/filtered.h"
#include "tests/robust/support/draw_point.h"

namespace touchstone::scene_tests {
namespace {

using contact_tests::draw_point;
using workloads::Random;

TEST(DistanceAtMost, IsAtLeastTheDistanceAndLittleMore) {
  for (std::uint64_t index = 0; index < 100 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 93);
    const double size = std::ldexp(1.0, static_cast<int>(random.integer(-180, 180)));
    const double thin = random.coin() ? 1 : std::ldexp(1.0, -static_cast<int>(random.integer(0, 40)));
    const Eigen::Vector3d a = draw_point(random, size), b = draw_point(random, size);
    const Triangle triangle{a, b, a + random.unit() * (b - a) + draw_point(random, thin * size)};
    Eigen::Vector3d center = draw_point(random, 2 * size);
    // On it or beside it, nearly.
    if (random.coin())
      center = a + random.unit() * (b - a) + draw_point(random, size * std::abs(random.log_uniform(-50, 0)));
    const double bound = scene::detail::distance_at_most(center, triangle);
    EXPECT_TRUE(filtered::contact({center, bound}, triangle)) << "sample " << index;
    const double largest = 8 * size;
    const double slack = thin == 1 ? 0x1p-30 : 0x1p-4;  // a needle's closest point may be taken for another
    if (bound > slack * largest) {
      EXPECT_FALSE(filtered::contact({center, bound - slack * largest}, triangle)) << "sample " << index;
    }
  }
}

TEST(DistanceAtMost, IsUnknownForNumbersThatMayOverflowOrUnderflow) {
  const Triangle unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto times = [&](double s) { return Triangle{s * unit.a, s * unit.b, s * unit.c}; };
  EXPECT_NEAR(scene::detail::distance_at_most({0, 0, 1}, unit), 1, 0x1p-47);
  EXPECT_TRUE(std::isinf(scene::detail::distance_at_most({0, 0, 0x1p201}, unit)));
  EXPECT_TRUE(std::isinf(scene::detail::distance_at_most({0, 0, 0}, times(0x1p201))));
  EXPECT_TRUE(std::isinf(scene::detail::distance_at_most({0, 0, 0}, times(0x1p-201))));
  EXPECT_TRUE(std::isinf(scene::detail::distance_at_most({0, 0, 0}, times(0))));
}

}  // namespace
}  // namespace touchstone::scene_tests
