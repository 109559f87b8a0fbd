// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

/// Mesh files: places in them, and messages about them.
namespace touchstone::io {

/// A line of a text file (from 1) or a byte of a binary one (from 0).
struct SourceLocation {
  /// The unit that the number counts.
  enum class Unit { Line, Byte };
  Unit unit;           ///< lines or bytes
  std::size_t number;  ///< from 1 for lines, from 0 for bytes
};

/// Returns `arm.stl: line 12: reason`.
[[nodiscard]] std::string sentence(const std::string& file, SourceLocation place, const std::string& reason);

}  // namespace touchstone::io
