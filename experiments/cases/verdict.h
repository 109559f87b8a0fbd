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

/// A verdict of the contract as an object whose keys keep their order.
using Verdict = nlohmann::ordered_json;

/// Is this a key of an answer: `plane`, ..., `off_plane`?
[[nodiscard]] bool is_answer_key(std::string_view key);

/// The keys that a method computed, as they stand in a verdict or in `expected`. Numbers beyond the finite doubles
/// become null, -0 becomes 0.
[[nodiscard]] Verdict object_of(const cases::PartialAnswer& answer);

/// The keys of an answer or a rejection that a reply in JSON has; its numbers as object_of writes them.
[[nodiscard]] Verdict answer_in(const nlohmann::json& reply);

/// `id` and `method`, then the keys that the method computed.
[[nodiscard]] Verdict verdict_of(const std::string& id, std::string_view method, const cases::PartialAnswer& answer);

/// `id` (null if there is none), `method`, `error` and `message`.
[[nodiscard]] Verdict verdict_of(const std::optional<std::string>& id, std::string_view method,
                                 const Rejection& rejection);

/// For --explain: adds `stage` (if the method tells) and `margin`, how many doubles the radius lies above the distance
/// of the answer (null where the method computes none).
void explain(Verdict& verdict, const cases::PartialAnswer& answer, double radius);

/// What of `expected` the verdict does not meet, a sentence for each key: `relation: expected "touching", found
/// "separate"`. Compared by value, nested objects whole: numbers of `point`, `distance` and `off_plane` as the doubles
/// nearest to them (0 = -0), others as whole numbers, for which 1.0 is 1.
[[nodiscard]] std::vector<std::string> differences(const nlohmann::json& expected, const Verdict& verdict);

/// A case in the contract's form; `expected` may be null, then it is left out.
[[nodiscard]] Verdict case_of(const std::string& id, const Ball& ball, const Polygon& polygon,
                              const std::vector<std::string>& tags, const Verdict& expected = nullptr);

/// One line of JSON, numbers in the shortest form that reads back as the same double (std::to_chars).
[[nodiscard]] std::string to_line(const Verdict& verdict);

}  // namespace touchstone::cases
