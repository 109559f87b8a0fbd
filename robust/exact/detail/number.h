// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "robust/detail/exact_kernel.h"
#if defined(TOUCHSTONE_EXACT_NUMBER)
#include <CGAL/Lazy_exact_nt.h>
#endif

namespace touchstone::exact {

// Mpzf: integers times powers of two. It has no division, which is not needed here. A full answer for a 24-gon takes 42
// us if it is planar and 52 us if not; Gmpq takes 5.5 and 8.8 times as long, Lazy_exact_nt<Gmpq> (the number type of
// EPECK, whose intervals decide nothing near a boundary) 12 and 14 times, with the same answers.
#ifndef TOUCHSTONE_EXACT_NUMBER
#define TOUCHSTONE_EXACT_NUMBER kernel::Mpzf
#endif
/// The number type of `exact`.
using Number = TOUCHSTONE_EXACT_NUMBER;
/// A vector of exact numbers.
using Vector = kernel::Simple_cartesian<Number>::Vector_3;

/// Returns the same vector in exact numbers.
inline Vector vector(const Eigen::Vector3d& v) { return {Number(v.x()), Number(v.y()), Number(v.z())}; }

}  // namespace touchstone::exact
