// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace touchstone::run {

/// Returns the fault that the JSON library found in a text, without the library's tag: `line 2, column 5: reason`, or
/// `column 5: reason` if the text is given and has one line. Columns count bytes, from 1. A reason without a place,
/// such as a missing key, stands alone. The result is printable, and long quotations are cut.
[[nodiscard]] std::string json_fault(const nlohmann::json::exception& error, std::string_view text = {});

}  // namespace touchstone::run
