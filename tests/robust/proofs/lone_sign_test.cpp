// SPDX-License-Identifier: GPL-3.0-or-later
// The last step of a lone sign (numbers/lane_vector.h) in rationals: high and low parts are subtracted each for
// themselves, and the bound is that of a difference of double-doubles.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <vector>

#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/signs/signs.h"
#include "robust/proofs/error_bound.h"
#include "robust/proofs/expressions.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::lone_sign {
namespace {

const mpq_class kUnit = bounds::kDoubleDoubleUnit;
const ErrorModel kDoubleDoubles{kUnit, 0, true, SumsOfProducts{bounds::kDot, bounds::kCross}};

/// What a sign subtracts, and from what.
struct Terms {
  ErrorBound from, subtracted;
};
struct Radius {
  ErrorBound value;
};
struct RadiusTerm {
  ErrorBound value;
};
RadiusTerm operator*(const Radius& a, const Radius& b) { return {a.value * b.value}; }
RadiusTerm operator*(const RadiusTerm& a, const ErrorBound& b) { return {a.value * b}; }
Terms operator-(const ErrorBound& a, const RadiusTerm& b) { return {a, b.value}; }

/// The constant that a sign needs if the low parts are at most `from` and `subtracted` u times their terms.
///
/// Let d be the difference of the computed terms, and l that of their low parts. What is computed is
/// ((d - l)(1 + d1) + l (1 + d2))(1 + d3) with |di| <= u, which is d (1 + d1)(1 + d3) up to 2 u (1 + u) |l|. If it is
/// larger than (1 + u)^2 times the error of d and that rest, d has the exact sign, and so has what is computed.
mpq_class needed(const Terms& terms, int from, int subtracted) {
  const mpq_class low = kU * (from * terms.from.magnitude() + subtracted * terms.subtracted.magnitude());
  const mpq_class error = exact_difference(terms.from, terms.subtracted).error;
  return (power(1 + kU, 2) * error + 2 * kU * (1 + kU) * low) / kUnit;
}

struct Sign {
  double constant;
  Terms terms;
};

/// The signs on which alone contact may depend, with maxima of 1.
std::vector<Sign> lone_signs() {
  const auto in =
      make_inputs<ErrorBound>([](const Input& input) { return known_within(kDoubleDoubles, 1, input.error * kUnit); });
  const Radius radius{in.radius};
  return {{bounds::kVertex, signs::vertex(in.to_center, radius)},
          {bounds::kLine, signs::line(in.to_center, in.edge, radius)},
          {bounds::kPlane, signs::plane(in.normal, in.to_center, radius)}};
}

// The low part of a normalised double-double is at most u (1 + u) of it. Of a product it is the rest of the rounding
// and two products with a low part, each u of the whole; and the roundings of these.
TEST(LoneSign, MaySubtractHighAndLowPartsEachForThemselves) {
  EXPECT_LE(3 * power(1 + kU, 8), 4);
  for (const Sign& sign : lone_signs())
    EXPECT_LE(needed(sign.terms, 2, 4), sign.constant - kRoundingOfBound) << sign.constant;
}

TEST(LoneSign, MayNotHaveLowPartsOfAnySize) {
  for (const Sign& sign : lone_signs()) EXPECT_GT(needed(sign.terms, 16, 16), sign.constant) << sign.constant;
}

}  // namespace
}  // namespace touchstone::proofs::lone_sign
