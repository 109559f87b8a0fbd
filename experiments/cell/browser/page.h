// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/cell/browser/cell_json.h"

namespace touchstone::cell::browser {

/// Returns the page as one HTML text that refers to no other file. Its sources are in page/ and are part of the
/// program.
///
/// This page queries the server that it came from.
[[nodiscard]] std::string live_page();
/// This page plays back the given run only. It forbids the browser every connection.
[[nodiscard]] std::string recorded_page(const Json& cell, const Json& run);

}  // namespace touchstone::cell::browser
