// SPDX-License-Identifier: GPL-3.0-or-later
// What the first stage makes of a capsule's signs, and the second stage of those of a vertex and of an edge, for all
// combinations of signs that are positive, negative or not certain.
//
// The definitions of contact with a vertex, an edge and the balls at the ends are monotone in each sign. So they hold
// for all numbers behind a sign that is not certain if they hold for the worst of them, and for none if they do not
// hold for the best. Whether the segment pierces the triangle is written out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "robust/filtered/detail/motion/capsule.h"
#include "tests/robust/proofs/planted_signs.h"

namespace touchstone::proofs {
namespace {

/// Whether something certainly holds, certainly does not, or neither.
FilterResult certainty(bool at_worst, bool at_best) {
  return at_worst ? FilterResult::Yes : at_best ? FilterResult::Unsure : FilterResult::No;
}
/// Returns what is certain of a conjunction of signs. `favourable`: those towards contact.
template <std::size_t n>
FilterResult conjunction(const std::array<int, n>& signs, const std::array<int, n>& favourable) {
  bool at_worst = true, at_best = true;
  for (std::size_t i = 0; i < n; ++i) {
    at_worst = at_worst && signs[i] == favourable[i];
    at_best = at_best && signs[i] != -favourable[i];
  }
  return certainty(at_worst, at_best);
}
FilterResult in_first_lane(const Pack& hit, const Pack& missed) {
  EXPECT_FALSE((negative_lanes(hit) & negative_lanes(missed) & 1) != 0);
  return certainty((negative_lanes(hit) & 1) != 0, (negative_lanes(missed) & 1) == 0);
}

CapsuleEnds<Pack> ends_without_signs() {
  const TriangleLanes<Pack> triangle(kSomeVector, kSomeVector);
  CapsuleEnds<Pack> ends(triangle, kSomeVector, kSomeVector, kSomeVector, all_lanes(1));
  ends.start = ends.end = ball_without_signs();
  ends.starts_front = ends.ends_front = in_all_lanes(0);
  return ends;
}
CapsuleSide<Pack> side_without_signs(const CapsuleEnds<Pack>& ends) {
  CapsuleSide<Pack> side(TriangleLanes<Pack>(kSomeVector, kSomeVector), ends, kSomeVector, all_lanes(1));
  for (LaneSigns<Pack>* signs :
       {&side.approaches, &side.departs, &side.vertex_out, &side.apart, &side.lines_out, &side.after_start,
        &side.after_end, &side.starts_past, &side.ends_past, &side.ahead_out})
    *signs = in_all_lanes(0);
  return side;
}

/// A number of which only the sign is known.
struct PlantedSign {
  int planted;
  [[nodiscard]] int sign() const { return planted; }
};
struct PlantedVertex {
  std::array<int, 3> signs;
  [[nodiscard]] PlantedSign approaches() const { return {signs[0]}; }
  [[nodiscard]] PlantedSign departs() const { return {signs[1]}; }
  [[nodiscard]] PlantedSign out() const { return {signs[2]}; }
};
struct PlantedEdge {
  std::array<int, 5> signs;
  [[nodiscard]] PlantedSign after_start() const { return {signs[0]}; }
  [[nodiscard]] PlantedSign after_end() const { return {signs[1]}; }
  [[nodiscard]] PlantedSign starts_past() const { return {signs[2]}; }
  [[nodiscard]] PlantedSign ends_past() const { return {signs[3]}; }
  [[nodiscard]] PlantedSign out() const { return {signs[4]}; }
};

TEST(CapsuleDecisions, OfAVertexAreThoseOfItsDefinition) {
  const CapsuleEnds<Pack> ends = ends_without_signs();
  CapsuleSide<Pack> side = side_without_signs(ends);
  for (int number = 0; number < combinations(3); ++number) {
    const auto signs = signs_of<3>(number);
    const FilterResult expected = conjunction(signs, {-1, 1, -1});
    side.approaches = in_all_lanes(signs[0]), side.departs = in_all_lanes(signs[1]);
    side.vertex_out = in_all_lanes(signs[2]);
    EXPECT_EQ(in_first_lane(side.vertex_hit(), side.vertex_missed()), expected) << number;
    EXPECT_EQ(is_vertex_hit(PlantedVertex{signs}), expected) << number;
  }
}

// The edge's line is missed, too, if the signs `line` at the start and `line_ahead` are positive: signs.h says why.
TEST(CapsuleDecisions, OfAnEdgeAreThoseOfItsDefinition) {
  const CapsuleEnds<Pack> ends = ends_without_signs();
  CapsuleSide<Pack> side = side_without_signs(ends);
  for (int number = 0; number < combinations(5); ++number) {
    const auto signs = signs_of<5>(number);
    const FilterResult expected = conjunction(signs, {1, -1, -1, 1, -1});
    EXPECT_EQ(is_edge_hit(PlantedEdge{signs}), expected) << number;
    side.after_start = in_all_lanes(signs[0]), side.after_end = in_all_lanes(signs[1]);
    side.starts_past = in_all_lanes(signs[2]), side.ends_past = in_all_lanes(signs[3]);
    side.lines_out = in_all_lanes(signs[4]);
    for (int more = 0; more < combinations(2); ++more) {
      const auto [start_out, ahead_out] = signs_of<2>(more);
      const bool line_missed = start_out > 0 && ahead_out > 0;
      if (line_missed && expected == FilterResult::Yes) continue;  // impossible
      side.ahead_out = in_all_lanes(ahead_out);
      EXPECT_EQ(in_first_lane(side.edge_hit(), side.edge_missed(in_all_lanes(start_out))),
                line_missed ? FilterResult::No : expected)
          << number << ' ' << more;
    }
  }
}

TEST(CapsuleDecisions, OfThePlaneAreThatBothEndsLieBeyondTheRadiusOnOneSide) {
  CapsuleEnds<Pack> ends = ends_without_signs();
  for (int number = 0; number < combinations(4); ++number) {
    const auto [start_front, end_front, start_out, end_out] = signs_of<4>(number);
    ends.starts_front = in_all_lanes(start_front), ends.ends_front = in_all_lanes(end_front);
    ends.start.plane_out = in_all_lanes(start_out), ends.end.plane_out = in_all_lanes(end_out);
    EXPECT_EQ(ends.miss_plane(), start_front != 0 && start_front == end_front && start_out > 0 && end_out > 0);
  }
}

/// Plants what is certain about a ball: +1 that it touches, -1 that it does not.
void plant(BallAtTriangle<Pack>& ball, int touches) {
  ball.vertex_out = in_lanes({touches > 0 ? -1 : 0, 0, 0});
  ball.plane_out = in_all_lanes(touches < 0 ? 1 : 0);
}

// Signs that decide about vertices and edges are left to the tests above: here each is hit, missed or neither.
TEST(CapsuleDecisions, TogetherAreThoseOfTheDefinition) {
  CapsuleEnds<Pack> ends = ends_without_signs();
  CapsuleSide<Pack> side = side_without_signs(ends);
  const auto result = [](int sign) { return certainty(sign > 0, sign >= 0); };
  long sure = 0;
  for (int features = 0; features < combinations(6); ++features) {
    const auto [vertex0, vertex1, vertex2, edge0, edge1, edge2] = signs_of<6>(features);
    const std::array vertices{vertex0, vertex1, vertex2}, edges{edge0, edge1, edge2};
    side.approaches = in_all_lanes(-1), side.departs = in_all_lanes(1);
    side.vertex_out = in_lanes({-vertex0, -vertex1, -vertex2}), side.lines_out = in_lanes({-edge0, -edge1, -edge2});
    side.after_start = side.ends_past = in_all_lanes(1), side.after_end = side.starts_past = in_all_lanes(-1);
    unsigned open_vertices = 0, open_edges = 0;
    for (unsigned corner = 0; corner < kCorners; ++corner) {
      open_vertices |= (vertices[corner] >= 0 ? 1U : 0U) << corner;
      open_edges |= (edges[corner] >= 0 ? 1U : 0U) << corner;
    }
    const int most = std::max({vertex0, vertex1, vertex2, edge0, edge1, edge2});
    for (int others = 0; others < combinations(7); ++others) {
      const auto [start, end, starts_front, ends_front, left0, left1, left2] = signs_of<7>(others);
      plant(ends.start, start), plant(ends.end, end);
      ends.starts_front = in_lanes({0, starts_front, 0}), ends.ends_front = in_lanes({0, ends_front, 0});
      side.apart = in_lanes({left0, left1, left2});
      const auto [least_left, most_left] = std::minmax({left0, left1, left2});
      const bool one_side = least_left == most_left && least_left != 0;
      const bool pierces = one_side && starts_front * ends_front < 0;
      const bool may_pierce = !(least_left < 0 && most_left > 0) && starts_front * ends_front <= 0;
      CapsuleSigns signs{};
      const FilterResult decided = decide(ends, side, signs);
      const int best = std::max({start, end, most});
      ASSERT_EQ(decided, certainty(best > 0 || pierces, best >= 0 || may_pierce)) << features << ' ' << others;
      ASSERT_EQ(signs.at_start, result(start));
      sure += decided == FilterResult::Unsure ? 0 : 1;
      if (decided != FilterResult::Unsure) continue;
      // What is left open is all that may still touch.
      ASSERT_EQ(signs.at_end, result(end));
      ASSERT_EQ(signs.may_pierce, may_pierce);
      ASSERT_EQ(signs.vertices, open_vertices);
      ASSERT_EQ(signs.edges, open_edges);
    }
  }
  EXPECT_GT(sure, 1'000'000);
}

/// What is known of the features of a capsule, a sign each: +1 if it is hit, -1 if not.
struct PlantedFeatures {
  std::array<int, 6> signs;

  [[nodiscard]] FilterResult vertex(int i) const { return of(signs[static_cast<std::size_t>(i)]); }
  [[nodiscard]] FilterResult edge(int i) const { return of(signs[static_cast<std::size_t>(i) + kCorners]); }
  static FilterResult of(int sign) { return certainty(sign > 0, sign >= 0); }
};

// Of a capsule whose ends touch nothing.
TEST(CapsuleDecisions, OfOpenFeaturesAreThatOneOfThemIsHit) {
  for (int number = 0; number < combinations(6); ++number) {
    const PlantedFeatures features{signs_of<6>(number)};
    for (unsigned open = 0; open < 1U << 7; ++open) {
      CapsuleSigns signs{};
      signs.vertices = open & 7, signs.edges = open >> 3 & 7, signs.may_pierce = open >> 6 != 0;
      int best = signs.may_pierce ? 0 : -1;
      for (unsigned i = 0; i < 6; ++i)
        if ((open >> i & 1) != 0) best = std::max(best, features.signs[i]);
      ASSERT_EQ(open_features_hit(signs, features), PlantedFeatures::of(best)) << number << ' ' << open;
    }
  }
}

}  // namespace
}  // namespace touchstone::proofs
