// SPDX-License-Identifier: GPL-3.0-or-later
// What bounds.h says of heights, distances and boxes in the isometric frame, in rationals over the operations that are
// compiled.
//
// Lengths are in the frame's unit, with W = 1 and S = 2. That is the worst case: every error here is a sum of lengths
// times coefficients that are not negative, W and the frame's unit are at most S / 2, and the bounds grow with S.
#include "robust/filtered/detail/polygon/frame.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <utility>

#include "experiments/cases/workloads/random.h"
#include "robust/filtered/detail/polygon/newell_plane.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/signs/edge_frame.h"
#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/ratio.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::frame_bounds {
namespace {

const mpq_class kUnit = bounds::kUnit, kSize = 2;
const ErrorModel kAnyRounding{kUnit, mpq_class(1, mpz_class(1) << 1021), true};

ErrorBound known(const mpq_class& magnitude, const mpq_class& error, const ErrorModel& model = kAnyRounding) {
  return known_within(model, magnitude, error);
}
const ErrorBound kZero{&kAnyRounding, 0, 0, 0};

/// What a subnormal number that was flushed to zero may have been worth, scaled by 2^900 (Frame::kSubnormal).
const mpq_class kFlushed = mpq_class(0x1p-122);

/// The bound of distances as the first stage computes it, S = kSize.
ErrorBound distance_error() { return frame::distance_error(ErrorBound{&kAnyRounding, kSize, kSize, 0}); }

// Vertices are within 1/4 of vertex 0 in each coordinate, and no component of the normal is larger than the one along
// which they are lifted: the plane through the mean is at most 3/4 above vertex 0, measured along that axis, and rises
// by at most the other two coordinates.
TEST(FrameBounds, ExtentIsThatOfALiftedPolygon) {
  const mpq_class other(1, 4), lifted = 3 * other + 2 * other;
  EXPECT_LE(root_above(2 * power(other, 2) + power(lifted, 2)), bounds::kExtent);
  EXPECT_LE(root_above(2 * power(2 * other, 2) + power(4 * other, 2)), bounds::kExtent) << "of edges";
  EXPECT_LE(3 * other, bounds::kExtent) << "of the plane";
}

/// A height as the first stage computes it, W = 1.
frame::Height<ErrorBound> height_in(const ErrorModel& model) {
  const ErrorBound axis = known(1, kUnit, model), from = known(1, kUnit + 2 * kFlushed, model);
  return {{from, from, from}, {axis, axis, axis}, known(bounds::kExtent, kUnit + kFlushed, model)};
}
/// The error of a height, of the radius that it is compared with, and of one rounded sum of it and this error.
mpq_class error_of(const frame::Height<ErrorBound>& height) {
  const mpq_class of_radius = kFlushed;
  return height.value.error + of_radius + kUnit * (height.value.magnitude() + height.error.high);
}

TEST(FrameBounds, OfHeightsCoverTheirComparison) {
  const frame::Height<ErrorBound> height = height_in(kAnyRounding);
  EXPECT_LE(error_of(height), height.error.low);
  EXPECT_GT(error_of(height), height.error.low * 15 / 16) << "it is loose";
}

TEST(FrameBounds, OfHeightsGrowWithEachCoordinate) {
  for (const double four : {4.0, -4.0})
    for (const Vector3<double>& from : {Vector3<double>{four, 0, 0}, {0, four, 0}, {0, 0, four}})
      EXPECT_EQ(frame::Height<double>(from, {1, 1, 1}, 0).size, 8);  // exact
}

// In the caller's unit of length everything is up to 2^900 times as small, so underflow costs as much more.
TEST(FrameBounds, OfHeightsCoverUnderflowInTheGivenUnit) {
  const ErrorModel given{kUnit, kAnyRounding.underflow * power(2, -Frame::kSubnormal), true};
  const frame::Height<ErrorBound> height = height_in(given);
  EXPECT_LE(error_of(height), height.error.low);
}

/// Two numbers in one register.
struct Pair {
  ErrorBound of[2];

