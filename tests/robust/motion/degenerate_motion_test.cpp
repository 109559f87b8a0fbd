// SPDX-License-Identifier: GPL-3.0-or-later
// Moving balls and degenerate triangles, as which segments and points are taken: exact against rationals, filtered
// against exact.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <utility>

#include "geometry/shapes/segment.h"
#include "robust/exact/motion.h"
#include "robust/filtered/motion.h"
#include "tests/robust/support/all_kernels.h"
#include "tests/robust/support/degenerate.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/moving.h"

namespace touchstone::contact_tests {
namespace {

mpq_class squared(double x) { return mpq_class(x) * mpq_class(x); }

bool touches_at(const DegenerateCase& c, const mpq_class& time) {
  return DegenerateTruth(c.triangle, center_of(c.motion, time)).squared_distance <= squared(c.motion.ball.radius);
}

RC_GTEST_PROP(DegenerateMotion, ExactContactIsThatOfRationals, ()) {
  const DegenerateCase c = *degenerate_cases();
  const bool truth = least_squared_distance(c.triangle, c.motion, 0, 1) <= squared(c.motion.ball.radius);
  RC_ASSERT(exact::contact(c.motion, c.triangle) == truth);
  const FirstContact first = exact::first_contact(c.motion, c.triangle);
  RC_ASSERT(first.contact() == truth);
  RC_ASSERT((first.kind == FirstContactKind::Start) == touches_at(c, 0));
}

// The ball comes to touch between the middles to the neighbours of the rounded time.
RC_GTEST_PROP(DegenerateMotion, TheRoundedTimeIsTheNearestToTheFirst, ()) {
  const DegenerateCase c = *degenerate_cases();
  const FirstContact first = exact::first_contact(c.motion, c.triangle);
  RC_PRE(first.kind == FirstContactKind::Way);
  const auto middle = [time = mpq_class(first.time)](double other) { return mpq_class((time + mpq_class(other)) / 2); };
  const mpq_class low = first.time > 0 ? middle(std::nextafter(first.time, 0.0)) : mpq_class(0),
                  high = middle(std::nextafter(first.time, 2.0));
  RC_ASSERT(least_squared_distance(c.triangle, c.motion, 0, low) >= squared(c.motion.ball.radius));
  RC_ASSERT(least_squared_distance(c.triangle, c.motion, low, high) <= squared(c.motion.ball.radius));
}

// In small integers the roots of different events are far apart, compared with 2^-30.
RC_GTEST_PROP(DegenerateMotion, ContactFeaturePointAndNormalAreThoseAtTheFirstTime, ()) {
  const DegenerateCase c = *degenerate_lattice_cases();
  const FirstContact first = exact::first_contact(c.motion, c.triangle);
  RC_PRE(first.kind == FirstContactKind::Way);
  const mpq_class after(std::ceil(first.time * 0x1p30 + 1) * 0x1p-30);
  RC_ASSERT(touches_at(c, after) == !first.momentary);
  if (std::floor(0x1p20 * first.time) != 0x1p20 * first.time) return;
  const DegenerateTruth truth(c.triangle, center_of(c.motion, mpq_class(first.time)));
  const double radius = c.motion.ball.radius;
  RC_ASSERT(truth.squared_distance == squared(radius));
  RC_ASSERT(truth.nearest == first.feature);
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    RC_ASSERT(is_nearest(first.point[axis], [&](const mpq_class& m) { return cmp(truth.point[i], m); }));
    if (radius > 0)
      RC_ASSERT(is_nearest(first.contact_normal[axis],
                           [&](const mpq_class& m) { return cmp(mpq_class(truth.away[i] / mpq_class(radius)), m); }));
    else
      RC_ASSERT(first.contact_normal[axis] == 0);
  }
}

RC_GTEST_PROP(DegenerateMotion, FilteredIsExactInEveryEngine, ()) {
  const DegenerateCase c = *degenerate_cases();
  const FirstContact truth = exact::first_contact(c.motion, c.triangle);
  RC_ASSERT(filtered::first_contact(c.motion, c.triangle) == truth);
  RC_ASSERT(filtered::contact(c.motion, c.triangle) == truth.contact());
  for (const auto* kernels : all_kernels()) {
    filtered::NoCounts none;
    filtered::StageCounts counts;
    const auto view = filtered::detail::view_of(c.motion, c.triangle);
    FirstContact found;
    kernels->plain.triangle_first_contact(view, found, none);
    RC_ASSERT(found == truth);
    kernels->counted.triangle_first_contact(view, found, counts);
    RC_ASSERT(found == truth);
    RC_ASSERT(counts != filtered::StageCounts{});
    RC_ASSERT(kernels->plain.triangle_motion_contact(view, none) == truth.contact());
    RC_ASSERT(kernels->counted.triangle_motion_contact(view, counts) == truth.contact());
  }
}

RC_GTEST_PROP(DegenerateMotion, IsTheSameInEveryFloatingPointState, ()) {
  const DegenerateCase c = *degenerate_cases();
  const FirstContact truth = exact::first_contact(c.motion, c.triangle);
  for (const State& state : kStates) {
    FirstContact found;
    bool touches = false, left_as_found = false;
    {
      const Environment changed(state);
      found = filtered::first_contact(c.motion, c.triangle);
      touches = filtered::contact(c.motion, c.triangle);
      left_as_found = changed.left_as_found();
    }
    RC_ASSERT(found == truth);
    RC_ASSERT(touches == truth.contact());
    RC_ASSERT(left_as_found);
  }
}

RC_GTEST_PROP(DegenerateMotion, ComparesTimesExactly, ()) {
  const DegenerateCase c = *degenerate_lattice_cases();
  const Triangle& a = c.triangle;
  const Triangle b = (*degenerate_lattice_cases()).triangle, turned{a.b, a.c, a.a},
                 face{{0, 0, 0}, {4, 0, 1}, {0, 4, 2}};
  for (const Triangle& other : {b, turned, face}) {
    const int truth = exact::compare_times(c.motion, exact::PreparedPolygon(a), exact::PreparedPolygon(other));
    RC_ASSERT(filtered::compare_times(c.motion, a, other) == truth);
    RC_ASSERT(filtered::compare_times(c.motion, other, a) == -truth);
  }
  RC_ASSERT(filtered::compare_times(c.motion, a, turned) == 0);
}

// Double-doubles name the edge of a segment; a fold, where two edges may hold the point, is left to `exact`.
TEST(DegenerateMotion, SegmentsSeldomNeedExact) {
  const Motion falls({{1.25, 0.125, 4}, 0.75}, {1.5, 0.25, -3});
  const Segment segment{{0.1, 0.2, 0.3}, {3.1, 0.7, 0.5}};
  const Triangle fold{segment.a, segment.b, {0.1, 0.2, 0.3}};
  for (const Triangle& triangle : {Triangle(segment), fold, Triangle{segment.b, segment.b, segment.a}}) {
    filtered::StageCounts counts;
    const FirstContact first = filtered::first_contact(falls, triangle, counts);
    EXPECT_EQ(first.kind, FirstContactKind::Way);
    EXPECT_EQ(first.feature.kind, Feature::Kind::Edge);
    EXPECT_EQ(counts.decided_by(filtered::Stage::BigInteger), 0U);
  }
  const Motion passes({{1.25, 4.5, 4}, 0.75}, {1.5, 4.25, -3});
  filtered::StageCounts counts;
  EXPECT_FALSE(filtered::contact(passes, segment, counts));
  EXPECT_FALSE(filtered::first_contact(passes, segment, counts).contact());
  EXPECT_EQ(counts.decided_by(filtered::Stage::BigInteger), 0U);
}

// Where a corner lies between the others, the edge from end to end and a lower one may both hold the touched point.
TEST(DegenerateMotion, NamesTheLowestEdgeOfAFold) {
  const Triangle fold{{1, 0, 0}, {0, 0, 0}, {3, 0, 0}};
  for (const auto& [x, edge] : {std::pair(0.5, std::size_t{0}), std::pair(2.0, std::size_t{1})}) {
    const Motion falls({{x, 0, 4}, 1}, {x, 0, 0});
    EXPECT_EQ(exact::first_contact(falls, fold).feature, (Feature{Feature::Kind::Edge, edge}));
    for (const auto* kernels : all_kernels()) {
      filtered::NoCounts none;
      FirstContact found;
      kernels->plain.triangle_first_contact(filtered::detail::view_of(falls, fold), found, none);
      EXPECT_EQ(found.feature, (Feature{Feature::Kind::Edge, edge}));
    }
  }
}

// A point that slides into a segment along its line stays; one that crosses it does not; and a ball that grazes the end
// of a segment along which it moves stays.
TEST(DegenerateMotion, KnowsMoments) {
  const Segment segment{{0, 0, 0}, {4, 0, 0}};
  const auto first = [&](const Motion& motion) {
    const FirstContact found = filtered::first_contact(motion, segment);
    EXPECT_EQ(found, exact::first_contact(motion, segment));
    return found;
  };
  const FirstContact along = first(Motion({{-4, 0, 0}, 0}, {4, 0, 0}));
  EXPECT_EQ(along.feature, (Feature{Feature::Kind::Vertex, 0}));
  EXPECT_FALSE(along.momentary);
  EXPECT_TRUE(first(Motion({{2, -1, 0}, 0}, {2, 1, 0})).momentary);
  EXPECT_FALSE(first(Motion({{-4, 0, 1}, 1}, {4, 0, 1})).momentary);
  EXPECT_TRUE(first(Motion({{-1, -4, 0}, 1}, {-1, 4, 0})).momentary);
  EXPECT_TRUE(first(Motion({{2, -4, 1}, 1}, {2, 4, 1})).momentary);
}

}  // namespace
}  // namespace touchstone::contact_tests
