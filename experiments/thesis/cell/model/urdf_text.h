// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::cell {

/// The lines of the root element and of its direct children, if they have a `name`, by kind and name; the first of
/// several with the same name.
using XmlLines = std::map<std::pair<std::string, std::string>, std::size_t, std::less<>>;

/// The text of a URDF that urdfdom can read.
struct UrdfText {
  std::string text;
  XmlLines lines;
  std::vector<std::string> warnings;  ///< of what was added; each begins with the line
};

/// Checks that a text is well-formed XML in UTF-8 within the limits of urdf_text.cpp, without a document type. Adds
/// what urdfdom demands and descriptions leave out: a `limit` of -360 and 360 degrees to a revolute joint without any,
/// and `effort` and `velocity` of 0, which say nothing. Throws BadCell, whose message begins with `file`. Cost: linear
/// in the length of the text.
[[nodiscard]] UrdfText checked_urdf(const std::string& text, const std::string& file);

}  // namespace touchstone::cell
