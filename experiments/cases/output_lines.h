// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/case.h"

namespace touchstone::cases {

// Lines of JSON, with numbers in the shortest form that reads back as the same double (std::to_chars).

/// Returns the verdict of a method or an engine: `id`, `method`, and what it stated. With the radius of the ball, adds
/// the keys of --explain: `stage`, if the method reports it, and `margin`, the number of doubles by which the radius
/// exceeds the distance of the answer (null if the method does not compute a distance; none for a moving ball).
[[nodiscard]] std::string verdict_line(const std::string& id, std::string_view method, const StatedAnswer& answer,
                                       std::optional<double> explained_radius = std::nullopt);
/// Returns the verdict of a method that cannot answer about moving balls: `id`, `method` and `"unanswered":"motion"`.
[[nodiscard]] std::string unanswered_line(const std::string& id, std::string_view method);
/// Returns the verdict on a rejected case: `id` (null if missing), `method`, `error` and `message`.
[[nodiscard]] std::string verdict_line(const std::optional<std::string>& id, std::string_view method,
                                       const Rejection& rejection);

/// Returns a case in the form of the contract; without an expectation, it has no `expected`.
[[nodiscard]] std::string case_line(const std::string& id, const AnyShapes& shapes,
                                    const std::vector<std::string>& tags,
                                    const std::optional<PartialAnswer>& expected = std::nullopt);

}  // namespace touchstone::cases
