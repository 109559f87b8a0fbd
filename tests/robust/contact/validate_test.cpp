// SPDX-License-Identifier: GPL-3.0-or-later
// Validation: each code, their precedence and messages, against every pair of edges in integers.
#include "robust/exact/validate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/lattice.h"
#include "experiments/cases/workloads/workload.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

using workloads::LatticePoint;

/// `code: message`, or `accepted`.
std::string verdict(const Loop& outer, const std::vector<Loop>& holes = {}) {
  const auto rejection = exact::validate(Polygon(outer, holes));
  return rejection ? std::string(to_string(rejection->code)) + ": " + rejection->message : "accepted";
}

Loop square_loop(double low, double high) { return {{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}}; }

TEST(Validate, NamesEdgesVerticesAndLoops) {
  EXPECT_EQ(verdict({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {5, 4, 0}}),
            "loop-meets-itself: the outer loop: edge 1 (vertices 1, 2) meets edge 3 (vertices 3, 0)");
  EXPECT_EQ(verdict({{0, 0, 0}, {4, 0, 0}, {4, 0, 1}, {4, 4, 0}, {0, 4, 0}}),
            "loop-meets-itself: the outer loop: edge 1 (vertices 1, 2) becomes a point when the polygon is projected "
            "along its dropped axis");
  EXPECT_EQ(verdict(square_loop(0, 9), {{{8, 4, 0}, {10, 4, 0}, {8, 5, 0}}}),
            "loops-meet: the outer loop and hole 0: edge 1 (vertices 1, 2) meets edge 4 (vertices 4, 5)");
  EXPECT_EQ(verdict(square_loop(0, 9), {square_loop(3, 6), {{10, 0, 0}, {11, 0, 0}, {11, 1, 0}}}),
            "hole-outside: hole 1: vertex 8 is not inside the outer loop");
  EXPECT_EQ(verdict({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}), "zero-normal: the outer loop: its Newell normal is zero");
}

TEST(Validate, AcceptsWhatTheContractAllows) {
  const Loop hole = square_loop(3, 6);
  EXPECT_EQ(verdict({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 6, 0}}), "accepted") << "straight runs";
  EXPECT_EQ(verdict(square_loop(0, 9), {hole, {{4, 4, 0}, {5, 4, 0}, {5, 5, 0}}}), "accepted") << "an island";
  EXPECT_EQ(verdict(square_loop(0, 9), {{hole.rbegin(), hole.rend()}}), "accepted") << "a reversed hole";
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
    EXPECT_FALSE(exact::validate(polygon)) << to_string(family);
    Loop loop;
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i) loop.push_back(polygon.vertex(i));
    std::swap(loop[10'000], loop[10'003]);
    const auto rejection = exact::validate(Polygon(loop));
    ASSERT_TRUE(rejection) << to_string(family);
    EXPECT_EQ(rejection->code, RejectionCode::LoopMeetsItself) << to_string(family);
  }
}

TEST(ValidateCases, RejectsLoopsThatMeetThemselves) {
  for (const Loop& loop :
       {Loop{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}, {2, 3, 0}},                        // runs back, level
        Loop{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 2, 0}, {0, 2, 0}},             // upright
        Loop{{0, 0, 0}, {4, 1, 0}, {4, 4, 0}, {4, -2, 0}, {0, -2, 0}},           // beyond its start
        Loop{{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {3, 0, 0}, {0, 4, 0}},             // a vertex on an edge
        Loop{{0, 0, 0}, {0, 6, 0}, {4, 6, 0}, {0, 3, 0}, {4, 0, 0}},             // on an upright one
        Loop{{0, 0, 0}, {6, 0, 0}, {3, 3, 0}, {6, 6, 0}, {0, 6, 0}, {3, 3, 0}},  // vertices coincide
        Loop{{0, 0, 0}, {6, 0, 0}, {6, 2, 0}, {4, 2, 0}, {4, 0, 0}, {2, 0, 0}, {2, 4, 0}, {0, 4, 0}}})  // edges overlap
    EXPECT_EQ(verdict(loop).rfind("loop-meets-itself: the outer loop: edge ", 0), 0U) << verdict(loop);
}

TEST(ValidateCases, RejectsLoopsThatTouch) {
  for (const Loop& hole : {Loop{{0, 4, 0}, {2, 3, 0}, {2, 5, 0}},             // its vertex on an edge
                           Loop{{0, 0, 0}, {2, 1, 0}, {1, 2, 0}},             // two vertices coincide
                           Loop{{0, 2, 0}, {0, 4, 0}, {2, 3, 0}},             // edges overlap
                           Loop{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}},  // the same loop
                           Loop{{4, 4, 0}, {12, 4, 0}, {4, 5, 0}}})           // crosses
    EXPECT_EQ(verdict(square_loop(0, 9), {hole}).rfind("loops-meet: the outer loop and hole 0: ", 0), 0U);
  EXPECT_EQ(verdict(square_loop(0, 9), {square_loop(2, 4), square_loop(5, 7), {{3, 3, 0}, {4, 3, 0}, {3, 3.5, 0}}})
                .rfind("loops-meet: hole 0 and hole 2: edge 5 (vertices 5, 6) meets edge ", 0),
            0U);
}

