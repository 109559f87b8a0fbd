// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "robust/filtered/detail/numbers/vector3.h"

/// The error calculus in rationals: a number type whose operations propagate bounds by the model of bounds.h. Coq
/// proves its rules (coq/calculus.v) and checks each step that the tests carry out.
namespace touchstone::proofs {

using namespace filtered::detail;

/// The steps that the error calculus carries out in this process, each kind of numbers once. At the end they are
/// written to the file that the environment variable TOUCHSTONE_CALCULUS_STEPS names, for Coq (coq/calculus.v): a line
/// a step, its rule and its numbers in base 16. Without the variable, nothing is kept.
class CalculusSteps {
 public:
  static CalculusSteps& of_process() {
    static CalculusSteps steps;
    return steps;
  }
  CalculusSteps(const CalculusSteps&) = delete;
  CalculusSteps& operator=(const CalculusSteps&) = delete;
  ~CalculusSteps() {
    if (file_ == nullptr) return;
    std::ofstream out(file_);
    for (const std::string& step : steps_) out << step << '\n';
  }

  using Numbers = std::initializer_list<std::reference_wrapper<const mpq_class>>;
  /// Adds a step: its rule, the numbers that this is given besides bounds, and those of the bounds.
  void add(std::string_view rule, Numbers besides, Numbers bounds) {
    if (file_ == nullptr) return;
    std::string step(rule);
    for (const Numbers numbers : {besides, bounds})
      for (const mpq_class& number : numbers) step += ' ' + number.get_str(16);
    steps_.insert(std::move(step));
  }

 private:
  CalculusSteps() = default;

  const char* file_ = std::getenv("TOUCHSTONE_CALCULUS_STEPS");
  std::set<std::string> steps_;
};

/// The errors of `dot` and `cross` if they round only once, in units of the product of their vectors' maxima.
struct SumsOfProducts {
  mpq_class dot, cross;
};

/// Every operation returns its exact result times (1 + d), |d| <= unit, plus at most `underflow` in magnitude.
struct ErrorModel {
  mpq_class unit, underflow;
  /// Whether a number times itself is known to be positive. If not, all bounds are polynomials in the inputs' maxima
  /// and errors, with coefficients that are not negative.
  bool knows_squares;
  /// Empty if sums of products round every product and every sum, as in vector3.h.
  std::optional<SumsOfProducts> sums_of_products = std::nullopt;
};

/// Bounds of a number: its computed value lies in [low, high] and differs from the exact one by at most `error`.
struct ErrorBound {
  const ErrorModel* model;  ///< null for a constant, which is exact in every model
  mpq_class low, high, error;

  static ErrorBound all(double constant) { return {nullptr, constant, constant, 0}; }

