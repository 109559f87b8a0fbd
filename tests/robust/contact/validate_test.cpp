// SPDX-License-Identifier: GPL-3.0-or-later
// Validation: each code, their precedence and messages, against every pair of edges in integers.
#include "robust/exact/validate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
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
            "loop-meets-itself: the outer loop: edge 1 (vertices 1, 2) crosses edge 3 (vertices 3, 0)");
  EXPECT_EQ(verdict({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 2, 0}, {0, 2, 0}}),
            "loop-meets-itself: the outer loop: edge 1 (vertices 1, 2) overlaps edge 2 (vertices 2, 3)");
  EXPECT_EQ(verdict({{0, 0, 0}, {4, 0, 0}, {4, 0, 1}, {4, 4, 0}, {0, 4, 0}}),
            "loop-meets-itself: the outer loop: edge 1 (vertices 1, 2) becomes a point when the polygon is projected "
            "along its dropped axis");
  EXPECT_EQ(verdict(square_loop(0, 9), {{{8, 4, 0}, {10, 4, 0}, {8, 5, 0}}}),
            "loops-meet: the outer loop and hole 0: edge 1 (vertices 1, 2) crosses edge 4 (vertices 4, 5)");
  EXPECT_EQ(verdict(square_loop(0, 9), {square_loop(3, 6), {{10, 0, 0}, {11, 0, 0}, {11, 1, 0}}}),
            "hole-outside: hole 1: edge 8 (vertices 8, 9) lies outside the outer loop");
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
            "loop-meets-itself: the outer loop: edge 0 (vertices 0, 1) crosses edge 2 (vertices 2, 3)");
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
        Loop{{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {3, 0, 0}, {0, -5, 0}},            // crosses an edge at a vertex
        Loop{{0, 0, 0}, {0, 6, 0}, {4, 6, 0}, {0, 3, 0}, {-5, 0, 0}},            // an upright one
        Loop{{0, 0, 0}, {6, 6, 0}, {2, 6, 0}, {3, 3, 0}, {3, 0, 0}},             // one that ends beyond the vertex
        Loop{{0, 0, 0}, {3, 3, 0}, {6, 6, 0}, {7, 0, 0}, {3, 3, 0}, {0, 8, 0}},  // where vertices coincide
        Loop{{0, 0, 0}, {6, 0, 0}, {6, 2, 0}, {4, 2, 0}, {4, 0, 0}, {2, 0, 0}, {2, 4, 0}, {0, 4, 0}}})  // edges overlap
    EXPECT_EQ(verdict(loop).rfind("loop-meets-itself: the outer loop: edge ", 0), 0U) << verdict(loop);
}

TEST(ValidateCases, RejectsLoopsThatCrossOrOverlap) {
  for (const Loop& hole : {Loop{{0, 4, 0}, {2, 3, 0}, {-2, 6, 0}},            // crosses an edge at its vertex
                           Loop{{0, 0, 0}, {2, 1, 0}, {-1, 2, 0}},            // a corner at its vertex
                           Loop{{0, 2, 0}, {0, 4, 0}, {2, 3, 0}},             // edges overlap
                           Loop{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}},  // the same loop
                           Loop{{4, 4, 0}, {12, 4, 0}, {4, 5, 0}}})           // crosses
    EXPECT_EQ(verdict(square_loop(0, 9), {hole}).rfind("loops-meet: the outer loop and hole 0: ", 0), 0U);
  EXPECT_EQ(verdict(square_loop(0, 9), {square_loop(2, 4), square_loop(5, 7), {{3, 3, 0}, {5, 3, 0}, {3, 3.5, 0}}})
                .rfind("loops-meet: hole 0 and hole 2: edge 5 (vertices 5, 6) crosses edge ", 0),
            0U);
}

