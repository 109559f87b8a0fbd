// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of own frames: the functions of own_frame.h, over numbers that count or bound their roundings.
#include "robust/scene/detail/own_frame.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/filtered/detail/numbers/permanent.h"
#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/ratio.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::filtered::detail {
template <int Roundings>
constexpr Permanent<Roundings> magnitude(const Permanent<Roundings>& a) {
  return {a.value < 0 ? -a.value : a.value, a.permanent};
}
}  // namespace touchstone::filtered::detail

namespace touchstone::proofs::own_frame {
namespace {

using namespace scene::detail::own_frame;

const mpq_class kMost = kMostResidual;

/// The relative error of a number that was rounded that number of times.
mpq_class roundings(int count) { return power(1 + kU, static_cast<std::size_t>(count)) - 1; }

/// How often a monomial of the expression is rounded: the type counts.
template <int Roundings>
constexpr int counted(const Permanent<Roundings>&) {
  return Roundings;
}
constexpr Vector3<Permanent<0>> kVector{};

/// A coordinate of a centre or of t: nothing but a difference of two is known to a rounding of itself.
struct Coordinate {
  friend constexpr Permanent<1> operator-(Coordinate, Coordinate) { return {}; }
};
constexpr Vector3<Coordinate> kPoint{};

/// The error of a row or a column of A R - I, whose sums of magnitudes are at most |A's row| |R's column|; both norms
/// are at most 1 + 2 h times 1 / s and s. The identity is then subtracted from at most 1 + 2 h, and the sum of three
/// magnitudes, of at most 2 h each, rounded twice.
mpq_class residual_error() {
  const mpq_class norms = power(1 + 2 * kMost, 2);
  const mpq_class of_entry = roundings(counted(entry(kVector, kVector))) * norms + kU * 2 * kMost;
  return 3 * of_entry + roundings(2) * 6 * kMost;
}

// The residual is also that of R^T R / s^2, from which A R differs by the rounding of A and of s^2, and |R| is at most
// (1 + h) s, as half of the residual is left for the rounding of s: a root, a quotient, a square.
TEST(OwnFrameBounds, CoverTheResidual) {
  EXPECT_LE(residual_error(), mpq_class(kResidual));
  EXPECT_GT(residual_error(), mpq_class(kResidual) * 3 / 4) << "it is loose";
  EXPECT_LE(3 * kU, mpq_class(kResidual) / 2);
}

// A column of A is not longer than |A|, and D is computed. Under the pose, |R| |A| <= (1 + h)^2.
mpq_class center_error() {
  return roundings(counted(coordinate(kVector, kPoint, kPoint))) / (1 - roundings(counted(spread(kPoint, kPoint)))) *
         power(1 + kMost, 2);
}

TEST(OwnFrameBounds, CoverTheCentre) {
  EXPECT_LE(center_error(), mpq_class(kCenter));
  EXPECT_GT(center_error(), mpq_class(kCenter) * 9 / 10) << "it is loose";
}

TEST(OwnFrameBounds, CoverLengthsThatFollowFromTheCentre) {
  const ErrorModel model{kU, kSmallestDouble, true};
  const auto exactly = [&](double number) { return ErrorBound{&model, number, number, 0}; };
  for (const double a : {0.0, 1.0, 1000.0})
    for (const double b : {0.0, 1.0, 1000.0})
      for (const double far : {0x1p-20, 1.0, 1000.0}) {
        const Lengths<ErrorBound> lengths{exactly(3), exactly(2), exactly(a), exactly(b)};
        const mpq_class of_radius = 2 * mpq_class(a) + b + center_error() * 2 * far;
        EXPECT_GE(outer_radius(exactly(a), lengths, exactly(far)).low, of_radius);
        EXPECT_GE(lost(lengths, exactly(b), exactly(far)).low, a + (b + center_error()) * far);
      }
}

// Three coordinates, each off by half a unit in the last place: u times the exact value.
TEST(OwnFrameBounds, CoverTheRoundingOfVertices) {
  EXPECT_LE(3 * kU * kU, power(mpq_class(kRounding) / (1 + mpq_class(kRounding)), 2));
  EXPECT_GT(3 * kU * kU, power(mpq_class(kRounding) * 19 / 20, 2)) << "it is loose";
}

// kTiny exceeds what underflow takes.
TEST(OwnFrameBounds, CoverTheRoundingOfLengths) {
  const Ratio<53> exact;
  const auto of_pose = lengths(exact, exact, exact, exact);
  for (const auto& length : {of_pose.longer, of_pose.shorter, of_pose.rounding, of_pose.margin})
    EXPECT_GE(length.least, 1);
  const auto off = lost(of_pose, exact, exact);
  EXPECT_GE(outer_radius(exact, of_pose, exact).least, 1);
  EXPECT_LE(inner_radius(exact, of_pose, off).most, 1);
  EXPECT_GE(radius_under_pose(exact, of_pose, off).least, 1);
  EXPECT_GE(thinnest_altitude(of_pose, exact).least, 1);
}

TEST(OwnFrameBounds, CoverTheRoundingOfDistances) {
  const Ratio<53> exact;
  EXPECT_GE(length_at_least(Vector3<Ratio<53>>{}).least, 1);
  EXPECT_GE(sum_at_least(exact, exact).least, 1);
  EXPECT_LE(3 * kSmallestDouble, power(mpq_class(kTinyLength), 2));  // three squares underflow
}

/// The length of a side: a difference of vertices has a relative error in each component.
const Ratio<53> kComponent = Ratio<53>{}.rounded();
const Vector3<Ratio<53>> kSideRatios{kComponent, kComponent, kComponent};
const Ratio<53> kSide = length(kSideRatios);

// Of a normal, besides the error of its components: the root of a sum of squares.
const Ratio<53> kLength = length(Vector3<Ratio<53>>{});

// Components are in units of the largest of the two sides, than which the longest side is not shorter.
TEST(OwnFrameBounds, CoverTheNormal) {
  const ErrorModel model{kU, kSmallestDouble / power(mpq_class(kShortest), 2), true};
  const ErrorBound component = known_within(model, 1, kU);
  const Vector3<ErrorBound> side{component, component, component};
  const mpq_class off = cross(side, side).x.error;
  EXPECT_LE(root_above(3 * off * off) * kLength.most, mpq_class(kNormal) * off_normal(kSide).least);
  EXPECT_GT(root_above(3 * off * off), mpq_class(kNormal) / 4) << "it is loose";
}

// The difference of the length and its error is at most the exact length, rounded.
TEST(OwnFrameBounds, CoverTheRoundingOfAltitudes) {
  const Ratio<53> area = kLength.rounded();
  EXPECT_LE(altitude_at_most(area, kSide).most, 1);
}

}  // namespace
}  // namespace touchstone::proofs::own_frame
