// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of robust/filtered/motion.h: (1) the answers of exact, (2) batches are single queries, (3) every
// engine gives the same answers; in every rounding mode, with and without subnormal numbers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "robust/exact/motion.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "robust/filtered/motion.h"
#include "tests/robust/support/all_kernels.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/hand_cases.h"
#include "tests/robust/support/hard_cases.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

using filtered::detail::Kernels;

RC_GTEST_PROP(FilteredMotion, IsExactForPreparedPolygons, ()) {
  const MovingCase c = *moving(hard_cases());
  const FirstContact truth = exact::first_contact(c.motion, c.polygon);
  const filtered::PreparedPolygon prepared(c.polygon);
  RC_ASSERT(filtered::first_contact(c.motion, prepared) == truth);
  RC_ASSERT(filtered::contact(c.motion, prepared) == truth.contact());
  filtered::StageCounts counts;
  RC_ASSERT(filtered::first_contact(c.motion, prepared, counts) == truth);
  RC_ASSERT(counts != filtered::StageCounts{});
  RC_ASSERT(filtered::contact(c.motion, prepared, counts) == truth.contact());
}

RC_GTEST_PROP(FilteredMotion, IsExactForPolygonsAskedOnce, ()) {
  const MovingCase c = *any_moving_case();
  const FirstContact truth = exact::first_contact(c.motion, c.polygon);
  RC_ASSERT(filtered::first_contact(c.motion, c.polygon) == truth);
  RC_ASSERT(filtered::contact(c.motion, c.polygon) == truth.contact());
}

RC_GTEST_PROP(FilteredMotion, IsExactForTriangles, ()) {
  const MovingCase c = *moving(hard_triangles());
  const Triangle triangle = triangle_of(c.polygon);
  const FirstContact truth = exact::first_contact(c.motion, c.polygon);
  RC_ASSERT(filtered::first_contact(c.motion, triangle) == truth);
  RC_ASSERT(filtered::contact(c.motion, triangle) == truth.contact());
  filtered::StageCounts counts;
  RC_ASSERT(filtered::first_contact(c.motion, triangle, counts) == truth);
  RC_ASSERT(counts != filtered::StageCounts{});
  RC_ASSERT(filtered::contact(c.motion, triangle, counts) == truth.contact());
}

// Guarantee (3), and every walk: of few edges, which are otherwise scanned, too.
RC_GTEST_PROP(FilteredMotion, IsTheSameInEveryEngine, ()) {
  const MovingCase c = *moving(hard_cases());
  const FirstContact truth = exact::first_contact(c.motion, c.polygon);
  for (const Kernels* kernels : all_kernels()) {
    for (const auto use :
         {filtered::detail::EdgeIndex::Use::Often, filtered::detail::EdgeIndex::Use::OftenByHierarchy}) {
      const filtered::PreparedPolygon::Parts parts(c.polygon, use);
      filtered::NoCounts none;
      FirstContact found;
      kernels->plain.first_contact(c.motion, parts, found, none);
      RC_ASSERT(found == truth);
      RC_ASSERT(kernels->plain.motion_contact(c.motion, parts, none) == truth.contact());
    }
  }
}

RC_GTEST_PROP(FilteredMotion, IsTheSameInEveryEngineForTriangles, ()) {
  const MovingCase c = *moving(hard_triangles());
  const Triangle triangle = triangle_of(c.polygon);
  const FirstContact truth = exact::first_contact(c.motion, c.polygon);
  for (const Kernels* kernels : all_kernels()) {
    filtered::NoCounts none;
    FirstContact found;
    kernels->plain.triangle_first_contact(filtered::detail::view_of(c.motion, triangle), found, none);
    RC_ASSERT(found == truth);
    RC_ASSERT(kernels->plain.triangle_motion_contact(filtered::detail::view_of(c.motion, triangle), none) ==
              truth.contact());
  }
}

// Only the answers count, but flags that a caller may trap must stay as they are, too.
RC_GTEST_PROP(FilteredMotion, IsTheSameInEveryFloatingPointState, ()) {
  const MovingCase c = *moving(hard_triangles());
  const Triangle triangle = triangle_of(c.polygon);
  const FirstContact truth = exact::first_contact(c.motion, c.polygon);
  const filtered::PreparedPolygon prepared(c.polygon);
  for (const State& state : kStates) {
    std::array<FirstContact, 2> found;
    std::array<bool, 2> touches{};
    bool left_as_found = false;
    {
      const Environment changed(state);
      found = {filtered::first_contact(c.motion, triangle), filtered::first_contact(c.motion, prepared)};
      touches = {filtered::contact(c.motion, triangle), filtered::contact(c.motion, prepared)};
      left_as_found = changed.left_as_found();
    }
    RC_ASSERT(found[0] == truth);
    RC_ASSERT(found[1] == truth);
    RC_ASSERT(touches[0] == truth.contact());
    RC_ASSERT(touches[1] == truth.contact());
    RC_ASSERT(left_as_found);
  }
}

