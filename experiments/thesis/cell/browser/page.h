// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace touchstone::cell::browser {

/// Returns the page as one HTML text that refers to no other file. Its sources are in page/ and are part of the
/// program.
///
/// This page queries the server that it came from.
[[nodiscard]] std::string live_page();
/// This page plays back one run only: the texts of cell_json and run_json. It forbids the browser every connection.
[[nodiscard]] std::string recorded_page(const std::string& cell, const std::string& run);

/// Returns a file of page/ as it was when the program was built (embed.cmake writes the definition). Throws
/// std::out_of_range for any other name.
[[nodiscard]] std::string_view page_source(std::string_view name);

}  // namespace touchstone::cell::browser
