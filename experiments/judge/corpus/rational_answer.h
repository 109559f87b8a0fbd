// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/key.h"
#include "experiments/cases/posed_mesh.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/rejection.h"

/// Answers derived a second time, by the formulas of the contract over GMP's rationals, without any code of `robust`:
/// number type, rounding and tests of loops are independent.
namespace touchstone::corpus {

/// Returns whether x is the double nearest to `exact`, ties to even. An infinite x is if the exact value rounds beyond
/// the finite doubles.
[[nodiscard]] bool is_nearest_double(double x, const mpq_class& exact);
/// Returns whether x >= 0 is the double nearest to the root of `squared` >= 0.
[[nodiscard]] bool is_nearest_root(double x, const mpq_class& squared);

/// Returns the faults of an answer, one sentence for each wrong key: its value and the value of the rationals. Every
/// key of the contract must be present. Does not use cases::same_value for numbers: it holds a double to the exact
/// number that it must be nearest to. Requires a polygon for which find_rational_fault finds nothing. Cost: about ten
/// times that of `exact`.
[[nodiscard]] std::vector<std::string> rational_differences(const Ball& ball, const Polygon& polygon,
                                                            const cases::StatedAnswer& answer);

/// The same for a mesh: compares the exact distances of its faces. Requires faces without such a fault.
[[nodiscard]] std::vector<std::string> rational_differences(const Ball& ball, const cases::PosedMesh& mesh,
                                                            const cases::StatedAnswer& answer);

/// Returns the first rejection that applies to loops of at least three vertices without equal neighbours:
/// `zero-normal`, `loop-meets-itself`, `loops-meet` or `hole-outside`. Tests every pair of edges.
[[nodiscard]] std::optional<RejectionCode> find_rational_fault(const Polygon& polygon);

}  // namespace touchstone::corpus
