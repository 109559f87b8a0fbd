// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that carry their error: no exact value is ever farther away than the error says, in every rounding mode.
#include "robust/filtered/detail/numbers/bounded.h"

#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "tests/robust/support/environment.h"
#include "tests/robust/support/rational_plane.h"

namespace touchstone::contact_tests {
namespace {

using filtered::detail::Bounded;
using filtered::detail::BoundedVector;
using filtered::detail::DoubleDouble;
using filtered::detail::Pack;

mpq_class value_of(const Bounded<Pack>& number) {
  double lanes[filtered::detail::kLanes];
  store(lanes, number.value);
  return lanes[0];
}
mpq_class value_of(const Bounded<DoubleDouble>& number) {
  return mpq_class(number.value.high) + mpq_class(number.value.low);
}
mpq_class error_of(const Bounded<Pack>& number) {
  double lanes[filtered::detail::kLanes];
  store(lanes, number.error);
  return lanes[0];
}
mpq_class error_of(const Bounded<DoubleDouble>& number) { return number.error; }

/// A vector with an error, and what it may stand for: each component off by this share of the error.
struct Given {
  double value[3];
  double error;
  double share[3];

  template <class Number>
  [[nodiscard]] BoundedVector<Number> bounded() const {
    const auto number = [](double x) { return filtered::detail::constant<Number>(x); };
    const double largest = std::max({std::abs(value[0]), std::abs(value[1]), std::abs(value[2])});
    return {{number(value[0]), number(value[1]), number(value[2])},
            filtered::detail::constant<filtered::detail::ErrorOf<Number>>(largest),
            filtered::detail::constant<filtered::detail::ErrorOf<Number>>(error)};
  }
  [[nodiscard]] Rationals exact() const {
    const auto component = [this](int i) {
      return mpq_class(mpq_class(value[i]) + mpq_class(error) * mpq_class(share[i]));
    };
    return {component(0), component(1), component(2)};
  }
};

Given draw_vector() {
  const auto coordinate = [] {
    return std::ldexp(*rc::gen::inRange(-(1 << 26), (1 << 26) + 1), *rc::gen::inRange(-34, -22)) +
           std::ldexp(*rc::gen::inRange(0, 1 << 26), -52);
  };
  const auto share = [] { return *rc::gen::element(-1.0, -0.5, 0.0, 0.25, 1.0); };
  return {{coordinate(), coordinate(), coordinate()},
          std::ldexp(1.0, *rc::gen::inRange(-80, -30)),
          {share(), share(), share()}};
}

/// Asserts that the exact value lies within the error, widened as the signs widen it.
template <class Number>
void expect_within(const Bounded<Number>& number, const mpq_class& exact) {
  RC_ASSERT(abs(value_of(number) - exact) <= mpq_class(filtered::detail::bounds::kWideError) * error_of(number));
  if ((filtered::detail::positive(number) & 1) != 0) RC_ASSERT(exact > 0);
  if ((filtered::detail::negative(number) & 1) != 0) RC_ASSERT(exact < 0);
}

/// The operations that motions need, in one expression each.
template <class Number>
struct Results {
  Bounded<Number> product, gap, discriminant, time, length;

  explicit Results(const Given (&given)[3]) {
    const auto a = given[0].bounded<Number>(), b = given[1].bounded<Number>(), c = given[2].bounded<Number>();
    const auto m = filtered::detail::cross(a, b), n = filtered::detail::cross(a, c);
    product = filtered::detail::dot(m, n);
    gap = filtered::detail::dot(m, m) - filtered::detail::dot(n, n);
    discriminant = filtered::detail::square(product) - filtered::detail::dot(m, m) * filtered::detail::dot(n, n);
    length = filtered::detail::root(filtered::detail::dot(a, a));
    time = filtered::detail::quotient(product, filtered::detail::dot(a, a));
  }
};

template <class Number>
void expect_bounds(const Given (&given)[3], const Results<Number>& found) {
  const auto a = given[0].exact(), b = given[1].exact(), c = given[2].exact();
  const auto m = cross(a, b), n = cross(a, c);
  const mpq_class product = dot(m, n);
  expect_within(found.product, product);
  expect_within(found.gap, mpq_class(dot(m, m) - dot(n, n)));
  expect_within(found.discriminant, mpq_class(product * product - dot(m, m) * dot(n, n)));
  const mpq_class squared = dot(a, a);
  // Where the square is certainly positive the root lies within its error, and so does the quotient.
  const auto certain = filtered::detail::dot(given[0].bounded<Number>(), given[0].bounded<Number>());
  if ((filtered::detail::positive(certain) & 1) == 0) return;
  const mpq_class range = mpq_class(filtered::detail::bounds::kWideError) * error_of(found.length);
  const mpq_class low = value_of(found.length) - range, high = value_of(found.length) + range;
  RC_ASSERT(low <= 0 || low * low <= squared);
  RC_ASSERT(high * high >= squared);
  expect_within(found.time, mpq_class(product / squared));
}

RC_GTEST_PROP(Bounded, HoldsInLanesInEveryRoundingMode, ()) {
  const Given given[] = {draw_vector(), draw_vector(), draw_vector()};
  for (const int mode : kModes) {
    std::vector<Results<Pack>> found;
    {
      const Environment environment(mode, Environment::kBoth);
      found.emplace_back(given);
    }
    expect_bounds(given, found.front());
  }
}

RC_GTEST_PROP(Bounded, HoldsInDoubleDoubles, ()) {
  const Given given[] = {draw_vector(), draw_vector(), draw_vector()};
  expect_bounds(given, Results<DoubleDouble>(given));
}

// Errors must be small enough to be of use: known vectors give numbers to within some dozen roundings.
TEST(Bounded, IsTight) {
  const Given given[] = {{{1, 2, 3}, 0, {}}, {{-3, 1, 2}, 0, {}}, {{2, -1, 5}, 0, {}}};
  const Results<Pack> lanes(given);
  EXPECT_LT(error_of(lanes.product).get_d(), 0x1p-38);
  EXPECT_LT(error_of(Results<DoubleDouble>(given).product).get_d(), 0x1p-88);
}

}  // namespace
}  // namespace touchstone::contact_tests
