// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace touchstone::run {

/// Returns a text as the content of an element or attribute of XML or HTML: `&`, `<`, `>` and quotation marks become
/// entities, and what is not legible is escaped as io::legible does. Line ends stay.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace touchstone::run