TEST(ValidateCases, AcceptsLoopsThatTouchWithoutCrossing) {
  const Loop square = square_loop(0, 9);
  EXPECT_EQ(verdict({{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {3, 0, 0}, {0, 4, 0}}), "accepted") << "a vertex on an edge";
  EXPECT_EQ(verdict({{0, 0, 0}, {0, 6, 0}, {4, 6, 0}, {0, 3, 0}, {4, 0, 0}}), "accepted") << "on an upright edge";
  EXPECT_EQ(verdict({{0, 0, 0}, {6, 0, 0}, {3, 3, 0}, {6, 6, 0}, {0, 6, 0}, {3, 3, 0}}), "accepted") << "a pinch";
  for (const Loop& hole :
       {Loop{{0, 4, 0}, {2, 3, 0}, {2, 5, 0}}, Loop{{0, 0, 0}, {2, 1, 0}, {1, 2, 0}},
        Loop{{4.5, 0, 0}, {9, 4.5, 0}, {4.5, 9, 0}, {0, 4.5, 0}}, Loop{{0, 0, 0}, {4, 2, 0}, {9, 9, 0}, {2, 4, 0}}})
    EXPECT_EQ(verdict(square, {hole}), "accepted");
  EXPECT_EQ(verdict(square, {{{1, 1, 0}, {4, 1, 0}, {4, 4, 0}}, {{4, 4, 0}, {8, 4, 0}, {8, 8, 0}}}), "accepted");
  EXPECT_EQ(verdict(square, {square_loop(1, 8), {{1, 1, 0}, {8, 4, 0}, {8, 5, 0}}}),
            "loops-meet: hole 0 and hole 1: edge 5 (vertices 5, 6) overlaps edge 9 (vertices 9, 10)");
  EXPECT_EQ(verdict(square, {square_loop(1, 8), {{1, 1, 0}, {8, 4, 0}, {7, 5, 0}}}), "accepted") << "an island";
  EXPECT_EQ(verdict(square, {{{9, 3, 0}, {12, 2, 0}, {12, 4, 0}}}),
            "hole-outside: hole 0: edge 4 (vertices 4, 5) lies outside the outer loop");
}

TEST(ValidateCases, RejectsAHoleAroundTheOuterLoopAndOneBesideIt) {
  EXPECT_EQ(verdict(square_loop(2, 4), {square_loop(0, 9)}),
            "hole-outside: hole 0: edge 4 (vertices 4, 5) lies outside the outer loop");
  EXPECT_EQ(verdict(square_loop(2, 4), {square_loop(6, 9)}),
            "hole-outside: hole 0: edge 4 (vertices 4, 5) lies outside the outer loop");
  const Loop notched{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {5, 9, 0}, {5, 3, 0}, {4, 3, 0}, {4, 9, 0}, {0, 9, 0}};
  EXPECT_EQ(verdict(notched, {{{4.2, 5, 0}, {4.8, 5, 0}, {4.5, 6, 0}}}),
            "hole-outside: hole 0: edge 8 (vertices 8, 9) lies outside the outer loop");
}

// One polygon with all the faults; each is found once those before it are mended.
TEST(ValidateCases, NamesTheFirstReasonThatApplies) {
  const Loop line{{0, 0, 0}, {9, 0, 0}, {5, 0, 0}}, crossing{{1, 1, 0}, {3, 3, 0}, {3, 1, 0}, {1, 3, 0}};
  const Loop meeting{{-1, 4, 0}, {2, 4, 0}, {2, 5, 0}}, outside = square_loop(20, 21);
  EXPECT_EQ(verdict(line, {crossing, meeting, outside}), "zero-normal: the outer loop: its Newell normal is zero");
  EXPECT_EQ(verdict(square_loop(0, 9), {outside, meeting, crossing}),
            "loop-meets-itself: hole 2: edge 11 (vertices 11, 12) crosses edge 13 (vertices 13, 14)");
  EXPECT_EQ(verdict(square_loop(0, 9), {outside, meeting}).substr(0, 10), "loops-meet");
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
  EXPECT_EQ(with(0.5), "accepted");
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

Segment edge(const workloads::LatticeLoop& loop, std::size_t i) { return {loop[i], loop[(i + 1) % loop.size()]}; }

/// Do they share more than a point?
bool overlap(const Segment& s, const Segment& t) {
  if (side(s, t.a) != 0 || side(s, t.b) != 0) return false;
  const std::int64_t start = dot(t.a - s.a, s.b - s.a), end = dot(t.b - s.a, s.b - s.a);
  return std::min(std::max(start, end), dot(s.b - s.a, s.b - s.a)) > std::max<std::int64_t>(std::min(start, end), 0);
}

/// A loop on its way through a point of an edge: in at one vertex, out at the other.
struct Run {
  LatticePoint at, in, out;
  std::size_t vertex;  // the number of the vertex at the point; of the edge, beyond all vertices, if there is none
};

Run run(const workloads::LatticeLoop& loop, std::size_t i, LatticePoint p) {
  const std::size_t n = loop.size();
  if (p == loop[i]) return {p, loop[(i + n - 1) % n], loop[(i + 1) % n], i};
  if (p == loop[(i + 1) % n]) return {p, loop[i], loop[(i + 2) % n], (i + 1) % n};
  return {p, loop[i], loop[(i + 1) % n], n + i};
}

/// Does the direction lie within the sector to the right of the run?
bool is_right(const Run& r, LatticePoint p) {
  const LatticePoint in = r.in - r.at, out = r.out - r.at, to = p - r.at;
  const std::int64_t turn = cross(in, out);
  if (turn == 0) return cross(in, to) > 0;
  return turn > 0 ? cross(in, to) > 0 && cross(to, out) > 0 : !(cross(out, to) > 0 && cross(to, in) > 0);
}

/// Edges meet that overlap, cross, or belong to runs that cross at a point that they share.
bool meet(const workloads::LatticeLoop& first, std::size_t i, const workloads::LatticeLoop& second, std::size_t j) {
  const Segment s = edge(first, i), t = edge(second, j);
  if (overlap(s, t) || (side(s, t.a) * side(s, t.b) < 0 && side(t, s.a) * side(t, s.b) < 0)) return true;
  return std::ranges::any_of(std::array{s.a, s.b, t.a, t.b}, [&](LatticePoint p) {
    if (!on(s, p) || !on(t, p)) return false;
    const Run here = run(first, i, p), other = run(second, j, p);
    return (&first != &second || here.vertex != other.vertex) && is_right(here, other.in) != is_right(here, other.out);
  });
}

bool meet(const workloads::LatticeLoop& first, const workloads::LatticeLoop& second) {
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < (&first == &second ? i : second.size()); ++j)
      if (meet(first, i, second, j)) return true;
  return false;
}

/// Do two loops, or two runs of one loop, share a point?
bool touch(const std::vector<workloads::LatticeLoop>& loops) {
  for (const auto& first : loops)
    for (const auto& second : loops)
      for (std::size_t i = 0; i < first.size(); ++i)
        for (std::size_t j = 0; j < second.size(); ++j)
          if (on(edge(second, j), first[i]) && (&first != &second || run(second, j, first[i]).vertex != i)) return true;
  return false;
}

/// Does the hole begin outside? No edge of the outer loop comes nearer to the hole's first vertex, on the hole's first
/// edge, than 1 / 288 of that edge.
bool begins_outside(const workloads::LatticeLoop& outer, const workloads::LatticeLoop& hole) {
  constexpr std::int64_t kParts = 1024;
  const auto scaled_up = [](LatticePoint p) { return LatticePoint{kParts * p.x, kParts * p.y}; };
  workloads::LatticeLoop scaled;
  for (const LatticePoint p : outer) scaled.push_back(scaled_up(p));
  return !workloads::contains({scaled, {}}, scaled_up(hole[0]) + (hole[1] - hole[0]));
}

/// The code that the definitions give.
std::optional<RejectionCode> code_by_definition(const std::vector<workloads::LatticeLoop>& loops) {
  if (twice_area(loops[0]) == 0) return RejectionCode::ZeroNormal;
  if (std::ranges::any_of(loops, [](const auto& loop) { return meet(loop, loop); }))
    return RejectionCode::LoopMeetsItself;
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (meet(loops[i], loops[j])) return RejectionCode::LoopsMeet;
  for (std::size_t i = 1; i < loops.size(); ++i)
    if (begins_outside(loops[0], loops[i])) return RejectionCode::HoleOutside;
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
  return meet(loops[first], i, loops[second], j);
}

/// Up to three loops of points on a grid of 4 to 12 lines each way; neighbours differ.
rc::Gen<GridLoops> grid_loops() {
  return rc::gen::exec([] {
    GridLoops drawn{{}, *rc::gen::inRange(0, 3)};
    const std::int64_t high = *rc::gen::resize(100, rc::gen::inRange(3, 12));
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

TEST(ValidateAgainstEveryPair, AcceptsLoopsThatTouchByTheDefinition) {
  // Closed walks of six points on a grid of 3 x 3, one of 40.
  constexpr std::int64_t kSide = 3;
  int accepted = 0, touching = 0;
  for (std::int64_t walk = 0; walk < 531'441; walk += 40) {
    workloads::LatticeLoop loop;
    for (std::int64_t rest = walk, i = 0; i < 6; ++i, rest /= 9) loop.push_back({rest % 9 / kSide, rest % kSide});
    bool repeats = false;
    for (std::size_t i = 0; i < 6; ++i) repeats |= loop[i] == loop[(i + 1) % 6];
    if (repeats) continue;
    const auto rejection = exact::validate(polygon_of(GridLoops{{loop}, 2}.in_space()));
    const auto expected = code_by_definition({loop});
    ASSERT_EQ(rejection.has_value(), expected.has_value()) << walk;
    if (rejection) {
      ASSERT_EQ(to_string(rejection->code), to_string(*expected)) << walk;
    }
    accepted += rejection ? 0 : 1;
    touching += !rejection && touch({loop}) ? 1 : 0;
  }
  EXPECT_GT(touching, 50);
  EXPECT_GT(accepted - touching, 50);
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