  const ErrorBound& operator[](int i) const { return of[i]; }
  friend Pair operator+(const Pair& a, const Pair& b) { return {{a[0] + b[0], a[1] + b[1]}}; }
  friend Pair operator-(const Pair& a, const Pair& b) { return {{a[0] - b[0], a[1] - b[1]}}; }
  friend Pair operator*(const Pair& a, const Pair& b) { return {{a[0] * b[0], a[1] * b[1]}}; }
};

/// The error of a height in the caller's unit of length, and what its bound covers, each as a sum of three parts.
struct GivenHeightError {
  mpq_class error, covered;

  /// The largest number of the ball, the largest coordinate of the origin, the frame's unit.
  GivenHeightError(const mpq_class& ball, const mpq_class& origin, const mpq_class& unit) {
    // Numbers that are scaled down to the given unit may lose more than others.
    static const ErrorModel given{kUnit, kAnyRounding.underflow * power(2, -Frame::kSubnormal), true};
    const ErrorBound center = known(ball, 0, given), axis = known(1, kUnit, given), zero = known(0, 0, given);
    const ErrorBound from = known(origin, given.underflow, given);
    const ErrorBound plane = known(bounds::kExtent * unit, kUnit * unit + given.underflow, given);
    const ErrorBound height = frame::height_of_pairs<Pair>({{center, center}}, {{center, center}}, {{from, from}},
                                                           {{from, zero}}, {{axis, axis}}, {{axis, zero}}, plane);
    error = height.error;
    // As find_side adds them up.
    const auto exactly = [](const mpq_class& length) { return ErrorBound{&given, length, length, 0}; };
    covered =
        (frame::given_height_error(exactly(ball)) + frame::given_height_error(exactly(origin) + exactly(unit))).low;
  }
};

// Both are sums of the three lengths, times coefficients that are not negative, and of what underflows.
TEST(FrameBounds, OfGivenHeightsCoverEachPartOfTheirError) {
  const GivenHeightError least(0, 0, 1), of_ball(1, 0, 1), of_origin(0, 1, 1);
  EXPECT_LE(least.error, least.covered);
  for (const GivenHeightError& of : {of_ball, of_origin}) {
    EXPECT_LE(of.error - least.error, of.covered - least.covered);
    EXPECT_GT(of.error - least.error, (of.covered - least.covered) * 63 / 64) << "it is loose";
  }
}

/// How far the root of the computed square of the length of (x, y) may be from that of the exact numbers, if it is at
/// most `longest`: as much as (x, y) moves, and the rounding of the square.
mpq_class error_of_length(const ErrorBound& x, const ErrorBound& y, const mpq_class& longest) {
  static const mpq_class of_square = root_above(frame::squared_length(Ratio<52>{}, Ratio<52>{}).most) - 1;
  return root_above(power(x.error, 2) + power(y.error, 2)) + of_square * longest +
         root_above(3 * kAnyRounding.underflow);
}
mpq_class length(const ErrorBound& x, const ErrorBound& y) {
  return root_above(power(x.magnitude(), 2) + power(y.magnitude(), 2));
}

/// Edges are prepared in round to nearest.
const ErrorModel kNearest{kUnit / 2, kAnyRounding.underflow, true};

/// The elements of the map from two coordinates to the frame. They are rounded from double-doubles that follow from
/// normals known to NewellPlane::kError: their relative errors are at most eight times that.
ShearOf<ErrorBound> prepared_shear() {
  const mpq_class two_root = root_above(2), half_root = root_above(mpq_class(1, 2));
  const auto element = [](const mpq_class& magnitude) {
    return known(magnitude, magnitude * (kNearest.unit + 8 * NewellPlane::kError), kNearest);
  };
  // The plane is at most 3/4 above vertex 0, measured along the dropped axis, which the axes follow by at most 45
  // degrees.
  const ErrorBound origin = element(mpq_class(3, 4) * half_root);
  return {element(two_root), element(half_root), element(two_root), {origin, origin}};
}

/// A rounded difference of coordinates.
ErrorBound difference(const mpq_class& magnitude) { return known(magnitude, magnitude * kNearest.unit, kNearest); }

// A lifted vertex is a function of two coordinates, each within 1/4 of vertex 0.
TEST(FrameBounds, OfVerticesCoverTheirShear) {
  const ErrorBound coordinate = difference(mpq_class(1, 4));
  const PlanarPoint<ErrorBound> point = sheared_vertex(prepared_shear(), coordinate, coordinate);
  const mpq_class needed = std::max(point.x.error, point.y.error);
  EXPECT_LE(needed, bounds::kFramePoint * kUnit);
  EXPECT_GT(needed, bounds::kFramePoint * kUnit * 15 / 16) << "it is loose";
}

// Relative to an edge's length: none of its two coordinates is longer than the lifted edge. The square of a length has
// two roundings in a row, of which the root halves the effect; the root and the quotient have one each.
TEST(FrameBounds, OfDirectionsAndLengthsCoverRootsAndQuotients) {
  const PlanarPoint<ErrorBound> edge = sheared_edge(prepared_shear(), difference(1), difference(1));
  const mpq_class unit = kNearest.unit;
  const mpq_class length = root_above(power(edge.x.error, 2) + power(edge.y.error, 2)) + 2 * unit * (1 + 100 * unit);
  const mpq_class direction = (std::max(edge.x.error, edge.y.error) + length) * (1 + 100 * unit) + unit;
  EXPECT_LE(direction, bounds::kFrameDirection * kUnit);
  EXPECT_GT(direction, bounds::kFrameDirection * kUnit * 15 / 16) << "it is loose";
  EXPECT_LE(length * bounds::kExtent, bounds::kFrameLength * kUnit);
  EXPECT_GT(length * bounds::kExtent, bounds::kFrameLength * kUnit * 15 / 16) << "it is loose";
}

/// A foot as seen from an edge, all numbers as stored.
struct Edge {
  frame::FootFromEdge<ErrorBound> seen;