TEST(ValidateCases, RejectsAHoleAroundTheOuterLoopAndOneBesideIt) {
  EXPECT_EQ(verdict(square_loop(2, 4), {square_loop(0, 9)}),
            "hole-outside: hole 0: vertex 4 is not inside the outer loop");
  EXPECT_EQ(verdict(square_loop(2, 4), {square_loop(6, 9)}),
            "hole-outside: hole 0: vertex 4 is not inside the outer loop");
  const Loop notched{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {5, 9, 0}, {5, 3, 0}, {4, 3, 0}, {4, 9, 0}, {0, 9, 0}};
  EXPECT_EQ(verdict(notched, {{{4.2, 5, 0}, {4.8, 5, 0}, {4.5, 6, 0}}}),
            "hole-outside: hole 0: vertex 8 is not inside the outer loop");
}

// One polygon with all the faults; each is found once those before it are mended.
TEST(ValidateCases, NamesTheFirstReasonThatApplies) {
  const Loop line{{0, 0, 0}, {9, 0, 0}, {5, 0, 0}}, crossing{{1, 1, 0}, {3, 3, 0}, {3, 1, 0}, {1, 3, 0}};
  const Loop touching{{0, 4, 0}, {2, 4, 0}, {2, 5, 0}}, outside = square_loop(20, 21);
  EXPECT_EQ(verdict(line, {crossing, touching, outside}), "zero-normal: the outer loop: its Newell normal is zero");
  EXPECT_EQ(verdict(square_loop(0, 9), {outside, touching, crossing}),
            "loop-meets-itself: hole 2: edge 11 (vertices 11, 12) meets edge 13 (vertices 13, 14)");
  EXPECT_EQ(verdict(square_loop(0, 9), {outside, touching}).substr(0, 10), "loops-meet");
  EXPECT_EQ(verdict(square_loop(0, 9), {outside}).substr(0, 12), "hole-outside");
}

// Left out is the coordinate that the largest component of the normal names: loops may well cross along another.
TEST(ValidateCases, LooksAlongTheDroppedAxis) {
  const Loop saddle{{0, 0, 0}, {4, 0, 1}, {4, 4, 0}, {0, 4, 1}};
  for (int times = 0; times < 3; ++times) {
    Loop turned;
    for (const Eigen::Vector3d& v : saddle)
      turned.emplace_back(v[(3 - times) % 3], v[(4 - times) % 3], v[(5 - times) % 3]);
    EXPECT_EQ(verdict(turned), "accepted");
  }
}

// The orientation of points 2^-1074 or 1e300 apart is that of points 1 apart.
TEST(ValidateCases, DecidesAtTheEndsOfTheDoubles) {
  const Loop crossing{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 3, 0}};
  for (const int exponent : {-1074, 1020}) {
    const auto at = [&](const Loop& loop) {
      return loops_of(scaled({"", {{0, 0, 0}, 0}, Polygon(loop)}, exponent).polygon)[0];
    };
    EXPECT_EQ(verdict(at(crossing)), verdict(crossing));
    EXPECT_EQ(verdict(at(square_loop(1, 9)), {at(square_loop(2, 4))}), "accepted");
  }
}

// One double decides: vertex 3 a double above, on, or below the line through an edge.
TEST(ValidateCases, DecidesByOneDouble) {
  const auto with = [](double y) { return verdict({{0, 0, 0}, {3, 1, 0}, {3, 4, 0}, {1.5, y, 0}, {0, 4, 0}}); };
  EXPECT_EQ(with(std::nextafter(0.5, 1)), "accepted");
  EXPECT_NE(with(0.5), "accepted");
  EXPECT_NE(with(std::nextafter(0.5, 0)), "accepted");
}

// ---- Against the definition, on small grids ----

struct GridLoops {
  std::vector<workloads::LatticeLoop> loops;
  int axis;

  /// (x, y) on the plane that rises by x - 2 y along `axis`, which is not the axis dropped: the normal is (-1, 2, 1).
  [[nodiscard]] std::vector<Loop> in_space() const {
    std::vector<Loop> result;
    for (const auto& loop : loops) {
      result.emplace_back();
      for (const auto& [x, y] : loop) {
        Eigen::Vector3d v;
        v[axis] = static_cast<double>(x - 2 * y);
        v[(axis + 1) % 3] = static_cast<double>(x);
        v[(axis + 2) % 3] = static_cast<double>(y);
        result.back().push_back(v);
      }
    }
    return result;
  }
};

void showValue(const GridLoops& drawn, std::ostream& out) {
  for (const auto& loop : drawn.loops) {
    for (const auto& [x, y] : loop) out << " (" << x << ", " << y << ")";
    out << ";";
  }
  out << " axis " << drawn.axis;
}

