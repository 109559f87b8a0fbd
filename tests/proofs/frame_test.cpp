// SPDX-License-Identifier: GPL-3.0-or-later
// What bounds.h says of heights, distances and boxes in the isometric frame, in rationals over the operations that are
// compiled.
//
// Lengths are in units of the polygon's size, with W = 1 and S = 2. That is the worst case: every error here is a sum
// of lengths times coefficients that are not negative, W and the polygon's size are at most S / 2, and the bounds grow
// with S.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/filtered/bounds.h"
#include "robust/filtered/edge_frame.h"
#include "robust/proofs/error_bound.h"
#include "tests/proofs/rationals.h"

namespace touchstone::filtered::proofs {
namespace {

const mpq_class kUnit = bounds::kUnit, kSize = 2;
const ErrorModel kAnyRounding{kUnit, mpq_class(1, mpz_class(1) << 1021), true};

ErrorBound known(const mpq_class& magnitude, const mpq_class& error, const ErrorModel& model = kAnyRounding) {
  return known_within(model, magnitude, error);
}
const ErrorBound kZero{&kAnyRounding, 0, 0, 0};

/// The most by which a computed `constant unit size` may be short: the product is rounded once.
mpq_class bound_of(double constant) { return mpq_class(constant) * kUnit * kSize * (1 - kUnit); }

// A comparison of height +- error with a radius, or their sum or difference that goes into a product, is rounded once.
TEST(FrameBounds, OfHeightsCoverTheirComparison) {
  const ErrorBound axis = known(1, kUnit), from = known(1, kUnit);
  const ErrorBound height = frame::height(Vector3<ErrorBound>{axis, axis, axis}, Vector3<ErrorBound>{from, from, from},
                                          known(bounds::kExtent, kUnit));
  const mpq_class needed = height.error + kUnit * (height.magnitude() + bound_of(bounds::kHeight));
  EXPECT_LE(needed, bound_of(bounds::kHeight));
  EXPECT_GT(needed, bound_of(bounds::kHeight) * 15 / 16) << "it is loose";
}

/// How far the root of the computed square of the length of (x, y) may be from that of the exact numbers, if it is at
/// most `longest`: as much as (x, y) moves, and the square's own rounding, two operations in a row whose effect the
/// root halves.
mpq_class error_of_length(const ErrorBound& x, const ErrorBound& y, const mpq_class& longest) {
  return root_above(power(x.error, 2) + power(y.error, 2)) + kUnit * longest + root_above(3 * kAnyRounding.underflow);
}
mpq_class length(const ErrorBound& x, const ErrorBound& y) {
  return root_above(power(x.magnitude(), 2) + power(y.magnitude(), 2));
}

/// A foot as seen from an edge, both with the errors that are given.
struct Edge {
  ErrorBound along, overshoot, across;

