// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace touchstone::harness {

/// What the library found wrong with a text, without the library's tag: `line 2, column 5: reason`, or
/// `column 5: reason` where the text is given and is one line. Columns count bytes, from 1. A reason that has no place,
/// such as a key that is missing, stands alone. Legible, and cut where it quotes something long.
[[nodiscard]] std::string json_fault(const nlohmann::json::exception& error, std::string_view text = {});

}  // namespace touchstone::harness
