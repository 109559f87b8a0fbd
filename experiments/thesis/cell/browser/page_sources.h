// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace touchstone::cell::browser {

/// Returns a file of page/ as it was when the program was built (embed.cmake writes the definition). Throws
/// std::out_of_range for any other name.
[[nodiscard]] std::string_view page_source(std::string_view name);

}  // namespace touchstone::cell::browser
