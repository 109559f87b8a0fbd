// SPDX-License-Identifier: GPL-3.0-or-later
// Guarantee (3): every engine that this machine can run gives the same answers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "robust/exact/exact.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "tests/robust/support/all_kernels.h"
#include "tests/robust/support/hard_cases.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;
using filtered::detail::Kernels;

RC_GTEST_PROP(FilteredEngines, AreExactOnTriangles, ()) {
  const Case c = *hard_triangles();
  const bool touches = exact::contact(c.ball, c.polygon);
  const Triangle triangle = triangle_of(c.polygon);
  const std::vector<Triangle> triangles(7, triangle);
  for (const Kernels* kernels : all_kernels()) {
    filtered::NoCounts none;
    filtered::StageCounts counts;
    RC_ASSERT(kernels->plain.triangle_contact(filtered::detail::view_of(c.ball, triangle), none) == touches);
    RC_ASSERT(kernels->counted.triangle_contact(filtered::detail::view_of(c.ball, triangle), counts) == touches);
    std::array<bool, 7> found{};
    kernels->triangles_contact(c.ball, triangles, found);
    RC_ASSERT(std::count(std::begin(found), std::end(found), touches) == 7);
  }
}

template <class Counts>
void expect_exact_answers(const filtered::detail::KernelTable<Counts>& ask, const Case& c, const Answer& truth) {
  for (const auto use : {filtered::detail::EdgeIndex::Use::Often, filtered::detail::EdgeIndex::Use::OftenByHierarchy}) {
    const filtered::PreparedPolygon::Parts parts(c.polygon, use);
    Counts counts;
    RC_ASSERT(ask.answer(c.ball, parts, counts) == truth);
    RC_ASSERT(ask.contact(c.ball, parts, counts) == truth.contact());
    RC_ASSERT(ask.relation(c.ball, parts, counts) == truth.relation);
    RC_ASSERT(ask.plane_side(c.ball, parts, counts) == truth.plane);
    RC_ASSERT(ask.foot(c.ball, parts, counts) == truth.foot);
    RC_ASSERT(ask.edges_hit(c.ball, parts, counts) == truth.edges_hit);
  }
}

RC_GTEST_PROP(FilteredEngines, AreExactOnPolygons, ()) {
  const Case c = *hard_cases();
  const Answer truth = exact::answer(c.ball, c.polygon);
  for (const Kernels* kernels : all_kernels()) {
    expect_exact_answers(kernels->plain, c, truth);
    expect_exact_answers(kernels->counted, c, truth);
    const filtered::PreparedPolygon prepared(c.polygon);
    // Neighbours of other sizes: each lane must keep to its own ball.
    std::vector<Ball> balls(7, c.ball);
    if (c.ball.radius < 0x1p1000) balls[1].radius *= 4, balls[3].radius /= 4, balls[6].radius /= 2;
    std::array<bool, 7> found{};
    kernels->balls_contact(balls, parts_of(prepared), found);
    for (std::size_t i = 0; i < balls.size(); ++i) RC_ASSERT(found[i] == exact::contact(balls[i], c.polygon));
  }
}

// The last edge of the outline ends where its first one begins, and not where the hole does.
TEST(FilteredEngines, FindTheEdgesThatABallTouchesAtTheEndOfALoop) {
  const Polygon polygon({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, {{{3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}}});
  const filtered::PreparedPolygon prepared(polygon);
  for (const Kernels* kernels : all_kernels()) {
    filtered::NoCounts none;
    EXPECT_EQ(kernels->plain.edges_hit({{-3, -4, 0}, 5}, parts_of(prepared), none), (std::vector<std::size_t>{0, 3}));
  }
}

#if defined(__x86_64__)
// What runs is the faster one; a build that forgets the flags would pass every other test.
TEST(FilteredEngines, AreTwoWhereTheMachineHasAvx2) {
  const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  EXPECT_EQ(all_kernels().size(), has_avx2 ? 2U : 1U);
}
#endif

}  // namespace
}  // namespace touchstone::filtered_tests