  Edge(const ErrorBound& foot, const ErrorBound& start, const mpq_class& stored_error) {
    const ErrorBound &x = foot, y = foot, start_x = start, start_y = start;
    const ErrorBound direction_x = known(1, stored_error), direction_y = known(1, stored_error);
    along = frame::along(x, y, start_x, start_y, direction_x, direction_y);
    across = frame::across(x, y, start_x, start_y, direction_x, direction_y);
    overshoot = frame::overshoot(along, known(bounds::kExtent, stored_error), kZero);
  }
  [[nodiscard]] mpq_class longest() const { return length(across, overshoot); }
  [[nodiscard]] mpq_class error(const mpq_class& distance) const {
    return error_of_length(across, overshoot, distance);
  }
};

TEST(FrameBounds, OfDistancesCoverRoots) {
  const Edge edge(known(kSize, bounds::kCoordinate * kUnit), known(bounds::kExtent, kUnit), kUnit);
  const mpq_class needed = edge.error(edge.longest());
  EXPECT_LE(needed, bound_of(bounds::kDistance));
  EXPECT_GT(needed, bound_of(bounds::kDistance) * 15 / 16) << "it is loose";
}

// FrameQuery's `outer`: two sums and a product, halved by the root; the root, the product with kWide, the sum. Then a
// square and one more product. Five roundings in a row at most; `inner` likewise.
TEST(FrameBounds, WideAndNarrowCoverFourteenRoundings) {
  EXPECT_GE(bounds::kWide * power(1 - kUnit, 14), 1);
  EXPECT_LE(bounds::kNarrow * power(1 + kUnit, 14), 1);
  EXPECT_LT(bounds::kWide * power(1 - kUnit, 17), 1) << "it is loose";
  EXPECT_GT(bounds::kNarrow * power(1 + kUnit, 17), 1) << "it is loose";
}

// Off the edge even where both the distance and its bound are off, and by so much more that what is stored of the edge
// and of the foot may be taken for the exact ones: a point that moves by less than its distance crosses nothing.
TEST(FrameBounds, NearIsFurtherThanAllThatIsStoredMayBeOff) {
  const mpq_class near = bounds::kNear * bound_of(bounds::kDistance) * power(1 - kUnit, 3);
  const mpq_class exact = near - bound_of(bounds::kDistance);
  const mpq_class foot = bounds::kCoordinate * kUnit, vertex = kUnit;
  EXPECT_GT(exact, root_above(2 * power(foot, 2)) + root_above(2 * power(vertex, 2)));
  // Within the box that is upright about an edge nothing overshoots its ends: the distance is the one across.
  const Edge stored(known(2 * bounds::kExtent, 0), kZero, 0);
  EXPECT_GT(near, stored.error(stored.longest()) + stored.overshoot.error);
}

/// The error of a distance to a box, foot and box as stored, the one at most `away` from the other's centre in each
/// coordinate.
mpq_class error_of_box(const mpq_class& away, const mpq_class& distance) {
  const ErrorBound x = known(away, 0), y = known(away, 0);
  const ErrorBound axis_x = known(1, 0), axis_y = known(1, 0), half = known(bounds::kExtent, 0);
  const ErrorBound along = frame::along(x, y, kZero, kZero, axis_x, axis_y);
  const ErrorBound across = frame::across(x, y, kZero, kZero, axis_x, axis_y);
  const ErrorBound beside = maximum(frame::beyond(along, half), kZero);
  const ErrorBound above = maximum(frame::beyond(across, half), kZero);
  return error_of_length(beside, above, distance);
}

// A box holds the ends of an edge as stored; the edge that starts at the one and has the stored direction and length
// ends near the other: both rounded ends, the direction and the length, each off by a unit in two coordinates.
TEST(FrameBounds, BoxesAreReachedWhereTheirEdgesAre) {
  const mpq_class ends = 4 * root_above(2 * power(kUnit * bounds::kExtent, 2));
  const mpq_class near = bounds::kNear * bound_of(bounds::kDistance) * power(1 - kUnit, 3);
  // As much as the root of kBoxReach allows for, of a distance from `near` on.
  const mpq_class wider = root_above(bounds::kBoxReach * (1 - 4 * kUnit)) * (1 - kUnit) - 1;
  // An axis whose length is off by a few units stretches distances.
  const auto needed = [&](const mpq_class& away, const mpq_class& distance) -> mpq_class {
    return error_of_box(away, distance) + Edge(known(away, 0), kZero, 0).error(distance) + ends + 8 * kUnit * distance;
  };
  // A foot that is close to an edge is no farther from its start, or from the middle of a box, than vertices are from
  // each other. Farther away `close` is much more than any error is; for a foot beyond 4 errors grow as distances do.
  const mpq_class close = 0x1p-20, extent = bounds::kExtent, far = 4;
  EXPECT_LE(needed(extent + close, 2 * close), wider * near);
  EXPECT_GT(needed(extent + close, 2 * close), wider * near * 3 / 4) << "kNear or kBoxReach is loose";
  EXPECT_LE(needed(far + extent, 2 * (far + extent)), wider * close);
}

// A group's box, built rounding to nearest: a point's coordinates along the box's axis and across it differ from those
// of the centre by at most half of what they extend, and by what the axis' length and all roundings make of them.
TEST(FrameBounds, BoxesHoldTheirPoints) {
  const ErrorModel nearest{kUnit / 2, kAnyRounding.underflow, true};
  const ErrorBound x = known(bounds::kExtent, 0, nearest), y = known(bounds::kExtent, 0, nearest);
  const ErrorBound axis_x = known(1, 0, nearest), axis_y = known(1, 0, nearest);
  const ErrorBound point = frame::turned_along(x, y, axis_x, axis_y);
  // The middle of the least and the most: their sum is rounded, half of it is not.
  const mpq_class reach = root_above(2) * mpq_class(bounds::kExtent);
  const mpq_class middle = nearest.unit * reach;
  const ErrorBound m = known(reach, 0, nearest);
  const ErrorBound center = frame::turned_along(m, m, axis_x, axis_y);
  // Components of the axis: a difference, the length that it is divided by to within two units, a quotient.
  const mpq_class axis_length_squared = power(1 + nearest.unit, 8) - 1;
  const mpq_class half = nearest.unit * 2 * reach;
  const mpq_class needed = point.error + middle + reach * axis_length_squared + root_above(2) * center.error + half;
  EXPECT_LE(needed, mpq_class(bounds::kBoxRounding) * (1 - nearest.unit));
  EXPECT_GT(needed, mpq_class(bounds::kBoxRounding) / 2) << "it is loose";
}

}  // namespace
}  // namespace touchstone::filtered::proofs
