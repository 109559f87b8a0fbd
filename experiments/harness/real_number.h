// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace touchstone::harness {

/// A check for options of the command line: the empty string where the text is a decimal number whose nearest double is
/// from `lowest` to `highest`, and 0 only where the number is, else what is wrong.
[[nodiscard]] std::function<std::string(const std::string&)> real_number(double lowest, double highest);

}  // namespace touchstone::harness
