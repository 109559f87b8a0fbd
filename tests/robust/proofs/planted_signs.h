// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "robust/filtered/detail/triangle/triangle_filter.h"

/// Signs as the tests of decisions plant them: +1, -1, or 0 where a sign is not certain.
namespace touchstone::proofs {

using namespace filtered::detail;

constexpr int kCorners = 3;

/// Returns these signs in the lanes of a triangle's corners; lane 3 repeats the first.
inline LaneSigns<Pack> in_lanes(const std::array<int, kCorners>& signs) {
  double positive[kLanes], negative[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    const int sign = signs[static_cast<std::size_t>(lane % kCorners)];
    positive[lane] = sign > 0 ? -1 : 1, negative[lane] = sign < 0 ? -1 : 1;
  }
  return {load(positive), load(negative)};
}
inline LaneSigns<Pack> in_all_lanes(int sign) { return in_lanes({sign, sign, sign}); }

inline const Vector3<Pack> kSomeVector{all_lanes(1), all_lanes(1), all_lanes(1)};

/// Returns a ball of whose signs none is certain.
inline BallAtTriangle<Pack> ball_without_signs() {
  BallAtTriangle<Pack> ball(TriangleLanes<Pack>(kSomeVector, kSomeVector), kSomeVector, all_lanes(1));
  for (LaneSigns<Pack>* signs :
       {&ball.vertex_out, &ball.after_start, &ball.after_end, &ball.line_out, &ball.side_in, &ball.plane_out})
    *signs = in_all_lanes(0);
  return ball;
}

/// Returns the base-3 digits of a number, less 1: so numbers below 3^n count all combinations of n signs.
template <std::size_t n>
std::array<int, n> signs_of(int number) {
  std::array<int, n> signs{};
  for (int& sign : signs) sign = number % 3 - 1, number /= 3;
  return signs;
}
constexpr int combinations(int signs) { return signs == 0 ? 1 : 3 * combinations(signs - 1); }

}  // namespace touchstone::proofs
