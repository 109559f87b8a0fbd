// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "experiments/cases/method.h"
#include "geometry/shapes/rejection.h"

namespace touchstone::cases {

/// An answer or a rejection as a line of JSON states it: the expectation of a case, or a verdict.
struct StatedAnswer {
  PartialAnswer values;  ///< the keys whose value has the form of the contract; null stands for an infinite number
  /// Every stated key of an answer, and `error` and `message`: its value as JSON, with numbers in the shortest form
  /// that reads back as the same double. The members of an object are in the order of their names.
  std::map<std::string, std::string> texts;

  [[nodiscard]] bool rejects() const { return texts.contains("error"); }
};

/// Returns the statement of a method. Numbers beyond the finite doubles become null, -0 becomes 0.
[[nodiscard]] StatedAnswer stated(const PartialAnswer& answer);
[[nodiscard]] StatedAnswer stated(const Rejection& rejection);

}  // namespace touchstone::cases
