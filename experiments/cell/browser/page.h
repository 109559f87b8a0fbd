// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/cell/browser/cell_json.h"

namespace touchstone::cell::browser {

/// The page as one text of HTML that refers to no other file. Its sources are in page/, and part of the program.
///
/// It asks the server that it came from.
[[nodiscard]] std::string live_page();
/// It plays this run, and asks nobody: it says so to the browser, which then allows no connection.
[[nodiscard]] std::string recorded_page(const Json& cell, const Json& run);

}  // namespace touchstone::cell::browser
