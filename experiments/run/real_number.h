// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace touchstone::run {

/// Returns a check for options of the command line. The check returns an empty string if the text is a decimal number
/// whose nearest double is from `lowest` to `highest`, and which does not round to 0 without being 0; otherwise it
/// returns the fault.
[[nodiscard]] std::function<std::string(const std::string&)> real_number(double lowest, double highest);

}  // namespace touchstone::run
