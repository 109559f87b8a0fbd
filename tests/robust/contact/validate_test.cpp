// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust/exact/validate.h"

#include <gtest/gtest.h>

#include "experiments/cases/workloads/workload.h"

namespace touchstone::contact_tests {
namespace {

using exact::validate;

std::string verdict(const Loop& outer, const std::vector<Loop>& holes = {}) {
  const auto rejection = validate(Polygon(outer, holes));
  return rejection ? std::string(to_string(rejection->code)) + ": " + rejection->message : "accepted";
}

const Loop kSquare{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}};
const Loop kHole{{3, 3, 0}, {6, 3, 0}, {6, 6, 0}, {3, 6, 0}};

TEST(Validate, NamesEdgesVerticesAndLoops) {
  EXPECT_EQ(verdict({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {5, 4, 0}}),
            "loop-meets-itself: the outer loop: edge 1 (vertices 1, 2) meets edge 3 (vertices 3, 0)");
  EXPECT_EQ(verdict({{0, 0, 0}, {4, 0, 0}, {4, 0, 1}, {4, 4, 0}, {0, 4, 0}}),
            "loop-meets-itself: the outer loop: edge 1 (vertices 1, 2) becomes a point when the polygon is projected "
            "along its dropped axis");
  EXPECT_EQ(verdict(kSquare, {{{8, 4, 0}, {10, 4, 0}, {8, 5, 0}}}),
            "loops-meet: the outer loop and hole 0: edge 1 (vertices 1, 2) meets edge 4 (vertices 4, 5)");
  EXPECT_EQ(verdict(kSquare, {kHole, {{10, 0, 0}, {11, 0, 0}, {11, 1, 0}}}),
            "hole-outside: hole 1: vertex 8 is not inside the outer loop");
  EXPECT_EQ(verdict({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}), "zero-normal: the outer loop: its Newell normal is zero");
}

TEST(Validate, AcceptsWhatTheContractAllows) {
  EXPECT_EQ(verdict({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 6, 0}}), "accepted") << "straight runs";
  EXPECT_EQ(verdict(kSquare, {kHole, {{4, 4, 0}, {5, 4, 0}, {5, 5, 0}}}), "accepted") << "an island";
  EXPECT_EQ(verdict(kSquare, {{kHole.rbegin(), kHole.rend()}}), "accepted") << "a reversed hole";
  EXPECT_EQ(verdict({{0, 0, 0}, {0, 1, 7}, {0, 5, 7}, {0, 5, 0}}), "accepted") << "upright";
}

// The wedge of edges 3 and 4 lies between edges 0 and 2 until it ends at vertex 4; they cross behind it.
TEST(Validate, FindsACrossingOfEdgesThatBecomeNeighboursLate) {
  EXPECT_EQ(verdict({{0, 0, 0}, {10, 6, 0}, {10, 0, 0}, {0, 6, 0}, {2, 3, 0}}),
            "loop-meets-itself: the outer loop: edge 0 (vertices 0, 1) meets edge 2 (vertices 2, 3)");
}

TEST(Validate, AcceptsLargePolygonsAndFindsOneCrossingInThem) {
  for (const auto family : {workloads::Family::Star, workloads::Family::Comb, workloads::Family::Spiral}) {
    const Polygon polygon = workloads::sample({.family = family, .vertices = 20'000}, 1, 0).polygon;
    EXPECT_FALSE(validate(polygon)) << to_string(family);
    Loop loop;
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i) loop.push_back(polygon.vertex(i));
    std::swap(loop[10'000], loop[10'003]);
    const auto rejection = validate(Polygon(loop));
    ASSERT_TRUE(rejection) << to_string(family);
    EXPECT_EQ(rejection->code, RejectionCode::LoopMeetsItself) << to_string(family);
  }
}

}  // namespace
}  // namespace touchstone::contact_tests
