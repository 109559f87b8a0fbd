// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "experiments/harness/json/strict_json.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/rejection.h"

namespace touchstone::cases {

/// A ball and a polygon that every method may be asked about.
struct Shapes {
  Ball ball;
  Polygon polygon;
};

/// One line of a file of cases, as the contract reads it.
struct Case {
  std::optional<std::string> id;            ///< absent only from malformed cases
  std::optional<nlohmann::json> expected;   ///< an object: any of an answer's keys, or `error`; absent if malformed
  std::variant<Shapes, Rejection> content;  ///< the rejection's message names the loop, vertex or edge
};

/// Reads one case and decides every rejection of the contract, the first that applies in its order.
///
/// Numbers are read as the nearest doubles; one beyond the finite doubles is `not-finite`. Keys that the contract does
/// not know are allowed beside `id`, `ball`, `polygon`, `expected` and `tags` and mean nothing; in `expected` they make
/// the case malformed, as do a duplicate key anywhere and more than kMostLevels arrays and objects within each other.
/// Throws NotJson. Cost: that of exact::validate, and linear in the length of the line.
[[nodiscard]] Case read_case(std::string_view line);

}  // namespace touchstone::cases
