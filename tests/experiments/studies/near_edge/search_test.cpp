// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the furthest wrong answers: what it reports is wrong, is found again, and lies where it should.
#include "experiments/studies/near_edge/search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "experiments/cases/case.h"
#include "experiments/cases/comparison.h"
#include "experiments/methods/registry.h"
#include "experiments/program/statistics/shares.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "tests/experiments/support/planted_method.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::near_edge {
namespace {

using workloads::Family;
using workloads::Placement;

using run_tests::kNeverStop;
using run_tests::kSilent;

const cases::Method& method(const char* name) { return *methods::find_method(name); }

Settings search_settings(const std::vector<std::string>& names, std::vector<Family> families, unsigned threads = 2) {
  return {.methods = methods::find_methods(names), .families = std::move(families), .seed = 11, .threads = threads};
}

Onsets onsets_of(const Settings& settings, std::uint64_t samples) {
  Onsets onsets = no_onsets(settings);
  run_onsets(settings, samples, {kNeverStop, kSilent}, onsets);
  return onsets;
}

WorstCases climbed(const Settings& settings, const Onsets& onsets) {
  return run_climbs(settings, {kNeverStop, kSilent}, onsets);
}

std::size_t stratum(Family family, cases::Threshold threshold) {
  std::size_t s = 0;
  while (cases::all_strata()[s].family != family || cases::all_strata()[s].placement != Placement::Rotated ||
         cases::all_strata()[s].threshold != threshold)
    ++s;
  return s;
}

// Wrong between 2^-41 and 1.7 x 2^-20 of the size, right at the threshold itself: bisection from there finds nothing.
TEST(WrongReach, IsFoundWhereItDoesNotBeginAtTheThreshold) {
  const auto at = draw_at_threshold({stratum(Family::L, cases::Threshold::Face), {}, 5, 0});
  ASSERT_TRUE(at);
  const double high = 1.7 * 0x1p-20, size = at->size();
  const run_tests::PlantedMethod wrong([&](const auto& exact, const Ball& ball, cases::QueryKind) {
    const cases::PartialAnswer answer = exact.ask(ball, cases::QueryKind::Answer);
    const double share = (ball.radius - answer.distance.value()) / size;
    cases::PartialAnswer contact;
    contact.contact = answer.contact.value() != (share >= 0x1p-41 && share <= high);
    return contact;
  });
  const WrongReach reach =
      wrong_reach(*at, *wrong.prepare(at->polygon), true, *method("filtered").prepare(at->polygon));
  for (std::size_t k = 0; k <= kMostExponent; ++k) {
    if (k == 41) continue;  // rounding decides
    EXPECT_EQ(reach.wrong[k], k >= 20 && k < 41) << k;
  }
  EXPECT_LE(reach.share, high);
  EXPECT_GT(reach.share, high - 0x1p-20 / kSteps * 1.01);  // within one of the even steps
  ASSERT_TRUE(reach.furthest);
  EXPECT_GT(reach.furthest->radius, at->ball.radius);
}

TEST(WrongReach, OfExactIsNothing) {
  for (const cases::Threshold threshold : cases::all_thresholds()) {
    if (threshold == cases::Threshold::Tangent) continue;
    const auto at = draw_at_threshold({stratum(Family::Star, threshold), {}, 5, 1});
    ASSERT_TRUE(at);
    EXPECT_EQ(at->moved_axis >= 0, !cases::moves_radius(threshold));
    const WrongReach reach =
        wrong_reach(*at, *method("exact").prepare(at->polygon), true, *method("filtered").prepare(at->polygon));
    EXPECT_FALSE(reach.furthest) << to_string(threshold);
    EXPECT_EQ(std::count(reach.wrong.begin(), reach.wrong.end(), true), 0);
  }
}

// A climb only ever goes further, and stays a case of its kind.
TEST(Climb, GoesFurtherAndStaysOfItsKind) {
  int further = 0;
  for (const cases::Threshold threshold :
       {cases::Threshold::Face, cases::Threshold::Edge, cases::Threshold::Vertex, cases::Threshold::FootEdge}) {
    const auto start = draw_at_threshold({stratum(Family::E, threshold), {}, 5, 2});
    ASSERT_TRUE(start);
    const WrongReach before =
        wrong_reach(*start, *method("fast").prepare(start->polygon), true, *method("filtered").prepare(start->polygon));
    const auto [at, reach] = climb(*start, method("fast"), workloads::Random(1, 2));
    EXPECT_FALSE(reach < before) << to_string(threshold);
    further += before < reach ? 1 : 0;
    EXPECT_FALSE(exact::validate(at.polygon));
    EXPECT_EQ(at.polygon.vertex_count(), start->polygon.vertex_count());
    const Feature::Kind kind = exact::answer(start->ball, start->polygon).nearest.kind;
    const Answer answer = exact::answer(at.ball, at.polygon);
    if (cases::moves_radius(threshold)) {
      EXPECT_EQ(answer.nearest.kind, kind) << to_string(threshold);
      EXPECT_EQ(answer.distance, at.ball.radius) << to_string(threshold);
    } else {
      EXPECT_NE(answer.foot, PointLocation::Outside);
    }
    const auto [again, same] = climb(*start, method("fast"), workloads::Random(1, 2));
    EXPECT_EQ(same.share, reach.share) << "a climb is a function of its arguments";
  }
  EXPECT_GT(further, 0);
}

// Far from the origin moves by bits are large: many would bring the foot over the face, or another feature nearest.
TEST(Climb, KeepsTheKindOfTheNearestFeature) {
  for (std::uint64_t n = 0; n < 6; ++n)
    for (const auto& [threshold, kind] : {std::pair{cases::Threshold::Edge, Feature::Kind::Edge},
                                          std::pair{cases::Threshold::Vertex, Feature::Kind::Vertex}}) {
      const auto start = draw_at_threshold({stratum(Family::Star, threshold), {.origin_distance = 1e6}, 5, n});
      ASSERT_TRUE(start);
      const Climbed climbed = climb(*start, method("thesis-signed"), workloads::Random(1, n));
      EXPECT_EQ(exact::answer(climbed.at.ball, climbed.at.polygon).nearest.kind, kind) << n;
    }
}

// Each case reads as the judge reads it; `exact` meets what is expected, the method that it names does not.
TEST(Search, ReportsCasesThatAreWrong) {
  const auto setting = search_settings({"fast", "thesis"}, {Family::L});
  const Onsets onsets = onsets_of(setting, 6);
  const WorstCases worst = climbed(setting, onsets);
  EXPECT_EQ(worst.wrong_truths, 0U);
  int found = 0;
  for (std::size_t i = 0; i < worst.all.size(); ++i) {
    const auto& [share, n, line] = worst.all[i];
    if (onsets.all[i].furthest.empty()) continue;
    EXPECT_GE(share, onsets.all[i].furthest.front().share);
    const cases::Case read = cases::read_case(line);
    ASSERT_TRUE(std::holds_alternative<cases::Shapes>(read.content)) << line;
    const auto& shapes = std::get<cases::Shapes>(read.content);
    const auto meets = [&](const cases::Method& asked) {
      const auto answer = asked.prepare(shapes.polygon)->ask(shapes.ball(), cases::QueryKind::Answer);
      return cases::differences(*read.expected, answer).empty();
    };
    EXPECT_TRUE(meets(method("exact"))) << line;
    EXPECT_FALSE(meets(*setting.methods[i % 2])) << line;
    ++found;
  }
  EXPECT_GT(found, 20);
}

TEST(Search, TheNumberOfThreadsChangesNothing) {
  const auto one = search_settings({"fast", "thesis"}, {Family::U}, 1),
             three = search_settings({"fast", "thesis"}, {Family::U}, 3);
  const Onsets onsets = onsets_of(one, 7), same = onsets_of(three, 7);
  EXPECT_EQ(program::archived(onsets), program::archived(same));
  EXPECT_EQ(climbed(one, onsets).all, climbed(three, same).all);
}

/// How many of a hundred samples at a face are wrong at 2^-k, with limits.
statistics::Limits rate(const Settings& settings, const Onsets& onsets, Family family, std::size_t m, double distance,
                        std::size_t k) {
  const auto regions = search_regions(settings.families);
  std::size_t r = 0;
  while (regions[r].stratum != stratum(family, cases::Threshold::Face) || regions[r].origin_distance != distance) ++r;
  const Onset& onset = onsets.all[r * settings.methods.size() + m];
  return statistics::clopper_pearson(onset.wrong[k], onset.samples, 0.999);
}

// The known result: doubles begin to err near 2^-51 of the size at the origin, near 2^-36 at 10^6 sizes from it: rare
// or absent some powers of two further out, frequent there or just further in. Triangles are differences of vertices
// to `fast`, so that distance costs nothing.
TEST(Search, DoublesBeginToErrWhereTheyAreKnownTo) {
  constexpr std::size_t kFast = 0, kThesis = 1;
  const auto setting = search_settings({"fast", "thesis"}, {Family::Triangle, Family::Star});
  const Onsets onsets = onsets_of(setting, 100);
  const auto begins = [&](Family family, std::size_t m, double distance, std::size_t rare, std::size_t frequent) {
    EXPECT_LT(rate(setting, onsets, family, m, distance, rare).upper, 0.12) << distance << " 2^-" << rare;
    EXPECT_GT(rate(setting, onsets, family, m, distance, frequent).lower, 0.12) << distance << " 2^-" << frequent;
  };
  begins(Family::Star, kFast, 0, 49, 55);
  begins(Family::Star, kFast, 1e3, 42, 46);
  begins(Family::Star, kFast, 1e6, 32, 36);
  begins(Family::Triangle, kThesis, 0, 47, 55);
  begins(Family::Triangle, kThesis, 1e3, 39, 45);
  begins(Family::Triangle, kThesis, 1e6, 30, 36);
  begins(Family::Triangle, kFast, 1e6, 47, 56);
}

}  // namespace
}  // namespace touchstone::near_edge
