// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of bounds.h in exact rationals: a second proof beside Gappa's, rounding of the bound, underflow.
#include "robust/filtered/detail/signs/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>

#include "robust/proofs/error_bound.h"
#include "robust/proofs/expressions.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs {
namespace {

const mpq_class kUnits[] = {bounds::kUnit, bounds::kDoubleDoubleUnit, bounds::kFloatUnit};
/// As they are compiled for double-doubles.
const SumsOfProducts kSumsOfProducts{bounds::kDot, bounds::kCross};

mpq_class power_of_two(int exponent) {
  const mpz_class power = mpz_class(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent < 0 ? mpq_class(1, power) : mpq_class(power);
}

std::string name(const Claim& claim) { return std::string(claim.constant) + " " + std::string(claim.instance); }

/// The constant that the error calculus gives. Maxima are 1: relative errors scale with them.
template <class Expression>
mpq_class proved(const mpq_class& unit, const std::optional<SumsOfProducts>& sums_of_products, const Claim& claim,
                 const Expression& expression) {
  const ErrorModel model{unit, 0, !claim.squares_are_products(), sums_of_products};
  const auto inputs =
      make_inputs<ErrorBound>([&](const Input& input) { return known_within(model, 1, input.error * unit); });
  return expression(inputs).error / (unit * claim.factor);
}

TEST(Bounds, HoldInTheRationalErrorCalculus) {
  for (const mpq_class& unit : kUnits) {
    for_each_claim([&](const Claim& claim, const auto& expression) {
      const mpq_class constant = proved(unit, std::nullopt, claim, expression);
      EXPECT_LE(constant, claim.value - kRoundingOfBound) << name(claim);
      EXPECT_GT(constant, claim.value - 4 * kRoundingOfBound) << name(claim) << " is loose";
    });
  }
}

TEST(Bounds, HoldForTheSumsOfProductsOfDoubleDoubles) {
  for_each_claim([](const Claim& claim, const auto& expression) {
    const mpq_class constant = proved(bounds::kDoubleDoubleUnit, kSumsOfProducts, claim, expression);
    EXPECT_LE(constant, claim.value - kRoundingOfBound) << name(claim);
    EXPECT_GT(constant, claim.value - 4 * kRoundingOfBound) << name(claim) << " is loose";
  });
}

/// How many claims would not hold.
int broken_by(const SumsOfProducts& sums_of_products) {
  int broken = 0;
  for_each_claim([&](const Claim& claim, const auto& expression) {
    const mpq_class constant = proved(bounds::kDoubleDoubleUnit, sums_of_products, claim, expression);
    broken += constant > claim.value - kRoundingOfBound;
  });
  return broken;
}

TEST(Bounds, DoNotHoldForWorseSumsOfProducts) {
  EXPECT_EQ(broken_by(kSumsOfProducts), 0);
  EXPECT_GT(broken_by({kSumsOfProducts.dot + mpq_class(1, 4), kSumsOfProducts.cross}), 0);
  EXPECT_GT(broken_by({kSumsOfProducts.dot, kSumsOfProducts.cross + mpq_class(1, 4)}), 0);
}

// Each of n maxima may be short by kExcess. The bound is a product of n + 1 numbers, some of them products that were
// formed before and used twice, and a sum; a double-double's high part is compared with it. 2 n + 3 roundings in any
// direction are more than all that takes.
mpq_class to_spare(const Claim& claim) {
  const std::size_t n = claim.maxima.size();
  return claim.value * power(1 - mpq_class(bounds::kUnit), 2 * n + 3) -
         (claim.value - kRoundingOfBound) * power(1 + mpq_class(kExcess), n);
}

TEST(Bounds, CoverTheirOwnRounding) {
  for_each_claim([](const Claim& claim, const auto&) { EXPECT_GT(to_spare(claim), 0) << name(claim); });
}

// What the bound has to spare is then more than what underflow can do.
TEST(Bounds, NeedNoTinyFromTheSmallestMaximaOn) {
  for_each_claim([](const Claim& claim, const auto&) {
    mpq_class product = claim.factor;
    for (const Maximum maximum : claim.maxima) product *= smallest(maximum);
    EXPECT_GT(to_spare(claim) * bounds::kUnit * product, bounds::kTiny) << name(claim);
  });
}

// A high part is short of its double-double by half a unit in the last place at most, the product m_u m_v by its
// rounding; a component of the normal has been rounded twice.
TEST(Bounds, AllowForMaximaThatAreShort) {
  const mpq_class unit = bounds::kUnit, high_part = 0x1p-53;
  EXPECT_LE(power(1 + unit, 2) / (1 - unit), 1 + mpq_class(kExcess));
  EXPECT_LE(power((1 + high_part) * (1 + mpq_class(bounds::kDoubleDoubleUnit)), 2) / (1 - high_part),
            1 + mpq_class(kExcess));
}

// What underflow adds is a polynomial in the maxima without negative coefficients, so it is largest where they are; so
// is the magnitude of every intermediate result. Normals and feet have been computed and bring theirs with them.
class Underflow : public testing::Test {
 protected:
  const mpq_class operation_ = power_of_two(-1021), earlier_ = power_of_two(-940);

  ErrorBound at_largest_maxima(const ErrorModel& model, const Input& input) const {
    const mpq_class maximum = largest(input.maximum) * (1 + mpq_class(kExcess));
    const bool was_computed = input.maximum == Maximum::Normal || input.name.starts_with("foot");
    const mpq_class underflow = model.underflow == 0 ? mpq_class(0) : was_computed ? earlier_ : operation_;
    return known_within(model, maximum + underflow, input.error * model.unit * maximum + underflow);
  }

  template <class Expression>
  ErrorBound bound(const ErrorModel& model, const Expression& expression) const {
    return expression(make_inputs<ErrorBound>([&](const Input& input) { return at_largest_maxima(model, input); }));
  }

  template <class Expression>
  mpq_class damage(const mpq_class& unit, const Expression& expression,
                   const std::optional<SumsOfProducts>& sums_of_products = std::nullopt) const {
    return bound({unit, operation_, false, sums_of_products}, expression).error -
           bound({unit, 0, false, sums_of_products}, expression).error;
  }
};

TEST_F(Underflow, IsCoveredByTiny) {
  for (const mpq_class& unit : kUnits) {
    for_each_claim([&](const Claim& claim, const auto& expression) {
      // In the product that is the bound every operation may lose as much, times the maxima that follow.
      mpq_class lost_in_bound = operation_ * (2 * claim.maxima.size() + 2);
      for (const Maximum maximum : claim.maxima) lost_in_bound *= largest(maximum);
      EXPECT_LE(damage(unit, expression) + lost_in_bound, bounds::kTiny / 2) << name(claim);
      EXPECT_LE(damage(unit, expression, kSumsOfProducts) + lost_in_bound, bounds::kTiny / 2) << name(claim);
    });
  }
}

TEST_F(Underflow, OfNormalsAndFeetIsWhatTheyBringAlong) {
  for_each_claim([&](const Claim& claim, const auto& expression) {
    if (claim.constant != "kNormal" && claim.constant != "kCoordinate") return;
    EXPECT_LE(damage(bounds::kUnit, expression), earlier_) << name(claim);
  });
}

TEST_F(Underflow, HasNoCounterpartAbove) {
  for_each_claim([&](const Claim& claim, const auto& expression) {
    EXPECT_LE(bound({bounds::kUnit, operation_, false}, expression).magnitude(), power_of_two(500)) << name(claim);
  });
}

}  // namespace
}  // namespace touchstone::proofs
