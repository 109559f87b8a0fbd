// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The kernel of exact arithmetic: numbers that are integers times powers of two, vectors of them, and their signs. It
/// is CGAL's, or, with TOUCHSTONE_EXACT=OFF, one over Boost.Multiprecision that has the few functions that are used, by
/// the names that they have in CGAL.
#if defined(TOUCHSTONE_BOOST_NUMBERS)
#include "robust/detail/kernel_of_boost.h"
namespace touchstone {
namespace kernel = kernel_of_boost;
}
#else
#include <CGAL/Gmpq.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>

#include "robust/detail/integers.h"
namespace touchstone {
namespace kernel = CGAL;

/// Returns the same number as a rational number of GMP.
template <class Number>
Rational rational(const Number& number) {
  return Rational(static_cast<CGAL::Gmpq>(number).mpq());
}

}  // namespace touchstone
#endif

namespace touchstone {

/// Returns numerator / denominator, rounded by `round` (nearest_double or nearest_root).
template <class Number, class Round>
double rounded(const Number& numerator, const Number& denominator, Round round) {
  const Rational a = rational(numerator), b = rational(denominator);
  return round(Integer(numerator_of(a) * denominator_of(b)), Integer(numerator_of(b) * denominator_of(a)));
}

}  // namespace touchstone
