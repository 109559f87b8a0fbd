// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/source_location.h"

#include "geometry/io/detail/legible.h"

namespace touchstone::io {

std::string sentence(const std::string& file, SourceLocation place, const std::string& reason) {
  return all_legible(file) + (place.unit == SourceLocation::Unit::Line ? ": line " : ": byte ") +
         std::to_string(place.number) + ": " + reason;
}

}  // namespace touchstone::io
