// SPDX-License-Identifier: GPL-3.0-or-later
// The culling of moving balls cannot lie: neither is a box or triangle left out that the ball touches, nor is it held
// to be touched later than it is. In rationals over the operations that are compiled.
#include "robust/scene/detail/culling_motion.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <limits>

#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::culling_motion {
namespace {

const mpq_class kLargestDouble = std::numeric_limits<double>::max();

/// The calculus with lengths in units of L, the largest of the centres' coordinates and the reach. Underflow counts
/// most where L is kTiny.
const mpq_class kLeast = scene::detail::culling::kTiny;
const ErrorModel kNearest{kU, kSmallestDouble / power(kLeast, 2), true};

ErrorBound exactly(const mpq_class& value) { return {&kNearest, value, value, 0}; }
ErrorBound between(const mpq_class& low, const mpq_class& high, const mpq_class& error) {
  return {&kNearest, low, high, error};
}

/// A coordinate of a centre or its end. Scaling by two powers of two loses at most two of the smallest doubles.
const ErrorBound kCenter = known_within(kNearest, 1, 2 * kSmallestDouble / kLeast);
const ErrorBound kReach = between(0, 1, 2 * kSmallestDouble / kLeast) + exactly(0);  // the sum of the radius and kTiny

/// The error of the computed times at which the ball comes to a box and leaves it, times the centre's change along the
/// axis, if the ball reaches farther by `margin`.
///
/// Let the ball touch the box at time t in [0, 1], and let the centre's coordinate increase. Then the near side of
/// the box is at most c(t) + r, which is within 2 L. Rounding is monotonous, so the computed time is at most that of a
/// side at c(t) + r, whose exact time, with the margin, is t - margin / change. The same holds of the time of the far
/// side, mirrored, and of a coordinate that decreases. Times are in units of 1 / change here, so that the inverse is 1,
/// up to the roundings of the change and of the quotient.
mpq_class error_of_times(const mpq_class& margin) {
  const mpq_class inverse_error = (1 + kU) / (1 - kU) - 1 + kSmallestDouble / power(kLeast, 2);
  const ErrorBound inverse = between(1 - inverse_error, 1 + inverse_error, inverse_error);
  const ErrorBound side = kReach + exactly(margin) * exactly(1);
  const ErrorBound offset = scene::detail::culling::offset(kCenter, side, inverse);
  const ErrorBound box_side = known_within(kNearest, 2 + 4 * kU, 0);
  return scene::detail::culling::time_at(box_side, inverse, offset).error;
}

/// The error of the end of a way that ends at any time in [0, 1], with the margin that is added.
mpq_class error_of_end(const mpq_class& margin) {
  const ErrorBound change = kCenter - kCenter, time = between(0, 1, 0);
  const ErrorBound end = scene::detail::place_at(kCenter, time, change) + exactly(margin) * exactly(1);
  return end.error;
}

bool covers(const mpq_class& margin) { return error_of_times(margin) <= margin && error_of_end(margin) <= margin; }

TEST(CullingMotionMargin, CoversTheRoundingsOfTimesAndEnds) {
  const mpq_class margin = scene::detail::culling::kMargin;
  EXPECT_TRUE(covers(margin));
  EXPECT_FALSE(covers(margin * 9 / 10)) << "it is loose";
}

// Times are finite: an inverse is at most 1 / (kStill L), a side of a box is a float, and those of the ball are within
// 2 L. A centre that moves less has no times. A box that is not scaled may be so far away that they are infinite; the
// ball then misses it.
TEST(CullingMotionStill, KeepsTimesFinite) {
  const auto largest_time = [](const mpq_class& still) -> mpq_class {
    const mpq_class inverse = 1 / (still * kLeast) * (1 + 4 * kU);
    return std::numeric_limits<float>::max() * inverse + 2 / still * (1 + 8 * kU);
  };
  EXPECT_LE(largest_time(scene::detail::culling::kStill), kLargestDouble);
  EXPECT_GT(largest_time(power(mpq_class(1, 2), 400)), kLargestDouble) << "it is blind";
}

/// By how much the radius of a shortened motion must be larger, less by how much it is, if no coordinate and no radius
/// is above `largest`. Each coordinate of the end is off by the calculus' error, so the end by at most sqrt(3) times
/// that; and so is every place between it and the start.
mpq_class lack_of_radius(const ErrorModel& model, const mpq_class& largest, const mpq_class& margin,
                         const mpq_class& tiny) {
  const auto exact = [&](const mpq_class& low, const mpq_class& high) { return ErrorBound{&model, low, high, 0}; };
  const ErrorBound coordinate = exact(-largest, largest), time = exact(0, 1), most = exact(largest, largest);
  const ErrorBound end = scene::detail::place_at(coordinate, time, coordinate - coordinate);
  const ErrorBound radius =
      scene::detail::swept::wider(exact(0, largest), exact(margin, margin), most, exact(tiny, tiny));
  return root_above(3 * power(end.error, 2)) + radius.error - margin * largest - tiny;
}

TEST(SweptMargin, CoversTheRoundingsOfEndAndRadius) {
  static const ErrorModel nearest{kU, 0, true};
  const mpq_class margin = scene::detail::swept::kMargin;
  EXPECT_LE(lack_of_radius(nearest, 1, margin, 0), 0);
  EXPECT_GT(lack_of_radius(nearest, 1, margin * 9 / 10, 0), 0) << "it is loose";
}

// The rest of the error, which does not grow with the coordinates.
TEST(SweptTiny, CoversUnderflow) {
  static const ErrorModel nearest{kU, kSmallestDouble / 2, true};
  const mpq_class margin = scene::detail::swept::kMargin, tiny = scene::detail::swept::kTiny;
  EXPECT_LE(lack_of_radius(nearest, 0, margin, tiny), 0);
  EXPECT_GT(lack_of_radius(nearest, 0, margin, tiny / 2), 0) << "it is loose";
}

}  // namespace
}  // namespace touchstone::proofs::culling_motion
