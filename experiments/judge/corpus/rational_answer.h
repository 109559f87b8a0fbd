// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/rejection.h"

/// Answers derived a second time, by the contract's formulas over GMP's rationals, with nothing of `robust`: the number
/// type, the rounding and the tests of loops are others.
namespace touchstone::corpus {

/// Is x the double nearest to `exact`, ties to even? An infinite x is, where the exact value rounds beyond the doubles.
[[nodiscard]] bool is_nearest_double(double x, const mpq_class& exact);
/// Is x >= 0 the double nearest to the root of `squared` >= 0?
[[nodiscard]] bool is_nearest_root(double x, const mpq_class& squared);

/// What is wrong with an answer, a sentence a key: what it says and what the rationals give. Every key of the contract
/// must be there. Requires a polygon that find_rational_fault accepts. Cost: about ten times that of `exact`.
[[nodiscard]] std::vector<std::string> rational_differences(const Ball& ball, const Polygon& polygon,
                                                            const nlohmann::json& answer);

/// Of loops of at least three vertices without equal neighbours: `zero-normal`, `loop-meets-itself`, `loops-meet` or
/// `hole-outside`, the first that applies, by looking at every pair of edges.
[[nodiscard]] std::optional<RejectionCode> find_rational_fault(const Polygon& polygon);

}  // namespace touchstone::corpus
