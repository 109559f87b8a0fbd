// SPDX-License-Identifier: GPL-3.0-or-later
// The contract's formulas over numbers that are sure: intervals and rationals.
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/plain_formulas.h"
#include "robust/exact/detail/nearest_double.h"

namespace touchstone::methods {
namespace {

struct Intervals {
  using Number = CGAL::Interval_nt_advanced;  // rounds upwards only within a Guard
  using Guard = Number::Protector;
  static constexpr std::string_view kStage = "interval";

  static std::optional<double> nearest_double(const Number& x) {
    return x.is_point() ? std::optional(x.inf()) : std::nullopt;
  }
  static std::optional<double> nearest_root(const Number& x) { return nearest_double(CGAL::sqrt(x)); }
};

struct Rationals {
  using Number = CGAL::Gmpq;
  struct Guard {};
  static constexpr std::string_view kStage = "rational";

  static std::optional<double> nearest_double(const Number& x) {
    return exact::detail::nearest_double(mpz_class(x.numerator().mpz()), mpz_class(x.denominator().mpz()));
  }
  static std::optional<double> nearest_root(const Number& x) {
    return exact::detail::nearest_root(mpz_class(x.numerator().mpz()), mpz_class(x.denominator().mpz()));
  }
};

}  // namespace

void add_plain(MethodList& list) {
  list.push_back(std::make_unique<Method>(
      "interval", "the contract's formulas over intervals of doubles: sure, or don't know",
      [](const Polygon& polygon) { return std::make_unique<PreparedPlain<Intervals>>(polygon); }));
  list.push_back(std::make_unique<Method>(
      "rational", "the contract's formulas over GMP's rationals: exact by construction",
      [](const Polygon& polygon) { return std::make_unique<PreparedPlain<Rationals>>(polygon); }, Method::Kind::Slow));
}

}  // namespace touchstone::methods
