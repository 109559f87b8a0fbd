// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/case.h"

// Answers and cases as JSON values: for files that read JSON, or add keys of their own. Others use output_lines.h.
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
                           const Json& expected = nullptr);

/// Returns one line of JSON, with numbers in the shortest form that reads back as the same double (std::to_chars).
[[nodiscard]] std::string to_line(const Json& verdict);

}  // namespace touchstone::cases
