// SPDX-License-Identifier: GPL-3.0-or-later
// The code of `fast` over numbers that are wider than those of the library.
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>
#ifndef TOUCHSTONE_WITHOUT_QD
#include <qd/dd_real.h>
#endif

#include "experiments/methods/own_functions.h"
#include "geometry/contact/detail/fast_motion_definitions.h"
#include "geometry/contact/fast.h"

namespace touchstone::methods {
namespace {

namespace mp = boost::multiprecision;

/// Numbers of fixed precision, stored without heap memory.
template <unsigned decimal_digits>
using Mpfr = mp::number<mp::mpfr_float_backend<decimal_digits, mp::allocate_stack>, mp::et_off>;

// Boost counts decimal digits.
static_assert(std::numeric_limits<Mpfr<30>>::digits == 101 && std::numeric_limits<Mpfr<60>>::digits == 201);

}  // namespace

// With QD as configured by Debian, sums that cancel keep the error of their larger term, and quotients are not fully
// rounded. The range is that of double. QD assumes rounding to nearest; x87 would also need fpu_fix_start, but
// FLT_EVAL_METHOD is 0.
void add_fast_wide(MethodList& list) {
#ifndef TOUCHSTONE_WITHOUT_QD
  list.push_back(own_method<fast::PreparedPolygon<dd_real>>("fast-double-double", "double-double",
                                                            "the code of fast over double-doubles (QD), 104 bits"));
#endif
  list.push_back(own_method<fast::PreparedPolygon<Mpfr<30>>>("fast-mpfr-101", "mpfr",
                                                             "the code of fast over MPFR numbers of 101 bits"));
  list.push_back(own_method<fast::PreparedPolygon<Mpfr<60>>>("fast-mpfr-201", "mpfr",
                                                             "the code of fast over MPFR numbers of 201 bits"));
}

}  // namespace touchstone::methods
