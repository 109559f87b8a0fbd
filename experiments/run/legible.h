// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace touchstone::run {

/// The beginning of bytes that were given from outside, for a sentence: 200 bytes at most, and `...` if there are more;
/// control characters, byte order marks and bytes that are not UTF-8 as in `\x1b`.
[[nodiscard]] std::string legible(std::string_view bytes);

}  // namespace touchstone::run
