// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace touchstone::cell {

/// Thrown for text that is not XML, or XML that exceeds our limits; the message begins with the line.
class BadXml : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The lines of the root element and of its direct children, if they have a `name`, by kind and name; the first of
/// several with the same name.
using XmlLines = std::map<std::pair<std::string, std::string>, std::size_t, std::less<>>;

/// Limits of XML that is read: the parser of urdfdom recurses from level to level, in time quadratic in their number,
/// looks for an attribute among all of its element's, and frees a chain of links by recursion.
inline constexpr std::size_t kMostXmlLevels = 64, kMostXmlAttributes = 64, kMostXmlElements = 100'000,
                             kMostNamedInRoot = 2'000;

/// Checks that a text is well-formed XML in UTF-8 within these limits, without a document type, by expat, which does
/// not recurse. Throws BadXml. Cost: linear in the length of the text.
[[nodiscard]] XmlLines check_xml(std::string_view text);

}  // namespace touchstone::cell
