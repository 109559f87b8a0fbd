// SPDX-License-Identifier: GPL-3.0-or-later
// Guarantee (3): every engine that this machine can run gives the same answers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "robust/exact/exact.h"
#include "robust/filtered/detail/kernels.h"
#include "tests/contact/printing.h"
#include "tests/filtered/hard_cases.h"

namespace touchstone::filtered_tests {
namespace {

using filtered::Engine;

std::vector<const Engine*> engines() {
  std::vector<const Engine*> list{&filtered::baseline_engine()};
  if (&filtered::engine() != list.front()) list.push_back(&filtered::engine());
  return list;
}

RC_GTEST_PROP(FilteredEngines, AreExactOnTriangles, ()) {
  const Case c = *hard_triangles();
  const bool touches = exact::contact(c.ball, c.polygon);
  const Triangle triangle = triangle_of(c.polygon);
  const std::vector<Triangle> triangles(7, triangle);
  for (const Engine* engine : engines()) {
    filtered::NoCounts none;
    filtered::StageCounts counts;
    RC_ASSERT(engine->plain.triangle_contact(filtered::question(c.ball, triangle), none) == touches);
    RC_ASSERT(engine->counted.triangle_contact(filtered::question(c.ball, triangle), counts) == touches);
    std::array<bool, 7> found{};
    engine->triangles_contact(c.ball, triangles, found);
    RC_ASSERT(std::count(std::begin(found), std::end(found), touches) == 7);
  }
}

template <class Counts>
void expect_exact_answers(const filtered::Questions<Counts>& ask, const Case& c, const Answer& truth) {
  const filtered::PreparedPolygon prepared(c.polygon);
  const auto& parts = parts_of(prepared);
  Counts counts;
  RC_ASSERT(ask.answer(c.ball, parts, counts) == truth);
  RC_ASSERT(ask.contact(c.ball, parts, counts) == truth.contact());
  RC_ASSERT(ask.relation(c.ball, parts, counts) == truth.relation);
  RC_ASSERT(ask.plane_side(c.ball, parts, counts) == truth.plane);
  RC_ASSERT(ask.foot(c.ball, parts, counts) == truth.foot);
  RC_ASSERT(ask.edges_hit(c.ball, parts, counts) == truth.edges_hit);
}

RC_GTEST_PROP(FilteredEngines, AreExactOnPolygons, ()) {
  const Case c = *hard_cases();
  const Answer truth = exact::answer(c.ball, c.polygon);
  for (const Engine* engine : engines()) {
    expect_exact_answers(engine->plain, c, truth);
    expect_exact_answers(engine->counted, c, truth);
    const filtered::PreparedPolygon prepared(c.polygon);
    const std::vector<Ball> balls(7, c.ball);
    std::array<bool, 7> found{};
    engine->balls_contact(balls, parts_of(prepared), found);
    RC_ASSERT(std::count(std::begin(found), std::end(found), truth.contact()) == 7);
  }
}

#if defined(__x86_64__)
// What runs is the faster one; a build that forgets the flags would pass every other test.
TEST(FilteredEngines, AreTwoWhereTheMachineHasAvx2) {
  const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  EXPECT_EQ(engines().size(), has_avx2 ? 2U : 1U);
}
#endif

}  // namespace
}  // namespace touchstone::filtered_tests
