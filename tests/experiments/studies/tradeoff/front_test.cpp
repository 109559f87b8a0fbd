// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tradeoff/front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "tests/experiments/studies/tradeoff/small_study.h"

namespace touchstone::tradeoff {
namespace {

using cases::QueryKind;
using workloads::Family;
using workloads::Placement;

bool no_less_right(const ParetoEntry& a, const ParetoEntry& b) { return a.error <= b.error; }
bool faster(const ParetoEntry& a, const ParetoEntry& b) { return a.nanoseconds.upper < b.nanoseconds.lower; }

/// By medians alone.
bool dominates(const ParetoEntry& a, const ParetoEntry& b) {
  const double ours = a.nanoseconds.median, theirs = b.nanoseconds.median;
  return ours <= theirs && a.error <= b.error && (ours < theirs || a.error < b.error);
}

/// What front.h says of each word, and its identities (1) and (2).
void expect_front(const std::vector<ParetoEntry>& entries) {
  for (const ParetoEntry& s : entries) {
    const auto any = [&](const auto& holds) {
      return std::ranges::any_of(entries, [&](const ParetoEntry& other) { return &other != &s && holds(other); });
    };
    EXPECT_EQ(s.front == Front::Off, any([&](const ParetoEntry& o) { return no_less_right(o, s) && faster(o, s); }));
    EXPECT_EQ(s.front == Front::On, !any([&](const ParetoEntry& o) { return no_less_right(o, s) && !faster(s, o); }));
    const bool by_medians = !any([&](const ParetoEntry& o) { return dominates(o, s); });
    EXPECT_TRUE(s.front != Front::On || by_medians);
    EXPECT_TRUE(s.front != Front::Off || !by_medians);
    EXPECT_TRUE(s.front != Front::Off || any([&](const ParetoEntry& o) {
                  return o.front != Front::Off && no_less_right(o, s) && faster(o, s);
                }));
  }
}

ParetoEntry entry(double nanoseconds, double noise, double error) {
  return {.method = 0,
          .nanoseconds = {nanoseconds - noise, nanoseconds, nanoseconds + noise},
          .error = error,
          .lower = 0,
          .upper = 1,
          .finite_error = error,
          .not_finite = 0,
          .samples = 1};
}

TEST(Front, HoldsWhomNoneIsBetterThanBeyondTheNoise) {
  workloads::Random random(3, 0);
  for (int round = 0; round < 200; ++round) {
    std::vector<ParetoEntry> list;
    for (std::int64_t i = random.integer(1, 12); i > 0; --i) {
      const auto draw = [&](std::int64_t most) { return static_cast<double>(random.integer(0, most)); };
      list.push_back(entry(draw(9), draw(2), draw(6)));
    }
    mark_front(list);
    expect_front(list);
    EXPECT_TRUE(std::ranges::any_of(list, [](const ParetoEntry& s) { return s.front != Front::Off; }));
  }
}

TEST(Front, DropsWhatIsSlowerOnlyWhereNoiseCannotBeWhy) {
  std::vector<ParetoEntry> list{entry(10, 1, 0), entry(11, 1, 0), entry(20, 1, 0), entry(5, 1, 0.5),
                                entry(30, 25, 0.7)};
  mark_front(list);
  EXPECT_EQ(list[0].front, Front::WithinNoise);
  EXPECT_EQ(list[1].front, Front::WithinNoise);
  EXPECT_EQ(list[2].front, Front::Off);
  EXPECT_EQ(list[3].front, Front::On);
  EXPECT_EQ(list[4].front, Front::WithinNoise) << "slower and less right, but perhaps not slower";
}

Timing timing(Family family, QueryKind kind, const std::vector<double>& nanoseconds) {
  Timing timing{{family, Placement::Rotated}, Balls::Near, kind, {}};
  for (const double ns : nanoseconds) timing.methods.push_back({"", 1, {ns}, {}, {}, {}});
  return timing;
}

TEST(Front, StandsOnTheMeasureItNames) {
  const auto setting = settings({"fast", "thesis", "filtered", "interval"}, 4);
  const Errors errors = whole(setting);
  const std::vector<Timing> timings{timing(Family::Star, QueryKind::Contact, {1, 2, 3, 4}),
                                    timing(Family::L, QueryKind::Contact, {3, 4, 5, 6}),
                                    timing(Family::Star, QueryKind::Answer, {10, 20, 30, 40})};
  const auto shares = pareto_entries(Measure::NotRight, std::nullopt, Placement::Rotated, errors, timings);
  ASSERT_EQ(shares.size(), 4U);
  expect_front(shares);
  EXPECT_EQ(shares[2].nanoseconds.median, 4);  // the mean of both families
  EXPECT_EQ(shares[2].error, 0);
  EXPECT_GT(shares[2].upper, 0);                // never seen wrong is not never wrong
  EXPECT_GT(shares[3].error, shares[0].error);  // "don't know" is not right either
  const auto points = pareto_entries(Measure::Point, Family::Star, Placement::Rotated, errors, timings);
  ASSERT_EQ(points.size(), 2U);  // the thesis gives no point, intervals know hardly any
  expect_front(points);
  EXPECT_EQ(points[0].nanoseconds.median, 10);
  EXPECT_EQ(points[1].method, 2U);
  EXPECT_EQ(points[1].upper, 0);
  EXPECT_TRUE(pareto_entries(Measure::Point, Family::L, Placement::Rotated, errors, timings).empty());  // not timed
}

}  // namespace
}  // namespace touchstone::tradeoff