  Edge(const ErrorBound& foot, const ErrorBound& start, const ErrorBound& direction = known(1, 0),
       const ErrorBound& length = known(bounds::kExtent, 0))
      : seen(foot, foot, start, start, direction, direction, length) {}
  [[nodiscard]] mpq_class longest() const { return length(seen.across, seen.overshoot); }
  [[nodiscard]] mpq_class error(const mpq_class& distance) const {
    return error_of_length(seen.across, seen.overshoot, distance);
  }
};

// All numbers are exact.
TEST(FrameBounds, AreAboutTheSquaredDistance) {
  for (const auto& [x, y] : {std::pair{-3.0, 4.0}, {-3.0, -4.0}, {2.0, 5.0}, {0.0, -5.0}, {7.0, 4.0}, {4.0, 5.0}})
    EXPECT_EQ(frame::FootFromEdge<double>(x, y, 0, 0, 1, 0, 4).squared, 25) << x << ' ' << y;
  for (const auto& [x, y] : {std::pair{6.0, 6.0}, {-6.0, -6.0}, {1.0, 7.0}, {-8.0, 2.0}, {8.0, -1.0}})
    EXPECT_EQ(frame::FootFromBox<double>(x, y, 0, 0, 0, 1, 2, 3).squared, 25) << x << ' ' << y;
  EXPECT_EQ(frame::FootFromBox<double>(3, -2, 0, 0, 0, 1, 2, 3).squared, 0);
}

TEST(FrameBounds, OfDistancesCoverRoots) {
  const auto in_units = [](const mpq_class& magnitude, const mpq_class& units) {
    return known(magnitude, units * kUnit);
  };
  const Edge edge(in_units(kSize, bounds::kCoordinate), in_units(bounds::kExtent, bounds::kFramePoint),
                  in_units(1, bounds::kFrameDirection), in_units(bounds::kExtent, bounds::kFrameLength));
  // A flushed coordinate of the centre moves the foot, a flushed radius the bound that the distance is held to. So does
  // a disc whose square underflows.
  const mpq_class needed = edge.error(edge.longest()) + 8 * kFlushed + root_above(3 * kAnyRounding.underflow);
  EXPECT_LE(needed, distance_error().low);
  EXPECT_GT(needed, bounds::kDistance * kUnit * kSize * 63 / 64) << "it is loose";
}

// The square covers the roundings of the roots, too.
TEST(FrameBounds, OfDistancesCoverTheirRoundings) {
  const Ratio<52> distance = frame::distance_at_least(Ratio<52>{});
  EXPECT_GE(distance.least, 1);
  EXPECT_GE(frame::square_at_least(distance, distance).least, 1);
}

TEST(FrameBounds, OfDiscsCoverTheirRoundings) {
  const frame::Disc<Ratio<52>> disc({}, {}, {}, {});
  EXPECT_GE(disc.outer_sq.least, 1);
  EXPECT_LE(disc.inner_sq.most, 1);
  EXPECT_LT(disc.outer_sq.least, 1 + (mpq_class(bounds::kWide) - 1) * 3 / 4) << "it is loose";
  EXPECT_GT(disc.inner_sq.most, 1 - (1 - mpq_class(bounds::kNarrow)) * 3 / 4) << "it is loose";
}

// What the ratios are of: the disc at `low`, made larger by the error, and that at `high`, made smaller.
TEST(FrameBounds, OfDiscsCoverTheirErrors) {
  long inner = 0;
  for (std::uint64_t index = 0; index < 10'000; ++index) {
    workloads::Random random(2026, index, 94);
    const double radius = random.unit(), low = radius * random.unit(), high = low + random.unit() * (radius - low) / 2;
    const double error = std::abs(random.log_uniform(-60, -1));
    const frame::Disc<double> disc(radius, low, high, error);
    const auto chord_sq = [&](double distance) {
      return mpq_class(mpq_class(radius) * radius - mpq_class(distance) * distance);
    };
    EXPECT_GE(power(root_below(disc.outer_sq) - error, 2), chord_sq(low)) << index;
    if (disc.inner_sq <= 0) continue;
    EXPECT_LE(power(root_above(disc.inner_sq) + error, 2), chord_sq(high)) << index;
    ++inner;
  }
  EXPECT_GT(inner, 1000);
}

/// The least distance that may be taken for one beyond `boundary_sq`.
mpq_class near_distance() { return root_below(frame::boundary_square(distance_error()).low); }

/// How far foot and vertices as stored may be from the exact ones, both together.
mpq_class stored_off() {
  const mpq_class foot = bounds::kCoordinate * kUnit + 3 * kFlushed, vertex = bounds::kFramePoint * kUnit;
  return root_above(2 * power(foot, 2)) + root_above(2 * power(vertex, 2));
}

/// An edge that starts where it is stored and has the stored direction and length ends near its stored end: both ends
/// and the direction are off in two coordinates, and the length is off.
mpq_class ends_apart() {
  const mpq_class coordinate =
      2 * mpq_class(bounds::kFramePoint) + bounds::kFrameDirection * mpq_class(bounds::kExtent);
  return kUnit * (root_above(2 * power(coordinate, 2)) + bounds::kFrameLength);
}

// Off the edge even where both the distance and its bound are off, and by so much more that what is stored of the edge
// and of the foot may be taken for the exact ones: a point that moves by less than its distance crosses nothing.
TEST(FrameBounds, NearIsFurtherThanAllThatIsStoredMayBeOff) {
  EXPECT_GT(near_distance() - distance_error().high, stored_off());
  EXPECT_LE(near_distance(), bounds::kNear * distance_error().high);
  // Within the box that is upright about both stored ends nothing overshoots them: the distance is the one across, of
  // the sign that tells the sides, unless both ends are apart.
  const Edge stored(known(2 * bounds::kExtent, 0), kZero);
  EXPECT_GT(near_distance(), stored.error(stored.longest()) + stored.seen.overshoot.error + 2 * ends_apart());
}

// exact_foot asks for signs where a vertex is within the margin, the root of `boundary_sq`, of the foot's height.
TEST(FrameBounds, NearIsFurtherThanHeightsInThePlaneMayBeOff) {
  EXPECT_GT(near_distance(), stored_off() + kUnit * (kSize + bounds::kExtent));
}

/// A foot as seen from a box, all numbers as stored, the one at most `away` from the other's centre in each coordinate.
struct BoxInView {
  frame::FootFromBox<ErrorBound> seen;

