// SPDX-License-Identifier: GPL-3.0-or-later
// What the first stage for triangles makes of signs, for all combinations, as far as it tells them apart, of signs that
// are positive, negative or not certain.
//
// The definition of contact is monotone in each sign. So it holds for all numbers behind a sign that is not certain if
// it holds for the worst of them, and for none if it does not hold for the best.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstddef>
#include <map>

#include "robust/filtered/detail/triangle/triangle_filter.h"
#include "tests/robust/proofs/planted_signs.h"

namespace touchstone::proofs {
namespace {

enum Sign : std::size_t { Vertex, AfterStart, AfterEnd, Line, Side, Plane, kSigns };
constexpr std::array<int, kSigns> kFavourable{-1, 1, -1, -1, 1, -1};  // towards contact

/// The signs at the three corners: +1, -1, or 0 where a sign is not certain.
using Signs = std::array<std::array<int, kSigns>, kCorners>;

/// Whether signs are possible together: there is one plane, and a ball that it misses reaches no vertex and no line.
bool are_possible(const Signs& signs) {
  bool missed = false, cut = false, reached = false;
  for (const auto& of : signs) {
    missed = missed || of[Plane] > 0, cut = cut || of[Plane] < 0;
    reached = reached || of[Vertex] < 0 || of[Line] < 0;
  }
  return !missed || (!cut && !reached);
}

/// Returns whether ball and triangle touch, if all signs that are not certain are favourable to it, or all are
/// unfavourable, as far as that is possible.
bool touch(const Signs& given, bool favourable) {
  Signs signs = given;
  for (auto& of : signs)
    for (std::size_t i = 0; i < kSigns; ++i)
      if (of[i] == 0) of[i] = favourable ? kFavourable[i] : -kFavourable[i];
  bool cut = favourable;
  for (const auto& of : given) {
    if (of[Plane] > 0) return false;
    cut = cut || of[Plane] < 0;
  }
  bool inside = true, edge = false;
  for (const auto& of : signs) {
    inside = inside && of[Side] > 0;
    edge = edge || of[Vertex] < 0 || (of[Line] < 0 && of[AfterStart] > 0 && of[AfterEnd] < 0);
  }
  return edge || (inside && cut);
}

/// What the first stage knows.
BallAtTriangle<Pack> at_triangle(const Signs& signs) {
  BallAtTriangle<Pack> ball = ball_without_signs();
  const auto lanes = [&](Sign of) { return in_lanes({signs[0][of], signs[1][of], signs[2][of]}); };
  ball.vertex_out = lanes(Vertex), ball.after_start = lanes(AfterStart), ball.after_end = lanes(AfterEnd);
  ball.line_out = lanes(Line), ball.side_in = lanes(Side), ball.plane_out = lanes(Plane);
  return ball;
}

/// What the decisions take of a corner: whether its edge is touched; whether its vertex or its line may be touched, and
/// whether the foot on the line may then lie beyond the ends; the signs of side and plane.
std::array<int, kSigns> taken_of(const std::array<int, kSigns>& of) {
  const bool bounded = of[AfterStart] > 0 && of[AfterEnd] < 0;
  const bool line_open = of[Line] <= 0 && of[AfterStart] >= 0 && of[AfterEnd] <= 0;
  return {of[Vertex] < 0 || (of[Line] < 0 && bounded),
          of[Vertex] <= 0,
          line_open,
          line_open && !bounded,
          of[Side],
          of[Plane]};
}

/// Calls visit(signs) with every state of one corner, and one state of the others for each that the decisions tell
/// apart.
template <class Visit>
void for_each_combination(const Visit& visit) {
  std::map<std::array<int, kSigns>, std::array<int, kSigns>> others;
  for (int state = 0; state < combinations(kSigns); ++state)
    others.emplace(taken_of(signs_of<kSigns>(state)), signs_of<kSigns>(state));
  for (int state = 0; state < combinations(kSigns); ++state)
    for (const auto& [taken_of_second, second] : others)
      for (const auto& [taken_of_third, third] : others)
        for (std::size_t turn = 0; turn < kCorners; ++turn) {
          Signs signs;
          signs[turn] = signs_of<kSigns>(state), signs[(turn + 1) % 3] = second, signs[(turn + 2) % 3] = third;
          if (are_possible(signs)) visit(signs);
        }
}

TEST(TriangleDecisions, AreRightWhateverIsBehindSignsThatAreNotCertain) {
  long sure = 0;
  for_each_combination([&](const Signs& signs) {
    const BallAtTriangle<Pack> ball = at_triangle(signs);
    if (ball.certainly_touches()) {
      ASSERT_TRUE(touch(signs, false)) << ::testing::PrintToString(signs);
      ++sure;
    } else if (ball.certainly_misses()) {
      ASSERT_FALSE(touch(signs, true)) << ::testing::PrintToString(signs);
      ++sure;
    }
  });
  EXPECT_GT(sure, 400'000);
}

TEST(TriangleDecisions, DependOnTheLoneSignAlone) {
  std::array<long, LoneSign::kNone> met{};
  for_each_combination([&](const Signs& signs) {
    const BallAtTriangle<Pack> ball = at_triangle(signs);
    const unsigned bit = ball.certainly_touches() || ball.certainly_misses() ? 0 : ball.lone_sign();
    if (bit == 0 || bit >= 1U << LoneSign::kNone) return;
    const int place = std::countr_zero(bit);
    ++met[static_cast<std::size_t>(place)];
    Signs with = signs;
    const auto decide = [&](int sign) {
      if (place == LoneSign::kPlane)
        for (auto& of : with) of[Plane] = sign;
      else
        with[static_cast<std::size_t>(place % kCorners)][place < LoneSign::kLines ? Vertex : Line] = sign;
    };
    decide(-1);
    ASSERT_TRUE(touch(with, false)) << place << ' ' << ::testing::PrintToString(signs);
    decide(1);
    ASSERT_FALSE(touch(with, true)) << place << ' ' << ::testing::PrintToString(signs);
  });
  for (const long count : met) EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace touchstone::proofs