struct Segment {
  LatticePoint a, b;
};

int side(const Segment& s, LatticePoint p) {
  const std::int64_t area = cross(s.b - s.a, p - s.a);
  return area > 0 ? 1 : (area < 0 ? -1 : 0);
}

bool on(const Segment& s, LatticePoint p) { return side(s, p) == 0 && dot(p - s.a, p - s.b) <= 0; }

bool share_a_point(const Segment& s, const Segment& t) {
  return on(s, t.a) || on(s, t.b) || on(t, s.a) || on(t, s.b) ||
         (side(s, t.a) * side(s, t.b) < 0 && side(t, s.a) * side(t, s.b) < 0);
}

Segment edge(const workloads::LatticeLoop& loop, std::size_t i) { return {loop[i], loop[(i + 1) % loop.size()]}; }

/// Edges of one loop: neighbours share just the vertex between them, others nothing.
bool meet(const workloads::LatticeLoop& loop, std::size_t i, std::size_t j) {
  const Segment s = edge(loop, i), t = edge(loop, j);
  if ((i + 1) % loop.size() == j) return on(s, t.b) || on(t, s.a);
  if ((j + 1) % loop.size() == i) return on(t, s.b) || on(s, t.a);
  return share_a_point(s, t);
}

bool meets_itself(const workloads::LatticeLoop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (meet(loop, i, j)) return true;
  return false;
}

bool meet(const workloads::LatticeLoop& first, const workloads::LatticeLoop& second) {
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j)
      if (share_a_point(edge(first, i), edge(second, j))) return true;
  return false;
}

/// The code that the definitions give.
std::optional<RejectionCode> code_by_definition(const std::vector<workloads::LatticeLoop>& loops) {
  if (twice_area(loops[0]) == 0) return RejectionCode::ZeroNormal;
  if (std::any_of(loops.begin(), loops.end(), meets_itself)) return RejectionCode::LoopMeetsItself;
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (meet(loops[i], loops[j])) return RejectionCode::LoopsMeet;
  for (std::size_t i = 1; i < loops.size(); ++i)
    if (!workloads::contains({loops[0], {}}, loops[i][0])) return RejectionCode::HoleOutside;
  return std::nullopt;
}

/// The two edges that a message names really meet.
bool names_a_meeting(const std::string& message, const std::vector<workloads::LatticeLoop>& loops) {
  std::vector<std::pair<std::size_t, std::size_t>> edges;  // loop, and edge in it
  for (std::size_t at = message.find("edge "); at != std::string::npos; at = message.find("edge ", at + 1)) {
    std::size_t i = std::stoul(message.substr(at + 5)), loop = 0;
    while (i >= loops[loop].size()) i -= loops[loop++].size();
    edges.emplace_back(loop, i);
  }
  if (edges.size() != 2) return false;
  const auto [first, i] = edges[0];
  const auto [second, j] = edges[1];
  return first == second ? meet(loops[first], i, j) : share_a_point(edge(loops[first], i), edge(loops[second], j));
}

/// Up to three loops of points on a grid of 5 to 12 lines each way; neighbours differ.
rc::Gen<GridLoops> grid_loops() {
  return rc::gen::exec([] {
    GridLoops drawn{{}, *rc::gen::inRange(0, 3)};
    const std::int64_t high = *rc::gen::resize(100, rc::gen::inRange(4, 12));
    const auto loops = *rc::gen::inRange<std::size_t>(1, 4);
    while (drawn.loops.size() < loops) {
      workloads::LatticeLoop loop;
      const auto count = *rc::gen::resize(100, rc::gen::inRange<std::size_t>(3, loops == 1 ? 9 : 5));
      while (loop.size() < count) {
        const LatticePoint p{*rc::gen::resize(100, rc::gen::inRange<std::int64_t>(0, high + 1)),
                             *rc::gen::resize(100, rc::gen::inRange<std::int64_t>(0, high + 1))};
        if (loop.empty() || (p != loop.back() && p != loop.front())) loop.push_back(p);
      }
      drawn.loops.push_back(std::move(loop));
    }
    return drawn;
  });
}

RC_GTEST_PROP(ValidateAgainstEveryPair, GivesTheCodeOfTheDefinitionAndNamesEdgesThatMeet, ()) {
  for (const GridLoops& drawn : *rc::gen::container<std::vector<GridLoops>>(20, grid_loops())) {
    const auto expected = code_by_definition(drawn.loops);
    const auto rejection = exact::validate(polygon_of(drawn.in_space()));
    RC_ASSERT(rejection.has_value() == expected.has_value());
    if (!rejection) continue;
    RC_ASSERT(to_string(rejection->code) == to_string(*expected));
    if (*expected == RejectionCode::LoopMeetsItself || *expected == RejectionCode::LoopsMeet)
      RC_ASSERT(names_a_meeting(rejection->message, drawn.loops));
  }
}

}  // namespace
}  // namespace touchstone::contact_tests
