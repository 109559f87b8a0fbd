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
  friend Ratio<52> magnitude(const Size& a) { return a.ratio; }
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

/// The high part of a double-double differs from it by half a unit of doubles at most.
template <class Number>
Stand<Pack> magnitude(const Stand<Number>& a) {
  const mpq_class least = std::max<mpq_class>({a.bound.low, -a.bound.high, 0});
  const mpq_class apart = std::is_same_v<Number, Pack> ? mpq_class(0) : kU;
  return {{&kLanes, least * (1 - apart), a.bound.magnitude() * (1 + apart), 0}};
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

/// A number that was computed as `value`.
template <class Number>
Bounded<Stand<Number>> known(const mpq_class& value, const mpq_class& error) {
  return {{{&model<Number>(), value, value, error}}, exactly(error)};
}
/// A vector of any numbers up to this size.
template <class Number>
BoundedVector<Stand<Number>> vector_of(const mpq_class& size, const mpq_class& error) {
  const Stand<Number> component{known_within(model<Number>(), size, error)};
  return {{component, component, component}, exactly(size), exactly(error)};
}

/// The carried error is rounded eight times at most.
void expect_covered(const ErrorBound& value, const Stand<Pack>& error) {
  EXPECT_LE(value.error, error.bound.low * (1 + 8 * kUnit)) << value.low << " to " << value.high;
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

TEST(BoundedOperations, OfLanesCoverTheirErrors) {
  expect_sums_and_products_covered<Pack>();
  expect_products_of_vectors_covered<Pack>();
}

TEST(BoundedOperations, OfDoubleDoublesCoverTheirErrors) {
  expect_sums_and_products_covered<DoubleDouble>();
  expect_products_of_vectors_covered<DoubleDouble>();
}

TEST(BoundedOperations, AreTight) {
  const auto x = vector_of<Pack>(1, 0), y = vector_of<Pack>(1, 1);
  const auto of_exact = filtered::detail::dot(x, x), of_unknown = filtered::detail::dot(x, y);
  EXPECT_GT(of_exact.value.bound.error, of_exact.error.bound.low * 63 / 64);
  EXPECT_GT(of_unknown.value.bound.error, of_unknown.error.bound.low * 63 / 64);
}

TEST(BoundedOperations, RoundTheirErrorAtMostEightTimes) {
  const Bounded<Size> x{}, y{};
  const BoundedVector<Size> v{}, w{};
  for (const Ratio<52>& error :
       {(x + y).error, (x - y).error, (x * y).error, error_of_products(v, w, 3, 8), error_of_products(v, w, 2, 4)}) {
    EXPECT_GE(error.least, power(1 - kUnit, 8));
    EXPECT_LE(error.most, power(1 + kUnit, 8));
  }
  // The factor, and its product with the error.
  EXPECT_LE(power(1 + 8 * kUnit, 1 << 12), bounds::kWideError * (1 - kUnit));
}

}  // namespace
}  // namespace touchstone::proofs::bounded
