// SPDX-License-Identifier: GPL-3.0-or-later
// Culling cannot lie: no box that a ball touches is left out. In rationals over the operations that are compiled.
//
// The ball's reach, its scaled radius and kTiny, is 1: errors scale with it, and underflow counts most where it is
// kTiny alone. The ball touches the box, so no gap is larger than the reach, nor are the three together. Centres and
// corners are doubles: a difference of two is rounded once, whatever they are.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/proofs/error_bound.h"
#include "robust/scene/detail/culling_ball.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::filtered::proofs::culling {
namespace {

const mpq_class kU = 0x1p-53;  // round to nearest
const mpq_class kSmallestDouble = power(mpq_class(1, 2), 1074), kTiny = scene::culling::kTiny;
const ErrorModel kNearest{kU, kSmallestDouble / (kTiny * kTiny), true};
const ErrorBound kZero{&kNearest, 0, 0, 0};

ErrorBound exactly(const mpq_class& value) { return {&kNearest, value, value, 0}; }

/// By how much the least square that boxes are held to is more than the largest one of a box that the ball touches.
mpq_class to_spare(const mpq_class& wide) {
  // Seen from the centre. A gap as computed is negative exactly where it is.
  const ErrorBound corner = known_within(kNearest, 1, 0);
  const ErrorBound gap = scene::culling::gap(corner, corner, kZero, kZero, kZero);
  const mpq_class touching = 1 + scene::culling::squared_distance(gap, gap, gap).error;
  const ErrorBound reach = exactly(1) + kZero;  // the sum of the radius and kTiny
  return wide - scene::culling::squared_reach(reach, exactly(wide)).error - touching;
}

TEST(Culling, LeavesOutNoBoxThatIsTouched) {
  EXPECT_GE(to_spare(scene::culling::kWide), 0);
  EXPECT_LT(to_spare(1 + (mpq_class(scene::culling::kWide) - 1) / 4), 0) << "it is loose";
}

// A product by two powers of two loses at most the smallest double: the centre's and a corner's coordinates six of
// them, the radius one. That is less than the rounding of the sum with kTiny may be.
TEST(Culling, ReachesBeyondWhatUnderflowMoves) { EXPECT_LE(7 * kSmallestDouble, kTiny * power(kU, 2)); }

}  // namespace
}  // namespace touchstone::filtered::proofs::culling
