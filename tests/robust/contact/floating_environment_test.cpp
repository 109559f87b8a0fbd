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

TEST(FloatingEnvironment, ChangesNoExactAnswer) {
  for (const Case& c : cases()) {
    const Answer expected = exact::answer(c.ball, c.polygon);
    for (const int mode : kModes)
      for (const unsigned flush : kFlushes) {
        const Answer answer = [&] {
          const Environment changed(mode, flush);
          return exact::answer(c.ball, c.polygon);
        }();
        EXPECT_EQ(answer, expected) << c.id << ", rounding mode " << mode << ", flush bits " << flush;
      }
  }
}

TEST(FloatingEnvironment, ChangesNoSingleExactAnswer) {
  for (const Case& c : cases()) {
    const Answer expected = exact::answer(c.ball, c.polygon);
    for (const int mode : kModes) {
      const Environment changed(mode, Environment::kBoth);
      const exact::PreparedPolygon polygon(c.polygon);
      const bool same = exact::contact(c.ball, polygon) == expected.contact() &&
                        exact::relation(c.ball, polygon) == expected.relation &&
                        exact::plane_side(c.ball, polygon) == expected.plane &&
                        exact::foot(c.ball, polygon) == expected.foot &&
                        exact::edges_hit(c.ball, polygon) == expected.edges_hit;
      EXPECT_TRUE(same) << c.id << ", rounding mode " << mode;
    }
  }
}

/// `accepted`, or the message.
std::string verdict(const Polygon& polygon) {
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
    const std::string expected = verdict(polygon);
    for (const int mode : kModes) {
      const Environment changed(mode, Environment::kBoth);
      EXPECT_EQ(verdict(polygon), expected) << "rounding mode " << mode;
    }
  }
}

// Whatever flags stand before a call stand after it, and no others.
TEST(FloatingEnvironment, IsLeftAsFound) {
  for (const Case& c : cases())
    for (const int mode : kModes)
      for (const int flags : {0, FE_DIVBYZERO, kFlags}) {
        const Environment changed(mode, Environment::kBoth);
        const unsigned modes = Environment::modes();
        std::feclearexcept(FE_ALL_EXCEPT);
        std::feraiseexcept(flags);
        const bool accepted = !exact::validate(c.polygon).has_value();
        const Answer answer = exact::answer(c.ball, c.polygon);
        const auto axis = exact::detail::dropped_axis(c.polygon);
        const int flags_after = std::fetestexcept(kFlags);
        EXPECT_TRUE(accepted && axis && answer.contact() == exact::contact(c.ball, c.polygon));
        EXPECT_EQ(flags_after, flags) << c.id;
        EXPECT_EQ(Environment::modes(), modes) << c.id;
      }
}

}  // namespace
}  // namespace touchstone::contact_tests
