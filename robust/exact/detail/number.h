// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "robust/detail/exact_kernel.h"

namespace touchstone::exact::detail {

/// The number type of `exact`: integers times powers of two. It has no division, which is not needed here. Rationals
/// and the lazy numbers of EPECK give the same answers, and take several times as long.
using Number = kernel::Mpzf;
/// A vector of exact numbers.
using Vector = kernel::Simple_cartesian<Number>::Vector_3;

/// Returns the same vector in exact numbers.
inline Vector vector(const Eigen::Vector3d& v) { return {Number(v.x()), Number(v.y()), Number(v.z())}; }

}  // namespace touchstone::exact::detail
