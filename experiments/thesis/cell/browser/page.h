// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace touchstone::cell::browser {

/// Returns the page as one HTML text that refers to no other file. Its sources are in page/ and are part of the
/// program.
///
/// This page queries the server that it came from.
[[nodiscard]] std::string live_page();
/// This page plays back one run only: the texts of cell_json and run_json. It forbids the browser every connection.
[[nodiscard]] std::string recorded_page(const std::string& cell, const std::string& run);

}  // namespace touchstone::cell::browser
