// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>
#include <gmpxx.h>

#include <Eigen/Core>

namespace touchstone::exact {

// Mpzf: integers times powers of two. It has no division, which is not needed here. A full answer for a 24-gon takes 42
// us if it is planar and 52 us if not; Gmpq takes 5.5 and 8.8 times as long, Lazy_exact_nt<Gmpq> (the number type of
// EPECK, whose intervals decide nothing near a boundary) 12 and 14 times, with the same answers.
#ifndef TOUCHSTONE_EXACT_NUMBER
#define TOUCHSTONE_EXACT_NUMBER CGAL::Mpzf
#endif
/// The number type of `exact`.
using Number = TOUCHSTONE_EXACT_NUMBER;
/// A vector of exact numbers.
using Vector = CGAL::Simple_cartesian<Number>::Vector_3;

/// Returns the same vector in exact numbers.
inline Vector vector(const Eigen::Vector3d& v) { return {Number(v.x()), Number(v.y()), Number(v.z())}; }

/// Returns the same number as a rational number of GMP.
template <class N>
mpq_class rational(const N& number) {
  if constexpr (requires { number.exact(); })
    return rational(number.exact());
  else
    return mpq_class(static_cast<CGAL::Gmpq>(number).mpq());
}

/// Returns numerator / denominator, rounded by `round` (nearest_double or nearest_root).
template <class Round>
double rounded(const Number& numerator, const Number& denominator, Round round) {
  const mpq_class a = rational(numerator), b = rational(denominator);
  return round(mpz_class(a.get_num() * b.get_den()), mpz_class(b.get_num() * a.get_den()));
}

}  // namespace touchstone::exact
