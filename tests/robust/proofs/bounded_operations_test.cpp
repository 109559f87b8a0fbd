// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that carry their error: each operation covers what it adds to the errors of its operands, in rationals over
// the operations that are compiled.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "robust/filtered/detail/numbers/bounded.h"
#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/ratio.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::bounded {
namespace {

/// A number in place of lanes or of double-doubles, with its true error. Errors that are carried are such numbers in
/// place of lanes, known exactly.
template <class Number>
struct Stand {
  ErrorBound bound;

  static Stand all(double constant) { return {ErrorBound::all(constant)}; }
  friend Stand operator+(const Stand& a, const Stand& b) { return {a.bound + b.bound}; }
  friend Stand operator-(const Stand& a, const Stand& b) { return {a.bound - b.bound}; }
  friend Stand operator*(const Stand& a, const Stand& b) { return {a.bound * b.bound}; }
  friend Stand maximum(const Stand& a, const Stand& b) { return {proofs::maximum(a.bound, b.bound)}; }
};

/// In place of a number of which only the magnitude matters, by its ratio to that without rounding.
struct Size {
  Ratio<52> ratio;

  friend Size operator+(const Size& a, const Size&) { return a; }
  friend Size operator-(const Size& a, const Size&) { return a; }
  friend Size operator*(const Size& a, const Size&) { return a; }
  friend Size quotient(const Size&, const Size&) { return {Ratio<52>{}.rounded()}; }
  friend Size square_root(const Size& a) { return {square_root(a.ratio)}; }
  friend Size at_least(const Size& a, const Ratio<52>&) { return a; }
  friend Ratio<52> magnitude(const Size& a) { return a.ratio; }
  friend Ratio<52> leading(const Size& a) { return a.ratio; }
};

}  // namespace
}  // namespace touchstone::proofs::bounded

namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {
template <class Number>
struct ErrorTraits<proofs::bounded::Stand<Number>> : ErrorTraits<Number> {
  using Error = proofs::bounded::Stand<Pack>;
};
template <>
struct ErrorTraits<proofs::bounded::Size> : ErrorTraits<Pack> {
  using Error = proofs::Ratio<52>;
};
}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

