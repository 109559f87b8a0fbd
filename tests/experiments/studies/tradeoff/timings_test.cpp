// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <set>

#include "experiments/cases/workloads/ulp.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/tradeoff/front.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::tradeoff {
namespace {

using run_tests::kNeverStop;
using run_tests::kSilent;
using workloads::Family;
using workloads::Placement;

TEST(TimedQueries, AreDistinctLegalShuffledAndWhereTheySay) {
  for (const Placement placement : kPlacements) {
    const Queries queries = draw_queries({Family::Comb, placement}, 3, 60);
    ASSERT_EQ(queries.near.size(), 60U);
    ASSERT_EQ(queries.anywhere.size(), 60U);
    for (const Polygon& polygon : queries.polygons) EXPECT_FALSE(exact::validate(polygon));
    std::set<double> centers;
    std::set<std::size_t> polygons;
    for (const auto& [polygon, ball] : queries.near) {
      const double distance = exact::answer(ball, queries.polygons[polygon]).distance;
      EXPECT_LE(std::abs(workloads::doubles_between(distance, ball.radius)), kNearDoubles);
      centers.insert(ball.center.x());
      polygons.insert(polygon);
    }
    EXPECT_GT(centers.size(), 50U);
    EXPECT_GT(polygons.size(), 10U);
    EXPECT_FALSE(std::ranges::is_sorted(queries.near, {}, &Query::polygon));
    const Queries again = draw_queries({Family::Comb, placement}, 3, 60);
    EXPECT_TRUE(std::ranges::equal(
        queries.near, again.near, {}, [](const Query& q) { return q.ball.center.x(); },
        [](const Query& q) { return q.ball.center.x(); }));
  }
}

TEST(Timings, AskEveryMethodAboutEveryList) {
  TimingSettings setting{methods::find_methods({"fast", "rational"}), {{Family::L, Placement::Rotated}}, 1, 50, 2};
  const auto timings = measure_timings(setting, kNeverStop, kSilent);
  ASSERT_EQ(timings.size(), list_count(setting));
  for (const Timing& t : timings) {
    ASSERT_EQ(t.methods.size(), 2U);
    EXPECT_EQ(t.methods[0].name, "fast");
    for (const auto& m : t.methods) {
      EXPECT_EQ(m.nanoseconds.size(), 2U);
      EXPECT_GE(m.queries, 1U);
      EXPECT_LE(m.queries, 50U);
    }
  }
  std::atomic<bool> stop = false;
  const auto part = measure_timings(setting, stop, [&](std::uint64_t) { stop = true; });
  EXPECT_EQ(part.size(), 1U);
}

}  // namespace
}  // namespace touchstone::tradeoff
