// SPDX-License-Identifier: GPL-3.0-or-later
// Exact answers and validation under every rounding mode and with subnormals flushed, and what they leave behind.
#include <gtest/gtest.h>

#include <cfenv>
#include <string>
#include <vector>

#include "robust/exact/detail/edge_sweep.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/hand_cases.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

/// Samples, off their planes too; hand cases as normal and as subnormal numbers, and near the largest.
std::vector<Case> cases() {
  std::vector<Case> result;
  for (const HandCase& c : hand_cases())
    for (const int exponent : {0, -1074, 1020}) result.push_back(scaled(c.given, exponent));
  for (const auto family : workloads::all_families()) {
    const workloads::Workload workload{.family = family,
                                       .placement = workloads::Placement::Rotated,
                                       .ball = workloads::BallPlace::NearEdge,
                                       .vertices = 12,
                                       .holes = 1};
    const workloads::Sample sample = workloads::sample(workload, 2008, 0);
    result.push_back({sample.id, sample.ball, sample.polygon});
  }
  result.push_back({"thirds", {{2, -1, 3}, 3}, Polygon({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 1, 1}})});
  return result;
}

// Whatever flags stand before a call stand after it, and no others.
TEST(FloatingEnvironment, ChangesNoExactAnswerAndIsLeftAsFound) {
  for (const Case& c : cases()) {
    const Answer expected = exact::answer(c.ball, c.polygon);
    const auto axis = exact::detail::dropped_axis(c.polygon);
    for (const State& state : kStates)
      for (const int flags : {0, FE_DIVBYZERO, kFlags}) {
        Answer answer;
        bool same = false, left_as_found = false;
        {
          const Environment changed(state);
          std::feraiseexcept(flags);
          const exact::PreparedPolygon polygon(c.polygon);
          answer = exact::answer(c.ball, c.polygon);
          same = !exact::validate(c.polygon) && exact::detail::dropped_axis(c.polygon) == axis &&
                 exact::contact(c.ball, polygon) == expected.contact() &&
                 exact::relation(c.ball, polygon) == expected.relation &&
                 exact::plane_side(c.ball, polygon) == expected.plane &&
                 exact::foot(c.ball, polygon) == expected.foot &&
                 exact::edges_hit(c.ball, polygon) == expected.edges_hit;
          left_as_found = changed.left_as_found(flags);
        }
        EXPECT_EQ(answer, expected) << c.id << ", " << state;
        EXPECT_TRUE(same) << c.id << ", " << state;
        EXPECT_TRUE(left_as_found) << c.id << ", " << state << ", flags " << flags;
      }
  }
}

/// `accepted`, or the message.
std::string message_about(const Polygon& polygon) {
  const auto rejection = exact::validate(polygon);
  return rejection ? rejection->message : "accepted";
}

// Crossings and touchings of loops as tall as a few least doubles vanish where subnormals are flushed.
TEST(FloatingEnvironment, ChangesNoValidation) {
  std::vector<Polygon> polygons;
  for (const Case& c : cases()) polygons.push_back(c.polygon);
  for (const int exponent : {0, -1074, 1020}) {
    const auto add = [&](const Loop& outer, const std::vector<Loop>& holes = {}) {
      polygons.push_back(scaled({"", {{0, 0, 0}, 0}, Polygon(outer, holes)}, exponent).polygon);
    };
    add({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 3, 0}});                            // crosses itself
    add({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}});                            // touches itself
    add({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}});                                       // on a line
    add({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{{1, 1, 0}, {4, 4, 0}, {1, 3, 0}}});  // loops touch
  }
  for (const Polygon& polygon : polygons) {
    const std::string expected = message_about(polygon);
    for (const State& state : kStates) {
      const Environment changed(state);
      EXPECT_EQ(message_about(polygon), expected) << state;
    }
  }
}

}  // namespace
}  // namespace touchstone::contact_tests
