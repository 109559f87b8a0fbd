// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::program {

/// Quotes a text as one word of a shell command.
[[nodiscard]] std::string shell_quoted(const std::string& word);
/// Returns the words of a line of plain and quoted words, with what a shell would take of quotes and backslashes.
[[nodiscard]] std::vector<std::string> shell_words(const std::string& line);

/// Returns a text as the content of an element or attribute of XML or HTML: `&`, `<`, `>` and quotation marks become
/// entities, and what is not legible is escaped as io::legible does. Line ends stay.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace touchstone::program