RC_GTEST_PROP(FilteredMotion, ComparesTimesExactly, ()) {
  const MovingCase first = *moving(hard_triangles()), second = *moving(hard_triangles());
  // The second triangle in the way of the first motion; and the first triangle again, which is touched at equal times.
  const Triangle a = triangle_of(first.polygon), b = triangle_of(second.polygon), turned{a.b, a.c, a.a};
  const exact::PreparedPolygon exact_a(first.polygon), exact_b(second.polygon);
  const filtered::PreparedPolygon prepared_a(first.polygon), prepared_b(second.polygon);
  const int truth = exact::compare_times(first.motion, exact_a, exact_b);
  RC_ASSERT(filtered::compare_times(first.motion, a, b) == truth);
  RC_ASSERT(filtered::compare_times(first.motion, b, a) == -truth);
  RC_ASSERT(filtered::compare_times(first.motion, prepared_a, prepared_b) == truth);
  RC_ASSERT(filtered::compare_times(first.motion, a, turned) == 0);
}

RC_GTEST_PROP(FilteredMotion, BatchesAreSingleQueries, ()) {
  const MovingCase c = *moving(hard_triangles());
  const Motion reversed{{c.motion.to, c.motion.ball.radius}, c.motion.ball.center};
  const std::vector<Motion> motions{c.motion, reversed, {c.motion.ball, c.motion.ball.center}};
  const filtered::PreparedPolygon prepared(c.polygon);
  std::array<bool, 3> touches{};
  filtered::contact(motions, prepared, touches);
  for (std::size_t i = 0; i < motions.size(); ++i) RC_ASSERT(touches[i] == filtered::contact(motions[i], prepared));
  const Triangle t = triangle_of(c.polygon);
  const Eigen::Vector3d far = t.a + (t.b - t.a) + (t.c - t.a);
  RC_PRE(far.allFinite());
  const std::vector<Triangle> triangles{t, {t.b, t.a, t.c}, {t.b, t.c, t.a}};
  filtered::contact(c.motion, triangles, touches);
  for (std::size_t i = 0; i < triangles.size(); ++i) RC_ASSERT(touches[i] == filtered::contact(c.motion, triangles[i]));
}

TEST(FilteredMotion, BatchesOfDifferentLengthsAreRefused) {
  const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Motion motion{{{0, 0, 1}, 0.5}, {0, 0, -1}};
  std::array<bool, 2> touches{};
  const std::vector<Triangle> triangles{triangle};
  EXPECT_THROW(filtered::contact(motion, triangles, touches), std::invalid_argument);
  const filtered::PreparedPolygon prepared(Polygon({triangle.a, triangle.b, triangle.c}));
  const std::vector<Motion> motions(3, motion);
  EXPECT_THROW(filtered::contact(motions, prepared, touches), std::invalid_argument);
}

TEST(FilteredMotion, IsWhatWasDerivedByHand) {
  for (const auto& [given, expected] : moving_hand_cases()) {
    const filtered::PreparedPolygon prepared(given.polygon);
    EXPECT_EQ(filtered::first_contact(given.motion, prepared), expected) << given.id;
    EXPECT_EQ(filtered::contact(given.motion, prepared), expected.contact()) << given.id;
    if (given.polygon.vertex_count() != 3) continue;
    EXPECT_EQ(filtered::first_contact(given.motion, triangle_of(given.polygon)), expected) << given.id;
  }
}

