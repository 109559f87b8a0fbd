// SPDX-License-Identifier: GPL-3.0-or-later
// The margins of the disc that a moving ball sweeps in a polygon's plane, in rationals over the operations that are
// compiled: no box is missed whose edges the ball touches in time.
//
// Lengths are in the frame's unit, with coordinates of the centre, and components of the velocity, of at most 1. Then
// the size is at least 2, and the margin that of size 2: every error is a sum of lengths times coefficients that are
// not negative.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "robust/filtered/detail/motion/polygon_events.h"
#include "robust/filtered/detail/motion/polygon_motion.h"
#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/ratio.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::swept {
namespace {

namespace swept_disc = filtered::detail::swept_disc;

const mpq_class kUnit = bounds::kUnit, kSize = 2;
const ErrorModel kAnyRounding{kUnit, mpq_class(1, mpz_class(1) << 1021), true};
/// What a subnormal number that was flushed to zero may have been worth, scaled by 2^900 (Frame::kSubnormal).
const mpq_class kFlushed = mpq_class(0x1p-122);

ErrorBound exactly(const mpq_class& number) { return {&kAnyRounding, number, number, 0}; }
/// Any number up to a magnitude, known to this many units.
ErrorBound known(const mpq_class& magnitude, const mpq_class& units) {
  return known_within(kAnyRounding, magnitude, units * kUnit);
}

const ErrorBound kMargin = swept_disc::margin(exactly(kSize));
/// A ball that does not touch at its start is not larger than this: it is that far from no vertex.
const mpq_class kRadius = root_above(3) + bounds::kExtent;

TEST(SweptDisc, BallsThatDoNotTouchAreNotLarge) { EXPECT_LT(kRadius, 2 * kSize); }

/// A difference of scaled numbers, both of which may have been flushed.
ErrorBound difference() { return known_within(kAnyRounding, 1, kUnit + 2 * kFlushed); }
/// A coordinate in the frame, of the centre or of its velocity.
ErrorBound coordinate() {
  const ErrorBound axis = known(1, 1), given = difference();
  return filtered::detail::frame::coordinate(Vector3<ErrorBound>{axis, axis, axis},
                                             Vector3<ErrorBound>{given, given, given});
}
/// A height at time 0.
ErrorBound height() {
  const ErrorBound axis = known(1, 1), given = difference();
  return filtered::detail::frame::height(Vector3<ErrorBound>{axis, axis, axis},
                                         Vector3<ErrorBound>{given, given, given}, known(bounds::kExtent, 1));
}
/// By how much the height may be wrong at any time.
mpq_class error_of_heights() { return height().error + coordinate().error; }

// Both times, multiplied by the speed, as if that were 1: relative errors stay. Computed height and speed are taken to
// be exact, and the radius is wider by their errors. Roundings are largest where the way to the plane is longest.
TEST(SweptDisc, TimesContainThoseAtWhichTheBallReachesThePlane) {
  const mpq_class first = -height().magnitude(), wider = error_of_heights() + kFlushed;
  for (const mpq_class& radius : {mpq_class(0), kRadius}) {
    const ErrorBound one = exactly(1);
    const swept_disc::Times<ErrorBound> times(exactly(first), one, one, exactly(radius), kMargin);
    EXPECT_LE(times.begin.high, -first - (radius + wider));
    EXPECT_GE(times.end.low, -first + (radius + wider));
  }
}

// The last height is rounded, too; all others between are not smaller in magnitude than one of the two, or have any.
TEST(SweptDisc, DistancesFromThePlaneAreNotTooLarge) {
  const ErrorBound last = height() + coordinate();
  const mpq_class distance = last.magnitude();
  EXPECT_LE(swept_disc::least_distance(exactly(distance), kMargin).high, distance - last.error - kFlushed);
}

TEST(FootOfAMotion, HasAnErrorThatCoversItsRoundings) {
  EXPECT_GE(filtered::detail::error_of_foot(Ratio<52>{}, {}, {}, {}, {}).least, 1);
}

// Up to the rounding of a sum, which the margin of `within` and of `astride` covers.
TEST(SweptDisc, ReachesCoverTheirRoundings) {
  EXPECT_GE(swept_disc::reach(Ratio<52>{}, {}, {}).least, 1 - kUnit);
  EXPECT_GE((swept_disc::Way<Ratio<52>>{}.area(Ratio<52>{}).least), 1);
}

// All numbers are exact.
TEST(SweptDisc, IsAboutDistancesFromAWay) {
  EXPECT_GE(swept_disc::reach<double>(5, 3, 1), 5);
  const swept_disc::Way<double> way{20, 30, 3, 4};
  EXPECT_GE(way.area(2), 10);
  const swept_disc::BoxFromWay<double> along(way, 1, 2, 1, 0, 5, 7, 0.5), across(way, 1, 2, 0, 1, 5, 7, 0.5);
  EXPECT_EQ(along.beside, 19 - (3 + 5.5));
  EXPECT_EQ(along.above, 28 - (4 + 7.5));
  EXPECT_EQ(across.beside, 28 - (4 + 5.5));
  EXPECT_EQ(across.above, 19 - (3 + 7.5));
  EXPECT_EQ(along.within(2), 4 - (10.5 * 10.5 + 16.5 * 16.5));
  EXPECT_EQ(along.offset, std::abs(19 * 4 - 28 * 3));
  EXPECT_EQ(along.shadow, 5.5 * 4 + 7.5 * 3);
  EXPECT_GE(along.astride(10, 1), 5.5 * 4 + 7.5 * 3 + 10 + 1 - 8);
}

/// The way of the foot: between exact times from 0 to 1.
swept_disc::Way<ErrorBound> way() {
  const ErrorBound time{&kAnyRounding, 0, 1, 0};
  return swept_disc::Way<ErrorBound>::between(time, time, coordinate(), coordinate(), coordinate(), coordinate());
}
/// As it is computed, and taken to be exact. Half of it is one long, in any direction.
swept_disc::Way<ErrorBound> computed_way() {
  return {known(way().middle_x.magnitude(), 0), known(way().middle_y.magnitude(), 0), known(1, 0), known(1, 0)};
}

/// Edges and boxes as stored, the half sizes as of both: the centre from the ends of an edge.
swept_disc::BoxFromWay<ErrorBound> box(const swept_disc::Way<ErrorBound>& from) {
  const ErrorBound end = known(bounds::kExtent, bounds::kFramePoint), half = exactly(0.5);
  const ErrorBound center = half * (end + end), axis = known(1, bounds::kFrameDirection);
  const ErrorBound half_along = half * known(bounds::kExtent, bounds::kFrameLength);
  return {from, center, center, axis, axis, half_along, known(bounds::kExtent, 0), kMargin};
}

// The half sizes are wider by the margin than the exact ones, by less are all distances beyond them wrong.
TEST(SweptDisc, BoxesThatAreBesideOrAboveAreMissed) {
  const swept_disc::BoxFromWay<ErrorBound> seen = box(way());
  for (const ErrorBound& beyond : {seen.beside, seen.above}) {
    EXPECT_LE(beyond.error, kMargin.low);
    EXPECT_GT(beyond.error, kMargin.low / 64) << "it is loose";
  }
  // Squares are compared, of which each side is rounded thrice, and the margin of the reach is left.
  const mpq_class compared = power(1 + kUnit, 4) - 1, reach = kRadius * bounds::kWide + kMargin.high;
  EXPECT_LE(compared * 2 * reach, kMargin.low);
}

// A point of the box is not within r of a point of the way if it is farther than that from the way's line. All these
// distances are multiplied by half of the way, which cancels. The exact foot is beside the computed way by its error.
// The margin counts twice: in the reach, and in the half sizes, as the spans along the axis and across it together are
// not shorter than half of the way. The factor, and what covers underflow, only add to this.
TEST(SweptDisc, BoxesThatAreBesideTheLineAreMissed) {
  const ErrorBound reach = known(kRadius, 0) + kMargin;
  const swept_disc::BoxFromWay<ErrorBound> seen = box(computed_way());
  const mpq_class of_foot = root_above(2) * (way().middle_x.error + way().half_x.error);
  const mpq_class needed = seen.astride(reach, exactly(0)).error + of_foot;
  const mpq_class of_reach = 2 * kUnit * reach.magnitude();
  EXPECT_LE(needed + of_reach, 2 * kMargin.low);
  EXPECT_GT(needed, 2 * kMargin.low / 64) << "it is loose";
  // Numbers are at most kLongestMotion; no product has more than three of them.
  EXPECT_LE(100 * power(bounds::kLongestMotion, 3) * kAnyRounding.underflow, power(kMargin.low, 2));
}

}  // namespace
}  // namespace touchstone::proofs::swept
