// SPDX-License-Identifier: GPL-3.0-or-later
// Filtered answers under every rounding mode, with and without subnormals flushed, and what they leave behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "experiments/cases/workloads/adversarial/case.h"
#include "geometry/detail/floating_point_state.h"
#include "robust/exact/exact.h"
#include "tests/robust/filtered/wrong_answers.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/hand_cases.h"
#include "tests/robust/support/hard_cases.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;

struct Asked {
  Case given;
  Answer expected;
};

/// At all scales by hand, then the hardest of the soak, with the answers that exact gives in the usual state.
const std::vector<Asked>& cases() {
  static const std::vector<Asked> all = [] {
    std::vector<Case> drawn;
    for (const auto& c : hand_cases())
      for (const int exponent : {0, -1074, 1019, -500, 480}) drawn.push_back(scaled(c.given, exponent));
    const double least = std::numeric_limits<double>::denorm_min();
    for (const double unit : {1e300, 1e-300, least}) {
      const Polygon triangle({{0, 0, 0}, {4 * unit, 0, 0}, {0, 4 * unit, unit}});
      for (const double radius : {0.0, least, unit, 1e300})
        drawn.push_back({"unit " + std::to_string(std::ilogb(unit)), {{unit, unit, unit}, radius}, triangle});
    }
    drawn.push_back({"least and largest",
                     {{least, 1e300, -1e-300}, 1e300},
                     Polygon({{1e300, 0, 0}, {0, 1e300, least}, {0, 0, 1}})});
    drawn.push_back({"thirds", {{2, -1, 3}, 3}, Polygon({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 1, 1}})});
    for (std::uint64_t index = 0; index < 20 * TOUCHSTONE_SAMPLES; ++index) {
      workloads::adversarial::Case c = workloads::adversarial::draw_case(2008, index);
      drawn.push_back({"soak-s2008-i" + std::to_string(index), c.ball, std::move(c.polygon)});
    }
    std::vector<Asked> with_answers;
    for (Case& c : drawn) {
      const Answer answer = exact::answer(c.ball, c.polygon);
      with_answers.push_back({std::move(c), answer});
    }
    return with_answers;
  }();
  return all;
}

/// Every question, all overloads; the names of those that go wrong.
std::string all_wrong_answers(const Asked& asked, const filtered::PreparedPolygon& prepared) {
  const Case& c = asked.given;
  const Answer& expected = asked.expected;
  std::string wrong = wrong_answers(c.ball, prepared, expected);
  const auto expect = [&](bool right, const char* question) {
    if (!right) wrong += std::string(" ") + question;
  };
  filtered::StageCounts counts;
  expect(filtered::answer(c.ball, prepared, counts) == expected, "answer-counted");
  const Ball balls[] = {c.ball, c.ball, c.ball};
  bool touches[3] = {};
  filtered::contact(balls, prepared, touches);
  expect(std::count(touches, touches + 3, expected.contact()) == 3, "batch-of-balls");
  if (c.polygon.vertex_count() != 3) return wrong;
  const Triangle triangle = triangle_of(c.polygon);
  expect(filtered::contact(c.ball, triangle) == expected.contact(), "triangle");
  const Triangle triangles[] = {triangle, triangle, triangle};
  filtered::contact(c.ball, triangles, touches);
  expect(std::count(touches, touches + 3, expected.contact()) == 3, "batch-of-triangles");
  const filtered::ClosestPoint closest{expected.nearest, expected.point, expected.distance, expected.contact_normal};
  expect(filtered::closest(c.ball.center, triangle) == closest, "closest");
  return wrong;
}

TEST(FilteredEnvironment, ChangesNoAnswer) {
  for (const Asked& asked : cases()) {
    const filtered::PreparedPolygon prepared(asked.given.polygon);
    for (const State& state : kStates) {
      const std::string wrong = [&] {
        const Environment changed(state);
        return all_wrong_answers(asked, prepared);
      }();
      EXPECT_EQ(wrong, "") << asked.given.id << ", " << state;
    }
  }
}

TEST(FilteredEnvironment, ChangesNoPreparation) {
  for (const Asked& asked : cases())
    for (const State& state : kStates) {
      const filtered::PreparedPolygon prepared = [&] {
        const Environment changed(state);
        return filtered::PreparedPolygon(asked.given.polygon);
      }();
      EXPECT_EQ(all_wrong_answers(asked, prepared), "") << asked.given.id << ", " << state;
    }
}

