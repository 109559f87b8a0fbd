// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string>

namespace touchstone::run {

enum class Colour { Red, Green, Bold };

/// Returns whether output may be coloured: the stream is a terminal, the environment variable NO_COLOR is missing or
/// empty (no-color.org), and TERM is not `dumb`.
[[nodiscard]] bool takes_colours(std::FILE* stream);

/// Returns the text in that colour if the stream takes colours, else the text.
[[nodiscard]] std::string coloured(const std::string& text, Colour colour, std::FILE* stream);

}  // namespace touchstone::run
