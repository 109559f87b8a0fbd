// SPDX-License-Identifier: GPL-3.0-or-later
// The measurements behind the entries on the thesis's method.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "experiments/thesis/figures/angle_sum.h"
#include "experiments/thesis/figures/entry.h"
#include "experiments/thesis/figures/flowchart.h"
#include "experiments/thesis/figures/known_errors.h"
#include "geometry/contact/thesis.h"

#ifndef TOUCHSTONE_SAMPLES
#define TOUCHSTONE_SAMPLES 100
#endif

namespace touchstone::figures {
namespace {

constexpr std::uint64_t kMethodSeed = 7, kSamples = 20 * TOUCHSTONE_SAMPLES;

/// That of the cell's gripper: its mouth at the bottom.
const Outline kGripper{"gripper",
                       {{-45, -75}, {-25, -75}, {-25, -30}, {25, -30}, {25, -75}, {45, -75}, {45, 0}, {-45, 0}}};

std::size_t index_of(std::string_view method) {
  return static_cast<std::size_t>(std::ranges::find(kMethods, method) - kMethods.begin());
}

TEST(Ends, AreCountedByMethodAndByTruth) {
  Ends ends;
  ends.add(End::Inside, End::Inside);
  ends.add(End::Edge, End::Inside);
  ends.add(End::Inside, End::Neither);
  ends.add(End::Neither, End::Edge);
  ends.add(End::Behind, End::InFront);
  EXPECT_EQ(ends.samples(), 5U);
  EXPECT_EQ(ends.at(End::Inside), 2U);
  EXPECT_EQ(ends.exactly_at(End::Inside), 2U);
  EXPECT_EQ(ends.elsewhere(), 4U);
  EXPECT_EQ(ends.true_hits(), 2U);  // by whichever branch
  EXPECT_EQ(ends.false_hits(), 1U);
  EXPECT_EQ(ends.misses(), 1U);
  ends += ends;
  EXPECT_EQ(ends.samples(), 10U);
}

TEST(Flowchart, HasFalseHitsInTheGapAndNoneWithSignedAngles) {
  const Flowchart flowchart = measure_flowchart(kGripper, 0.01, kSamples, kMethodSeed, 1);
  for (const Ends& ends : flowchart.methods) {
    EXPECT_EQ(ends.samples(), kSamples);
    EXPECT_EQ(ends.misses(), 0U);
  }
  const Ends &as_it_is = flowchart.methods[index_of("thesis")], &fast = flowchart.methods[index_of("fast")];
  EXPECT_GT(as_it_is.false_hits(), as_it_is.true_hits() / 3);
  EXPECT_LT(flowchart.culled, as_it_is.false_hits());
  EXPECT_EQ(flowchart.methods[index_of("thesis-signed")].false_hits(), 0U);
  EXPECT_EQ(fast.elsewhere(), 0U);
  for (const End end : kEnds) EXPECT_GT(fast.at(end), 0U) << to_string(end);
}

// The thesis's normal is turned round against the contract's; with Newell's it is not. Neither counts as an error.
TEST(Flowchart, NamesTheFrontAsTheMethodDoes) {
  const Flowchart flowchart = measure_flowchart(find_outline("square"), 0.1, kSamples, kMethodSeed, 1);
  for (const char* method : {"thesis", "thesis-newell", "thesis-float"}) {
    const Ends& ends = flowchart.methods[index_of(method)];
    EXPECT_EQ(ends.at(End::InFront), ends.exactly_at(End::InFront)) << method;
    EXPECT_EQ(ends.at(End::Behind), ends.exactly_at(End::Behind)) << method;
  }
  const Ends &turned = flowchart.methods[index_of("thesis")], &straight = flowchart.methods[index_of("thesis-newell")];
  EXPECT_EQ(turned.at(End::InFront), straight.at(End::Behind));
}

TEST(AngleSum, IsWhatTheMethodAddsUp) {
  for (const Outline& outline : outlines()) {
    const thesis::PreparedPolygon<> method(outline.polygon());
    const figures::Box outer = bounds(outline), box = outer.enlarged(outer.width() / 2, outer.height() / 2);
    for (std::uint64_t i = 0; i < kSamples / 4; ++i) {
      workloads::Random random(kMethodSeed, i);
      const Eigen::Vector3d at = box.point(random);
      const AngleSum sum = angle_sum(outline, at);
      if (std::abs(sum.unsigned_sum - 0.99 * 360) < 1e-6) continue;
      EXPECT_EQ(sum.unsigned_sum >= 0.99 * 360, thesis::foot(Ball{at, 1}, method) == PointLocation::Inside)
          << outline.name << ' ' << at.transpose();
      EXPECT_NEAR(std::abs(std::remainder(sum.signed_sum, 360)), 0, 1e-9);
    }
  }
}

TEST(GripperPoints, LieInThePalmAndInTheGap) {
  const GripperPoints points = gripper_points(kGripper);
  EXPECT_EQ(points.palm, Eigen::Vector3d(0, -15, 0));
  EXPECT_EQ(points.gap, Eigen::Vector3d(0, -52.5, 0));
  EXPECT_NEAR(angle_sum(kGripper, points.palm).signed_sum, 360, 1e-9);
  EXPECT_NEAR(angle_sum(kGripper, points.gap).signed_sum, 0, 1e-9);
  EXPECT_GT(angle_sum(kGripper, points.gap).unsigned_sum, 0.99 * 360);
}

TEST(FactorReach, IsTheDerivedOneOnAConvexOutlineAndMoreOnAGripper) {
  for (const FactorReach& reach : measure_factor_reach(find_outline("square")))
    EXPECT_NEAR(reach.reach, derived_factor_reach(1, reach.factor), 1e-7) << reach.factor;
  EXPECT_NEAR(derived_factor_reach(1, 0.99), 0.00785, 0.000005);
  const auto on_gripper = measure_factor_reach(kGripper);
  EXPECT_EQ(on_gripper.size(), 3 * kGripper.corners.size());
  for (const FactorReach& reach : on_gripper)
    EXPECT_GE(reach.reach, derived_factor_reach(reach.length, reach.factor) - 1e-6) << reach.edge;
}

TEST(Touching, IsMissedByStrictComparisonsAndByNoClosedOne) {
  for (const Touched what : {Touched::Face, Touched::Edge, Touched::Vertex}) {
    const Touching touching = measure_touching(kGripper, what, kSamples, kMethodSeed);
    EXPECT_GT(touching.samples, kSamples / 4);
    EXPECT_EQ(touching.missed_signed, touching.samples);
    EXPECT_EQ(touching.missed_closed, 0U);
    if (what == Touched::Face) {
      EXPECT_EQ(touching.missed, touching.samples);
    }
  }
}

TEST(Collinear, MissesEveryContact) {
  const Collinear collinear = measure_collinear(kGripper, kSamples, kMethodSeed);
  EXPECT_GT(collinear.contacts, kSamples / 10);
  EXPECT_EQ(collinear.missed, collinear.contacts);
  EXPECT_EQ(collinear.missed_newell, 0U);
}

TEST(NotNumbers, AreAboutAQuarterAndHideNoContact) {
  const NotNumbers found = measure_not_numbers(kGripper, kSamples, kMethodSeed);
  EXPECT_GT(found.in_floats, kSamples / 5);
  EXPECT_LT(found.in_floats, 3 * kSamples / 10);
  EXPECT_GT(found.called_outside, 0U);
  EXPECT_EQ(found.misses, 0U);
}

TEST(FarAway, ErrsInFloatsLongBeforeDoubles) {
  const FarAway near = measure_far_away(kGripper, 1, kSamples, kMethodSeed),
                far = measure_far_away(kGripper, 1e9, kSamples, kMethodSeed);
  for (const std::uint64_t wrong : near.wrong) EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(far.wrong[0], 0U);
  EXPECT_GT(far.wrong[1], kSamples / 10);
  EXPECT_EQ(far.wrong[2], 0U);
}

TEST(FootErrors, AreThoseOfTheNumbersTaken) {
  const FootErrors errors = measure_foot_errors(kGripper.polygon(), 6, kSamples, kMethodSeed);
  EXPECT_GT(errors.samples, kSamples / 10);
  EXPECT_LT(errors.in_doubles, 1e-12);
  const Polygon tilted({{0, 0, 100}, {90, 30, 130}, {60, 120, 70}});
  const FootErrors tilted_errors = measure_foot_errors(tilted, 6, kSamples, kMethodSeed);
  EXPECT_LT(tilted_errors.in_doubles, 1e-12);
  EXPECT_GT(tilted_errors.in_floats, 1e-6);
  EXPECT_LT(tilted_errors.in_floats, 1e-3);
}

TEST(EdgePlaces, AddUp) {
  const EdgePlaces places = measure_edge_places(kGripper, 0.05, kSamples, kMethodSeed);
  EXPECT_EQ(places.before + places.beside + places.beyond, places.pairs);
  EXPECT_GT(std::min({places.before, places.beside, places.beyond}), places.pairs / 10);
  EXPECT_EQ(places.wrong[0], 0U);
}

TEST(StatedShare, AllowsMoreWhereLessIsKnown) {
  const StatedShare stated{0.86, 0.01, 1'000'000};
  const double few = tolerance(86, 100, 1'000, stated), many = tolerance(86'000, 100'000, 1'000'000, stated);
  EXPECT_GT(few, 0.3);
  EXPECT_LT(many, 0.03);
  EXPECT_GT(many, 0.005);
  EXPECT_GT(tolerance(0, 100, 1'000, {0, 0.001, 1'000}), 0.03);  // none of a hundred is not certainty
}

// One wrong of 135 where 4.2 % were stated after a million is chance; none of 10,000 is not.
TEST(StatedShare, IsNotMissedByFewSamples) {
  const StatedShare stated{0.042, 0.001, 1'000'000};
  EXPECT_LT(0.042 - 1.0 / 135, tolerance(1, 135, 1'000, stated));
  EXPECT_GT(0.042, tolerance(0, 10'000, 80'000, stated));
}

}  // namespace
}  // namespace touchstone::figures
