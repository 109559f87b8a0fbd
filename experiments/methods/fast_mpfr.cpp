// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/fast_method.h"
#include "geometry/contact/detail/fast_motion_definitions.h"

namespace touchstone::methods {
namespace {

namespace mp = boost::multiprecision;

/// Numbers of fixed precision, stored without heap memory.
template <unsigned decimal_digits>
using Mpfr = mp::number<mp::mpfr_float_backend<decimal_digits, mp::allocate_stack>, mp::et_off>;

// Boost counts decimal digits.
static_assert(std::numeric_limits<Mpfr<30>>::digits == 101 && std::numeric_limits<Mpfr<60>>::digits == 201);

}  // namespace

void add_fast_mpfr(std::vector<std::unique_ptr<Method>>& list) {
  list.push_back(
      std::make_unique<Fast<Mpfr<30>>>("fast-mpfr-101", "mpfr", "the code of fast over MPFR numbers of 101 bits"));
  list.push_back(
      std::make_unique<Fast<Mpfr<60>>>("fast-mpfr-201", "mpfr", "the code of fast over MPFR numbers of 201 bits"));
}

}  // namespace touchstone::methods
