// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/method.h"
#include "geometry/shapes/rejection.h"

namespace touchstone::cases {

/// A verdict of the contract: an object that keeps the order of its keys.
using Verdict = nlohmann::ordered_json;

/// Returns whether this is a key of an answer: `plane`, ..., `off_plane`.
[[nodiscard]] bool is_answer_key(std::string_view key);

/// Returns the keys that a method computed, in the form of a verdict or of `expected`. Numbers beyond the finite
/// doubles become null, -0 becomes 0.
[[nodiscard]] Verdict object_of(const cases::PartialAnswer& answer);

/// Returns the keys of an answer or a rejection that a JSON reply contains, with numbers as object_of writes them.
[[nodiscard]] Verdict answer_in(const nlohmann::json& reply);

/// Returns `id` and `method`, then the keys that the method computed.
[[nodiscard]] Verdict verdict_of(const std::string& id, std::string_view method, const cases::PartialAnswer& answer);

/// Returns `id` (null if missing), `method`, `error` and `message`.
[[nodiscard]] Verdict verdict_of(const std::optional<std::string>& id, std::string_view method,
                                 const Rejection& rejection);

/// Adds the keys of --explain: `stage`, if the method reports it, and `margin`, the number of doubles by which the
/// radius exceeds the distance of the answer (null if the method does not compute a distance).
void explain(Verdict& verdict, const cases::PartialAnswer& answer, double radius);

/// Returns the expectations that the verdict does not meet, one sentence for each key: `relation: expected "touching",
/// found "separate"`. Compares by value, nested objects as a whole: numbers of `point`, `distance` and `off_plane` as
/// their nearest doubles (0 = -0), other numbers as integers, for which 1.0 equals 1.
[[nodiscard]] std::vector<std::string> differences(const nlohmann::json& expected, const Verdict& verdict);

/// Returns a case in the form of the contract, without `expected` if that is null.
[[nodiscard]] Verdict case_of(const std::string& id, const Ball& ball, const Polygon& polygon,
                              const std::vector<std::string>& tags, const Verdict& expected = nullptr);

/// Returns one line of JSON, with numbers in the shortest form that reads back as the same double (std::to_chars).
[[nodiscard]] std::string to_line(const Verdict& verdict);

}  // namespace touchstone::cases