  explicit BoxInView(const ErrorBound& foot)
      : seen(foot, foot, kZero, kZero, known(1, 0), known(1, 0), known(bounds::kExtent, 0), known(bounds::kExtent, 0)) {
  }
  explicit BoxInView(const mpq_class& away) : BoxInView(known(away, 0)) {}
  /// Of a distance to it.
  [[nodiscard]] mpq_class error(const mpq_class& distance) const {
    return error_of_length(seen.beside, seen.above, distance);
  }
};

// A foot that is close to an edge or a box is no farther from the one's start, or the other's middle, than vertices are
// from each other. Farther away `kClose` is much more than any error is; for a foot beyond kFar errors grow as
// distances do. An axis whose length is off by a few units stretches distances.
const mpq_class kClose = mpq_class(0x1p-20), kFar = 4;

/// The square up to which boxes are looked at, where edges are up to 1.
mpq_class box_reach() { return frame::box_reach(ErrorBound{&kAnyRounding, 1, 1, 0}).low; }

// A box holds the ends of its edges as stored.
TEST(FrameBounds, BoxesAreReachedWhereTheirEdgesAre) {
  // As much as the root of kBoxReach allows for, of a distance from `boundary_sq` on.
  const mpq_class wider = root_below(box_reach() * (1 - 3 * kUnit)) * (1 - kUnit) - 1;
  const auto needed = [&](const mpq_class& away, const mpq_class& distance) -> mpq_class {
    return BoxInView(away).error(distance) + Edge(known(away, 0), kZero).error(distance) + ends_apart() +
           8 * kUnit * distance;
  };
  const mpq_class extent = bounds::kExtent;
  EXPECT_LE(needed(extent + kClose, 2 * kClose), wider * near_distance());
  EXPECT_GT(needed(extent + kClose, 2 * kClose), wider * near_distance() * 15 / 16) << "kNear is loose";
  EXPECT_LE(wider, root_above(bounds::kBoxReach) - 1);
  EXPECT_LE(needed(kFar + extent, 2 * (kFar + extent)), wider * kClose);
}

// The exact foot, too, is off a box that is not reached, and on the side that is computed: of the two sides the larger
// is at least so far off.
TEST(FrameBounds, BoxesThatAreNotReachedAreOnTheirSide) {
  const mpq_class off = root_below(box_reach() / 2) * (1 - 4 * kUnit), extent = bounds::kExtent;
  const auto needed = [&](const mpq_class& away, const mpq_class& distance) -> mpq_class {
    const BoxInView box(away);
    return box.seen.beside.error + box.seen.along.error + stored_off() + 8 * kUnit * distance;
  };
  EXPECT_LE(needed(extent + kClose, 2 * kClose), off * near_distance());
  EXPECT_LE(needed(kFar + extent, 2 * (kFar + extent)), off * kClose);
}

// A group's box, built rounding to nearest: a point's coordinates along the box's axis and across it differ from those
// of the centre by at most half of what they extend, and by what the axis' length and all roundings make of them.
TEST(FrameBounds, BoxesHoldTheirPoints) {
  const ErrorBound x = known(bounds::kExtent, 0, kNearest), y = known(bounds::kExtent, 0, kNearest);
  const ErrorBound axis_x = known(1, 0, kNearest), axis_y = known(1, 0, kNearest);
  const ErrorBound point = frame::turned_along(x, y, axis_x, axis_y);
  // The middle of the least and the most: their sum is rounded, half of it is not.
  const mpq_class reach = root_above(2) * mpq_class(bounds::kExtent);
  const mpq_class middle = kNearest.unit * reach;
  const ErrorBound m = known(reach, 0, kNearest);
  const ErrorBound center = frame::turned_along(m, m, axis_x, axis_y);
  // Components of the axis: a difference, the length that it is divided by to within two units, a quotient.
  const mpq_class axis_length_squared = power(1 + kNearest.unit, 8) - 1;
  const mpq_class half = kNearest.unit * 2 * reach;
  const mpq_class needed = point.error + middle + reach * axis_length_squared + root_above(2) * center.error + half;
  EXPECT_LE(needed, mpq_class(bounds::kBoxRounding) * (1 - kNearest.unit));
  EXPECT_GT(needed, mpq_class(bounds::kBoxRounding) / 2) << "it is loose";
}

}  // namespace
}  // namespace touchstone::proofs::frame_bounds
