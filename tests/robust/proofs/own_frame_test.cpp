// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of own frames, in rationals: what sums of three products may lose, however they are added.
#include "robust/scene/detail/own_frame.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/filtered/detail/signs/bounds.h"
#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::own_frame {
namespace {

using namespace scene::detail::own_frame;
namespace bounds = filtered::detail::bounds;

const mpq_class kMost = kMostResidual;

/// The relative error of a number that was rounded that number of times.
mpq_class roundings(std::size_t count) { return power(1 + kU, count) - 1; }

/// The error of a row or a column of A R - I, whose sums of magnitudes are at most |A's row| |R's column|; both norms
/// are at most 1 + 2 h times 1 / s and s. A product is rounded three times at most. The identity is then subtracted
/// from at most 1 + 2 h, and the sum of three magnitudes, of at most 2 h each, rounded twice.
mpq_class residual_error() {
  const mpq_class norms = power(1 + 2 * kMost, 2);
  const mpq_class entry = roundings(3) * norms + kU * 2 * kMost;
  return 3 * entry + roundings(2) * 6 * kMost;
}

// The residual is also that of R^T R / s^2, from which A R differs by the rounding of A and of s^2, and |R| is at most
// (1 + h) s, as half of the residual is left for the rounding of s: a root, a quotient, a square.
TEST(OwnFrameBounds, CoverTheResidual) {
  EXPECT_LE(residual_error(), mpq_class(kResidual));
  EXPECT_GT(residual_error(), mpq_class(kResidual) * 3 / 4) << "it is loose";
  EXPECT_LE(3 * kU, mpq_class(kResidual) / 2);
}

// Each component of c - t is rounded once, and its product three times; a column of A is not longer than |A|. The sum D
// is computed from components that were rounded, with two additions. Under the pose, |R| |A| <= (1 + h)^2.
mpq_class center_error() { return roundings(4) * (1 + kU) / (1 - roundings(3)) * power(1 + kMost, 2); }

TEST(OwnFrameBounds, CoverTheCentre) {
  EXPECT_LE(center_error(), mpq_class(kCenter));
  EXPECT_GT(center_error(), mpq_class(kCenter) * 9 / 10) << "it is loose";
}

TEST(OwnFrameBounds, CoverLengthsThatFollowFromTheCentre) {
  const ErrorModel model{kU, kSmallestDouble, true};
  const auto exactly = [&](double number) { return ErrorBound{&model, number, number, 0}; };
  for (const double a : {0.0, 1.0, 1000.0})
    for (const double b : {0.0, 1.0, 1000.0})
      for (const double spread : {0x1p-20, 1.0, 1000.0}) {
        const mpq_class of_radius = 2 * mpq_class(a) + b + center_error() * 2 * spread;
        EXPECT_GE(outer_radius(exactly(a), exactly(2), exactly(b), exactly(spread)).low, of_radius);
        EXPECT_GE(lost(exactly(a), exactly(b), exactly(spread)).low, a + (b + center_error()) * spread);
      }
}

// Three coordinates, each off by half a unit in the last place: u times the exact value.
TEST(OwnFrameBounds, CoverTheRoundingOfVertices) {
  EXPECT_LE(3 * kU * kU, power(mpq_class(kRounding) / (1 + mpq_class(kRounding)), 2));
  EXPECT_GT(3 * kU * kU, power(mpq_class(kRounding) * 19 / 20, 2)) << "it is loose";
}

// No length takes more than eight roundings in a row after the numbers above.
TEST(OwnFrameBounds, CoverTheRoundingOfLengths) {
  EXPECT_LE(roundings(8), mpq_class(kWide) - 1);
  EXPECT_LE(roundings(8), 1 - mpq_class(kNarrow));
}

// The components of the normal of two edges, in units of their largest components, of which no edge is shorter.
TEST(OwnFrameBounds, CoverTheNormal) {
  const mpq_class component = 2 * mpq_class(bounds::kNormal) * mpq_class(bounds::kUnit);
  EXPECT_LE(3 * component * component, power(mpq_class(0x1p-48), 2));
}

}  // namespace
}  // namespace touchstone::proofs::own_frame
