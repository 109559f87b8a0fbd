// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/cases/shapes.h"
#include "experiments/cases/stated_answer.h"
#include "experiments/run/json/not_json.h"
#include "geometry/shapes/rejection.h"

namespace touchstone::cases {

/// One line of a file of cases, read according to the contract.
struct Case {
  std::optional<std::string> id;            ///< absent only from malformed cases
  std::optional<StatedAnswer> expected;     ///< keys of an answer, or `error`; absent if malformed
  std::variant<Shapes, Rejection> content;  ///< the message of the rejection names the loop, vertex or edge
  std::vector<std::string> tags{};          ///< empty if malformed
};

/// Reads one case and reports the first rejection of the contract that applies, in the order of the contract.
///
/// Numbers are read as the nearest doubles; a number beyond the finite doubles is `not-finite`. Besides `id`, `ball`,
/// `motion`, `polygon`, `expected` and `tags`, unknown keys are allowed and ignored. Within `expected`, an unknown key
/// makes the case malformed. A duplicate key anywhere, or arrays and objects nested deeper than kMostLevels, also make
/// it malformed. Throws NotJson. Cost: that of exact::validate, plus time linear in the length of the line.
[[nodiscard]] Case read_case(std::string_view line);

}  // namespace touchstone::cases