/// Sets flags without an operation that could set others.
void set_flags(int flags) {
  std::feclearexcept(FE_ALL_EXCEPT);
  std::feraiseexcept(flags);
  std::feclearexcept(FE_ALL_EXCEPT & ~flags);
}

#if defined(__SSE2__)
// Then questions of one sign in double-doubles leave it alone; whatever flags stand.
TEST(FilteredEnvironment, IsFoundToNeedNothingOnlyToNearestWithSubnormalNumbers) {
  for (const State& state : kStates)
    for (const int flags : {0, kFlags}) {
      const bool found = [&] {
        const Environment changed(state);
        set_flags(flags);
        return FloatingPointState::is_found();
      }();
      EXPECT_EQ(found, state.mode == FE_TONEAREST && state.flush == Environment::kKeep) << state << ", flags " << flags;
    }
}
#endif

// Whatever flags stand before a call stand after it, and no others: each question by itself.
TEST(FilteredEnvironment, IsLeftAsFound) {
  for (const Asked& asked : cases()) {
    const auto& id = asked.given.id;
    const Polygon& polygon = asked.given.polygon;
    const Ball& ball = asked.given.ball;
    const filtered::PreparedPolygon prepared(polygon);
    for (const int mode : kModes)
      for (const State& state : {State{mode, Environment::kKeep}, {mode, Environment::kBoth}})
        for (const int flags : {0, FE_DIVBYZERO, FE_INVALID, FE_OVERFLOW, kFlags}) {
          const Environment changed(state);
          const auto leaves = [&](const auto& call, const char* question) {
            set_flags(flags);
            call();
            const bool left_as_found = changed.left_as_found(flags);
            EXPECT_TRUE(left_as_found) << question << " of " << id << ", " << state << ", flags " << flags;
          };
          leaves([&] { (void)filtered::contact(ball, prepared); }, "contact");
          leaves([&] { (void)filtered::relation(ball, prepared); }, "relation");
          leaves([&] { (void)filtered::plane_side(ball, prepared); }, "plane_side");
          leaves([&] { (void)filtered::foot(ball, prepared); }, "foot");
          leaves([&] { (void)filtered::edges_hit(ball, prepared); }, "edges_hit");
          leaves([&] { (void)filtered::answer(ball, prepared); }, "answer");
          leaves([&] { const filtered::PreparedPolygon again(polygon); }, "preparation");
          leaves([&] { (void)filtered::contact(ball, polygon); }, "contact, unprepared");
          leaves(
              [&] {
                const Ball balls[] = {ball, ball, ball, ball, ball};
                bool touches[5];
                filtered::contact(balls, prepared, touches);
              },
              "a batch of balls");
          if (polygon.vertex_count() != 3) continue;
          const Triangle triangle = triangle_of(polygon);
          leaves([&] { (void)filtered::contact(ball, triangle); }, "contact with a triangle");
          leaves([&] { (void)filtered::closest(ball.center, triangle); }, "closest point");
          leaves(
              [&] {
                const Triangle triangles[] = {triangle, triangle, triangle, triangle, triangle};
                bool touches[5];
                filtered::contact(ball, triangles, touches);
              },
              "a batch of triangles");
        }
  }
}

#if defined(__GLIBC__)
// A trap would end this program.
TEST(FilteredEnvironment, MayTrapInvalidOverflowAndDivisionByZero) {
  for (const Asked& asked : cases()) {
    const Environment changed(FE_TONEAREST, Environment::kKeep);
    ASSERT_NE(feenableexcept(kFlags), -1);
    const std::string wrong = all_wrong_answers(asked, filtered::PreparedPolygon(asked.given.polygon));
    fedisableexcept(kFlags);
    EXPECT_EQ(wrong, "") << asked.given.id;
  }
}
#endif

// What is refused leaves the state as found, too.
TEST(FilteredEnvironment, IsLeftAsFoundByARefusal) {
  const Polygon line({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}});
  for (const int mode : kModes) {
    const Environment changed(mode, Environment::kBoth);
    set_flags(FE_OVERFLOW);
    EXPECT_THROW(const filtered::PreparedPolygon prepared(line), Rejected);
    EXPECT_TRUE(changed.left_as_found(FE_OVERFLOW));
  }
}

}  // namespace
}  // namespace touchstone::filtered_tests
