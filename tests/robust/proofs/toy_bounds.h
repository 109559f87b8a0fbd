// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <vector>

#include "robust/proofs/error_bound.h"
#include "robust/proofs/expressions.h"

namespace touchstone::proofs {

/// Inputs for maxima of 1 at a unit so large that products of units count: normal and foot carry what was computed to
/// find them. At such units the computed components of a normal may exceed m_N = 2 m_u m_v by much.
inline Inputs<ErrorBound> inputs_at(const ErrorModel& model) {
  Inputs<ErrorBound> inputs = make_inputs<ErrorBound>(
      [&](const Input& input) { return known_within(model, 1, input.error == 0 ? mpq_class(0) : model.unit); });
  const ErrorBound normal = signs::normal(inputs.first_edge, inputs.second_edge).x;
  const ErrorBound half_normal = known_within(model, normal.magnitude() / 2, normal.error / 2);
  inputs.normal = {half_normal, half_normal, half_normal};
  inputs.foot_x = inputs.foot_y = known_within(model, 1, frame::coordinate(inputs.axis, inputs.from_origin).error);
  return inputs;
}

/// The bound of each claim for maxima of 1, by the same error calculus that proves the constants at their units.
inline std::vector<double> bounds_at(const mpq_class& unit) {
  std::vector<double> result;
  for_each_claim([&](const Claim& claim, const auto& expression) {
    const ErrorModel model{unit, 0, !claim.squares_are_products()};
    const double below = expression(inputs_at(model)).error.get_d();  // rounds towards zero
    result.push_back(std::nextafter(below, std::numeric_limits<double>::infinity()));
  });
  return result;
}

}  // namespace touchstone::proofs