  [[nodiscard]] mpq_class magnitude() const { return std::max<mpq_class>(abs(low), abs(high)); }
};

inline ErrorBound known_within(const ErrorModel& model, const mpq_class& magnitude, const mpq_class& error) {
  return {&model, -magnitude, magnitude, error};
}

/// Returns the result of a step from `a`, which Coq is to check. `besides`: numbers that the rule is given.
inline ErrorBound step(std::string_view rule, CalculusSteps::Numbers besides, const ErrorBound& a, ErrorBound result) {
  CalculusSteps::of_process().add(rule, besides, {a.low, a.high, a.error, result.low, result.high, result.error});
  return result;
}
/// Returns the result of a step from `a` and `b`.
inline ErrorBound step(std::string_view rule, const ErrorBound& a, const ErrorBound& b, ErrorBound result) {
  CalculusSteps::of_process().add(
      rule, {}, {a.low, a.high, a.error, b.low, b.high, b.error, result.low, result.high, result.error});
  return result;
}

/// Returns the bound of a result that would have the bound `a` if the operation were exact.
inline ErrorBound rounded(const ErrorBound& a) {
  const mpq_class& unit = a.model->unit;
  const mpq_class& underflow = a.model->underflow;
  const mpq_class below = unit * abs(a.low) + underflow, above = unit * abs(a.high) + underflow;
  return step("rounded", {unit, underflow}, a,
              {a.model, a.low - below, a.high + above, a.error + std::max(below, above)});
}

/// Returns the model of two operands, of which one may be a constant.
inline const ErrorModel* model_of(const ErrorBound& a, const ErrorBound& b) { return a.model ? a.model : b.model; }

/// Returns the bound of the total of `count` terms, each with the bound `term`, that are added to 0 one by one.
inline ErrorBound total(std::size_t count, const ErrorBound& term) {
  const mpq_class& unit = term.model->unit;
  const mpq_class& underflow = term.model->underflow;
  const mpq_class n = count, grown = 1 / (1 - n * unit);  // at least (1 + unit)^n
  const mpq_class of_term = (term.magnitude() + underflow) * grown, most = n * of_term;
  return step("total", {n, unit, underflow, grown}, term,
              {term.model, -most, most, n * (term.error + underflow + unit * of_term * (n + 1) / 2)});
}

/// @{
/// An exact operation.
inline ErrorBound exact_sum(const ErrorBound& a, const ErrorBound& b) {
  return step("sum", a, b, {model_of(a, b), a.low + b.low, a.high + b.high, a.error + b.error});
}
inline ErrorBound exact_difference(const ErrorBound& a, const ErrorBound& b) {
  return step("difference", a, b, {model_of(a, b), a.low - b.high, a.high - b.low, a.error + b.error});
}
/// a b - A B = a (b - B) + (a - A) B, and |B| <= |b| + |b - B|.
inline ErrorBound exact_product(const ErrorBound& a, const ErrorBound& b) {
  const mpq_class corners[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  const ErrorModel* const model = model_of(a, b);
  const bool is_square = model->knows_squares && &a == &b && a.low < 0;
  return step(is_square ? "square" : "product", a, b,
              {model, is_square ? mpq_class(0) : *std::min_element(std::begin(corners), std::end(corners)),
               *std::max_element(std::begin(corners), std::end(corners)),
               a.magnitude() * b.error + a.error * (b.magnitude() + b.error)});
}
/// The divisor is positive, also without errors. q - A / B = (q (B - b) + (a - A)) / B, q = a / b.
inline ErrorBound exact_quotient(const ErrorBound& a, const ErrorBound& b) {
  const mpq_class corners[] = {a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high};
  ErrorBound result{model_of(a, b), *std::min_element(std::begin(corners), std::end(corners)),
                    *std::max_element(std::begin(corners), std::end(corners)), 0};
  result.error = (a.error + result.magnitude() * b.error) / (b.low - b.error);
  return step("division", a, b, result);
}
/// Requires bounds of the root, low > 0. |sqrt a - sqrt A| sqrt a <= |a - A|.
inline ErrorBound exact_root(const ErrorBound& a, const mpq_class& low, const mpq_class& high) {
  return step("root", {}, a, {a.model, low, high, a.error / low});
}
/// @}

inline ErrorBound operator-(const ErrorBound& a) { return exact_difference(ErrorBound::all(0), a); }
inline ErrorBound operator+(const ErrorBound& a, const ErrorBound& b) { return rounded(exact_sum(a, b)); }
inline ErrorBound operator-(const ErrorBound& a, const ErrorBound& b) { return rounded(exact_difference(a, b)); }
inline ErrorBound operator*(const ErrorBound& a, const ErrorBound& b) { return rounded(exact_product(a, b)); }
inline ErrorBound operator/(const ErrorBound& a, const ErrorBound& b) { return rounded(exact_quotient(a, b)); }

/// Multiplies by a number that is known exactly.
inline ErrorBound operator/(const ErrorBound& a, double count) {
  const mpq_class divisor = count;
  return rounded(step("quotient", {divisor}, a, {a.model, a.low / divisor, a.high / divisor, a.error / divisor}));
}

inline mpq_class largest_magnitude(const Vector3<ErrorBound>& v) {
  return std::max({v.x.magnitude(), v.y.magnitude(), v.z.magnitude()});
}

/// Returns the bound of an exact result plus an error of `units` of the product of two vectors' maxima, and underflow.
inline ErrorBound off_by(const mpq_class& units, const ErrorBound& exact, const Vector3<ErrorBound>& a,
                         const Vector3<ErrorBound>& b) {
  const mpq_class off =
      units * exact.model->unit * largest_magnitude(a) * largest_magnitude(b) + exact.model->underflow;
  return step("off", {off}, exact, {exact.model, exact.low - off, exact.high + off, exact.error + off});
}

/// @{
/// An operation in the model; preferred to that of vector3.h by overload resolution.
inline ErrorBound dot(const Vector3<ErrorBound>& a, const Vector3<ErrorBound>& b) {
  const auto& apart = a.x.model->sums_of_products;
  if (!apart) return filtered::detail::dot<ErrorBound, ErrorBound>(a, b);
  return off_by(apart->dot,
                exact_sum(exact_sum(exact_product(a.x, b.x), exact_product(a.y, b.y)), exact_product(a.z, b.z)), a, b);
}
inline Vector3<ErrorBound> cross(const Vector3<ErrorBound>& a, const Vector3<ErrorBound>& b) {
  const auto& apart = a.x.model->sums_of_products;
  if (!apart) return filtered::detail::cross<ErrorBound, ErrorBound>(a, b);
  const auto component = [&](int i, int j) {
    return off_by(apart->cross, exact_difference(exact_product(a[i], b[j]), exact_product(a[j], b[i])), a, b);
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}
/// @}

/// @{
/// Fused or not: the model allows both, and the error of the unfused form is larger.
inline ErrorBound multiply_add(const ErrorBound& a, const ErrorBound& b, const ErrorBound& c) { return a * b + c; }
inline ErrorBound multiply_subtract(const ErrorBound& a, const ErrorBound& b, const ErrorBound& c) { return a * b - c; }
/// @}

/// The larger of two numbers, and a magnitude: neither is rounded.
inline ErrorBound maximum(const ErrorBound& a, const ErrorBound& b) {
  return step("maximum", a, b,
              {model_of(a, b), std::max(a.low, b.low), std::max(a.high, b.high), std::max(a.error, b.error)});
}
inline ErrorBound magnitude(const ErrorBound& a) {
  return step("magnitude", {}, a, {a.model, 0, a.magnitude(), a.error});
}

}  // namespace touchstone::proofs