namespace touchstone::proofs::bounded {
namespace {

// Underflow is far below all errors (numbers/bounded.h).
const mpq_class kUnit = bounds::kUnit;
const ErrorModel kLanes{kUnit, 0, false};
const ErrorModel kDoubleDoubles{bounds::kDoubleDoubleUnit, 0, false, SumsOfProducts{bounds::kDot, bounds::kCross}};

template <class Number>
const ErrorModel& model() {
  return std::is_same_v<Number, Pack> ? kLanes : kDoubleDoubles;
}

/// How much the high part of a double-double differs from it, relative to either.
template <class Number>
const mpq_class kLow = std::is_same_v<Number, Pack> ? mpq_class(0) : mpq_class(bounds::kUnit / 2);

template <class Number>
Stand<Pack> magnitude(const Stand<Number>& a) {
  const mpq_class least = std::max<mpq_class>({a.bound.low, -a.bound.high, 0});
  return {{&kLanes, least * (1 - kLow<Number>), a.bound.magnitude() * (1 + kLow<Number>), 0}};
}
/// Of a number that is positive.
template <class Number>
Stand<Pack> leading(const Stand<Number>& a) {
  return magnitude(a);
}
/// Of a number that is not negative without its error, and so the larger of it and 0, from which `least` differs by
/// itself. High parts decide.
template <class Number>
Stand<Number> at_least(const Stand<Number>& a, const Stand<Pack>& least) {
  const mpq_class& high = least.bound.high;
  return {proofs::maximum(a.bound, {nullptr, least.bound.low * (1 - kLow<Number>), high, high})};
}
/// Rounds a quotient or a root: of double-doubles as Gappa proves it of the operations that are compiled.
template <class Number>
Stand<Number> rounded_quotient(ErrorBound exact) {
  static const mpq_class units = std::is_same_v<Number, Pack> ? 1 : bounds::kQuotient;
  static const ErrorModel of_quotients{units * model<Number>().unit, 0, false};
  exact.model = &of_quotients;
  ErrorBound result = rounded(exact);
  result.model = &model<Number>();
  return {result};
}
template <class Number>
Stand<Number> quotient(const Stand<Number>& a, const Stand<Number>& b) {
  return rounded_quotient<Number>(exact_quotient(a.bound, b.bound));
}
template <class Number>
Stand<Number> square_root(const Stand<Number>& a) {
  return rounded_quotient<Number>(exact_root(a.bound, root_below(a.bound.low), root_above(a.bound.high)));
}
template <class Number>
Stand<Pack> largest_component(const Vector3<Stand<Number>>& v) {
  return maximum(maximum(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
}
template <class Number>
Vector3<ErrorBound> bounds_of(const Vector3<Stand<Number>>& v) {
  return {v.x.bound, v.y.bound, v.z.bound};
}
template <class Number>
Stand<Number> dot(const Vector3<Stand<Number>>& a, const Vector3<Stand<Number>>& b) {
  return {proofs::dot(bounds_of(a), bounds_of(b))};
}
template <class Number>
Vector3<Stand<Number>> cross(const Vector3<Stand<Number>>& a, const Vector3<Stand<Number>>& b) {
  const Vector3<ErrorBound> product = proofs::cross(bounds_of(a), bounds_of(b));
  return {{product.x}, {product.y}, {product.z}};
}

Stand<Pack> exactly(const mpq_class& number) { return {{&kLanes, number, number, 0}}; }

/// A number that was computed as `value`. `lacking`: by what factor the carried error is too small.
template <class Number>
Bounded<Stand<Number>> known(const mpq_class& value, const mpq_class& error, const mpq_class& lacking = 1) {
  return {{{&model<Number>(), value, value, error * lacking}}, exactly(error)};
}
/// A vector of any numbers up to this size.
template <class Number>
BoundedVector<Stand<Number>> vector_of(const mpq_class& size, const mpq_class& error) {
  const Stand<Number> component{known_within(model<Number>(), size, error)};
  return {{component, component, component}, exactly(size), exactly(error)};
}

/// The carried error is rounded eight times at most.
void expect_covered(const ErrorBound& value, const Stand<Pack>& error, const mpq_class& lacking = 1) {
  EXPECT_LE(value.error, lacking * error.bound.low * (1 + 8 * kUnit)) << value.low << " to " << value.high;
}
/// The errors of a number and of a vector.
const std::vector<mpq_class> kErrors{0, mpq_class(1, mpz_class(1) << 60), 1, 1000};

template <class Number>
void expect_sums_and_products_covered() {
  for (const int a : {0, 1, -3, 1000})
    for (const int b : {0, 1, -3, 1000})
      for (const mpq_class& of_a : kErrors)
        for (const mpq_class& of_b : kErrors) {
          const auto x = known<Number>(a, of_a), y = known<Number>(b, of_b);
          for (const auto& result : {x + y, x - y, x * y}) expect_covered(result.value.bound, result.error);
        }
}

template <class Number>
void expect_products_of_vectors_covered() {
  for (const int a : {1, 1000})
    for (const int b : {1, 1000})
      for (const mpq_class& of_a : kErrors)
        for (const mpq_class& of_b : kErrors) {
          const auto x = vector_of<Number>(a, of_a), y = vector_of<Number>(b, of_b);
          const auto product = filtered::detail::dot(x, y);
          expect_covered(product.value.bound, product.error);
          const auto normal = filtered::detail::cross(x, y);
          for (int axis = 0; axis < 3; ++axis) expect_covered(normal.value[axis].bound, normal.error);
        }
}

/// By what factors carried errors may be too small: by none, and after 2^11 operations.
const std::vector<mpq_class> kLacking{1, (1 + mpq_class(bounds::kWideError)) / 2};
/// Errors of a divisor that is 1, which is certainly positive.
const std::vector<mpq_class> kErrorsOfDivisors{0, 0x1p-60, 0x1p-20, 0x1p-16, 0x1p-8, 0.5, 1 - 0x1p-8, 1 - 0x1p-20};

// A quotient and its error are linear in what is divided and its error, and scale with the divisor.
template <class Number>
void expect_quotients_covered() {
  for (const mpq_class& lacking : kLacking)
    for (const int a : {0, 1, -3, 1000})
      for (const mpq_class& of_a : kErrors)
        for (const mpq_class& of_b : kErrorsOfDivisors) {
          const auto result = quotient(known<Number>(a, of_a, lacking), known<Number>(1, of_b, lacking));
          expect_covered(result.value.bound, result.error, lacking);
        }
}

// The exact number is not negative; the computed one may be, up to its error.
template <class Number>
void expect_roots_covered() {
  for (const mpq_class& lacking : kLacking) {
    for (const mpq_class& error : kErrorsOfDivisors) {
      const auto result = root(known<Number>(1, error, lacking));
      expect_covered(result.value.bound, result.error, lacking);
    }
    for (const double a : {-1.0, -0.5, 0.0, 0.5, 1 - 0x1p-20, 1.0, 1 + 0x1p-40}) {
      const auto result = root(known<Number>(a, 1, lacking));
      expect_covered(result.value.bound, result.error, lacking);
    }
  }
}

template <class Number>
void expect_covered() {
  expect_sums_and_products_covered<Number>();
  expect_products_of_vectors_covered<Number>();
  expect_quotients_covered<Number>();
  expect_roots_covered<Number>();
}

TEST(BoundedOperations, OfLanesCoverTheirErrors) { expect_covered<Pack>(); }
TEST(BoundedOperations, OfDoubleDoublesCoverTheirErrors) { expect_covered<DoubleDouble>(); }

TEST(BoundedOperations, AreTight) {
  const auto x = vector_of<Pack>(1, 0), y = vector_of<Pack>(1, 1);
  const auto of_exact = filtered::detail::dot(x, x), of_unknown = filtered::detail::dot(x, y);
  EXPECT_GT(of_exact.value.bound.error, of_exact.error.bound.low * 63 / 64);
  EXPECT_GT(of_unknown.value.bound.error, of_unknown.error.bound.low * 63 / 64);
  for (const auto& result : {quotient(known<Pack>(1, 1), known<Pack>(1, 0.5)), root(known<Pack>(1, 0x1p-20))})
    EXPECT_GT(result.value.bound.error, result.error.bound.low * 63 / 64);
}

TEST(BoundedOperations, RoundTheirErrorAtMostEightTimes) {
  const Bounded<Size> x{}, y{};
  const BoundedVector<Size> v{}, w{};
  for (const Ratio<52>& error :
       {(x + y).error, (x - y).error, (x * y).error, error_of_products(v, w, 3, 8), error_of_products(v, w, 2, 4)}) {
    EXPECT_GE(error.least, power(1 - kUnit, 8));
    EXPECT_LE(error.most, power(1 + kUnit, 8));
  }
  // What is subtracted from a divisor may be so near that nothing bounds the error of the quotient from above.
  for (const Ratio<52>& error : {quotient(x, y).error, root(x).error}) EXPECT_GE(error.least, power(1 - kUnit, 8));
  EXPECT_LE(power(1 + 8 * kUnit, 1 << 11), kLacking.back());
  // The factor, and its product with the error.
  EXPECT_LE(power(1 + 8 * kUnit, 1 << 12), bounds::kWideError * (1 - kUnit));
}

}  // namespace
}  // namespace touchstone::proofs::bounded
