// SPDX-License-Identifier: GPL-3.0-or-later
// Culling cannot lie: no box that a ball touches is left out. In rationals over the operations that are compiled.
//
// The ball's reach, its scaled radius and kTiny, is 1: errors scale with it, and underflow counts most where it is
// kTiny alone. The ball touches the box, so no gap is larger than the reach, nor are the three together. Centres and
// corners are doubles: a difference of two is rounded once, whatever they are.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robust/proofs/error_bound.h"
#include "robust/scene/detail/culling_ball.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::culling {
namespace {

const mpq_class kTiny = scene::detail::culling::kTiny;
const ErrorModel kNearest{kU, kSmallestDouble / (kTiny * kTiny), true};
const ErrorBound kZero{&kNearest, 0, 0, 0};

ErrorBound exactly(const mpq_class& value) { return {&kNearest, value, value, 0}; }

/// By how much the least square that boxes are held to is more than the largest one of a box that the ball touches.
mpq_class to_spare(const mpq_class& wide) {
  // Seen from the centre. A gap as computed is negative exactly where it is.
  const ErrorBound corner = known_within(kNearest, 1, 0);
  const ErrorBound gap = scene::detail::culling::gap(corner, corner, kZero, kZero, kZero);
  const mpq_class touching = 1 + scene::detail::culling::squared_distance(gap, gap, gap).error;
  const ErrorBound reach = exactly(1) + kZero;  // the sum of the radius and kTiny
  return wide - scene::detail::culling::squared_reach(reach, exactly(wide)).error - touching;
}

TEST(Culling, LeavesOutNoBoxThatIsTouched) {
  EXPECT_GE(to_spare(scene::detail::culling::kWide), 0);
  EXPECT_LT(to_spare(1 + (mpq_class(scene::detail::culling::kWide) - 1) / 4), 0) << "it is loose";
}

// A product by two powers of two loses at most the smallest double: the centre's and a corner's coordinates six of
// them, the radius one. That is less than the rounding of the sum with kTiny may be.
TEST(Culling, ReachesBeyondWhatUnderflowMoves) { EXPECT_LE(7 * kSmallestDouble, kTiny * power(kU, 2)); }

// In floats the sides of boxes and the ends of a centre's interval are exact, and the squares are compared with a limit
// that doubles compute and a float holds. What underflows is in a claim of its own.
const mpq_class kFloatUnit = 0x1p-24;  // round to nearest
const ErrorModel kFloats{kFloatUnit, 0, true};

mpq_class to_spare_in_floats(const mpq_class& wide) {
  const ErrorBound zero{&kFloats, 0, 0, 0}, corner = known_within(kFloats, 1, 0);
  const ErrorBound gap = scene::detail::culling::gap(corner, corner, zero, zero, zero);
  const mpq_class touching = 1 + scene::detail::culling::squared_distance(gap, gap, gap).error;
  const ErrorBound reach = exactly(1) + kZero;
  const ErrorBound limit =
      scene::detail::culling::squared_reach(reach, exactly(wide)) + kZero;  // the sum with kTinyFloat
  return (wide - limit.error) * (1 - kFloatUnit) - touching;
}

TEST(Culling, LeavesOutNoBoxThatIsTouchedInFloats) {
  EXPECT_GE(to_spare_in_floats(scene::detail::culling::kWideFloat), 0);
  EXPECT_LT(to_spare_in_floats(1 + (mpq_class(scene::detail::culling::kWideFloat) - 1) / 4), 0) << "it is loose";
}

// Three products lose at most half of the smallest float each, and their sums add their own roundings.
TEST(Culling, ReachesBeyondWhatUnderflowMovesInFloats) {
  EXPECT_LE(2 * mpq_class(std::numeric_limits<float>::denorm_min()), mpq_class(scene::detail::culling::kTinyFloat) / 2);
}

/// By how much more the interval around a centre's nearest float reaches on either side than the centre may be away.
/// Lengths are in units of the float's magnitude, for floats from 2^-100 up.
mpq_class interval_to_spare(const mpq_class& share) {
  const mpq_class away = kFloatUnit / (1 - kFloatUnit);  // of the centre, which was rounded
  const mpq_class of_end = kFloatUnit * (1 + share);     // the end is rounded, too
  return share - away - of_end;
}

TEST(Culling, ContainsTheCentreInItsInterval) {
  EXPECT_GE(interval_to_spare(scene::detail::culling::kApartFloat), 0);
  EXPECT_LT(interval_to_spare(mpq_class(scene::detail::culling::kApartFloat) / 2), 0) << "it is loose";
  // Smaller floats are at most half of 2^-124 from a centre; the least normal number is more.
  for (const float nearest : {0.0F, std::numeric_limits<float>::denorm_min(), 0x1p-126F, 0x1.fffffep-101F, 0x1p-100F}) {
    const float apart = scene::detail::culling::apart(nearest);
    const mpq_class away = std::max<mpq_class>(std::abs(nearest) * kFloatUnit * 2, power(mpq_class(1, 2), 149));
    EXPECT_LT(mpq_class(nearest - apart), mpq_class(nearest) - away);
    EXPECT_GT(mpq_class(nearest + apart), mpq_class(nearest) + away);
  }
}

// Squares of differences of boxes' sides and centres.
TEST(Culling, DoesNotOverflowInFloats) {
  EXPECT_LE(3 * power(mpq_class(0x1p41) + 2 * mpq_class(scene::detail::culling::kLargestFloat), 2),
            mpq_class(std::numeric_limits<float>::max()) / 2);
}

}  // namespace
}  // namespace touchstone::proofs::culling