// Steps of the point from exact numbers underflow, or have underflowed in the frame's unit of length.
TEST(FilteredMotion, RoundsPointsWithVerySmallCoordinates) {
  const std::vector<std::pair<Motion, Triangle>> cases{
      {{{{0, 0, 0x1.ce1b86f04904cp+21}, 0x1.59504f517bda6p-975}, {0, 0, -0x1.999999999999ap+22}},
       {{0x1.999999999999ap+22, -0x1.ccccccccccccdp+24, 0},
        {0x1.999999999999ap+22, 0x1.ccccccccccccdp+24, 0},
        {-0x1.999999999999ap+23, 0, 0x1.999999999999ap+22}}},
      {{{{0, 0, 1}, 0x0.0000000000003p-1022}, {0, 0, -1}}, {{1, -5, 0}, {1, 5, 0}, {-2, 0, 1}}},
      {{{{0x1.b05e319e42b57p+642, 0x1.45491789ab089p+642, 0x1.84aae644c7e2ap+641}, 0x1.6f68c9cfdbcb8p+641},
        {-0x1.7a1631398fdp+641, -0x1.2b90108ba5174p+639, 0x1.642a22b5e3872p+642}},
       {{0x1.c46fef35d2a0dp+543, 0x1.9c4bebf88p-398, 0x1.149e91c9222c6p+641},
        {0x1.7ba26b31a4fa4p+641, 0, 0x1.149e91c9222c6p+641},
        {0x1.e91df59f85396p+641, -0x1.0bc5b95dabdb6p+641, 0x1.149e91c9222c6p+641}}},
      {{{{0, 0x1.3333333333333p-2, 3}, 0}, {0x1p-1018, 0x1.3333333333333p-2, -4}},
       {{-1, -5, 0}, {1, -5, 0}, {0, 5, 0}}},
      {{{{2, 0x1.0000000000002p-1, 0}, 0.5}, {-1, 0x1.0000000000002p-1, 0}},
       {{0, 0, 0}, {0x1p-1019, 1, 0}, {-4, 0.5, 0}}}};
  for (const auto& [motion, triangle] : cases) {
    const Polygon polygon({triangle.a, triangle.b, triangle.c});
    const FirstContact truth = exact::first_contact(motion, polygon);
    EXPECT_EQ(truth.kind, FirstContactKind::Way);
    EXPECT_EQ(filtered::first_contact(motion, triangle), truth);
    EXPECT_EQ(filtered::first_contact(motion, polygon), truth);
    EXPECT_EQ(filtered::first_contact(motion, filtered::PreparedPolygon(polygon)), truth);
  }
}

// What the filters are for: ordinary motions never reach the integers.
TEST(FilteredMotion, DecidesRandomMotionsInDoublesAndRoundsInDoubleDoubles) {
  filtered::StageCounts contacts, firsts;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    auto coordinate = [state = 0x9e3779b97f4a7c15 * (i + 1)]() mutable {
      state ^= state << 13, state ^= state >> 7, state ^= state << 17;
      return static_cast<double>(state >> 11) * 0x1p-52 - 1;
    };
    const auto point = [&coordinate] {
      const double x = coordinate(), y = coordinate();
      return Eigen::Vector3d(x, y, coordinate());
    };
    const Triangle triangle{point(), point(), point()};
    const Eigen::Vector3d from = 2 * point();
    const Motion motion{{from, 0.25}, 2 * point()};
    (void)filtered::contact(motion, triangle, contacts);
    (void)filtered::first_contact(motion, triangle, firsts);
  }
  EXPECT_EQ(contacts.last(), filtered::Stage::Double);
  EXPECT_EQ(firsts.last(), filtered::Stage::DoubleDouble);
}

TEST(FilteredMotion, DecidesBallsAtRestAsBallsAtAPlace) {
  const Triangle triangle{{0, 0, 0}, {3, 1, 0.5}, {1, 2, 1}};
  const Polygon polygon({triangle.a, triangle.b, triangle.c});
  const filtered::PreparedPolygon prepared(polygon);
  filtered::StageCounts contacts, firsts;
  bool some = false, all = true;
  for (int i = 0; i < 200; ++i) {
    const Ball ball{{0.02 * i - 1, 0.015 * i - 0.5, 0.01 * i}, 0.375};
    const Motion motion(ball, ball.center);
    const bool touches = filtered::contact(ball, triangle);
    some = some || touches, all = all && touches;
    EXPECT_EQ(filtered::contact(motion, triangle, contacts), touches);
    EXPECT_EQ(filtered::contact(motion, prepared, contacts), touches);
    EXPECT_EQ(filtered::first_contact(motion, triangle, firsts), exact::first_contact(motion, polygon));
    EXPECT_EQ(filtered::first_contact(motion, prepared, firsts), exact::first_contact(motion, polygon));
  }
  EXPECT_TRUE(some && !all);
  EXPECT_EQ(contacts.last(), filtered::Stage::Double);
  EXPECT_LT(firsts.last(), filtered::Stage::BigInteger);
}

}  // namespace
}  // namespace touchstone::contact_tests
