// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Gmpq.h>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/plain_formulas.h"
#include "robust/exact/detail/nearest_double.h"

namespace touchstone::methods {
namespace {

struct Rationals {
  using Number = CGAL::Gmpq;
  struct Guard {};
  static constexpr std::string_view kName = "rational", kStage = "rational",
                                    kSummary = "the contract's formulas over GMP's rationals: exact by construction";
  static constexpr bool kSlow = true;

  static std::optional<double> nearest_double(const Number& x) {
    return exact::detail::nearest_double(mpz_class(x.numerator().mpz()), mpz_class(x.denominator().mpz()));
  }
  static std::optional<double> nearest_root(const Number& x) {
    return exact::detail::nearest_root(mpz_class(x.numerator().mpz()), mpz_class(x.denominator().mpz()));
  }
};

}  // namespace

void add_rational(std::vector<std::unique_ptr<Method>>& list) { list.push_back(std::make_unique<Plain<Rationals>>()); }

}  // namespace touchstone::methods
