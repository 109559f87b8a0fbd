// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/case.h"

// Answers and cases as JSON values, and as lines of JSON.
namespace touchstone::cases {

/// An object that keeps the order of its keys.
using Json = nlohmann::ordered_json;

/// Returns the keys that a method computed, in the form of a verdict or of `expected`. Numbers beyond the finite
/// doubles become null, -0 becomes 0. Keys for which `is_null` holds are null.
[[nodiscard]] Json object_of(const PartialAnswer& answer);

/// Returns `center` and `radius`.
[[nodiscard]] Json object_of(const Ball& ball);
/// Returns `to`.
[[nodiscard]] Json object_of(const Motion& motion);
/// Returns `outer` and `holes`.
[[nodiscard]] Json object_of(const Polygon& polygon);
/// Returns `vertices` and `faces`.
[[nodiscard]] Json object_of(const Mesh& mesh);
/// Returns `rotation` and `translation`.
[[nodiscard]] Json object_of(const Pose& pose);

/// Reads the keys of an answer, `error` and `message` of an object: `expected` of a case, or the reply of an engine.
/// Ignores other keys.
[[nodiscard]] StatedAnswer stated_in(const nlohmann::json& object);

/// Returns the number if JSON has an index: 1.0 is the index 1.
[[nodiscard]] std::optional<std::size_t> index_in(const nlohmann::json& value);

/// Returns a case in the form of the contract, without `expected` if that is null. The pose of a mesh is left out if it
/// is the identity.
[[nodiscard]] Json case_of(const std::string& id, const AnyShapes& shapes, const std::vector<std::string>& tags,
                           const Json& expected);

/// Returns one line of JSON, with numbers in the shortest form that reads back as the same double (std::to_chars).
[[nodiscard]] std::string to_line(const Json& verdict);

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
