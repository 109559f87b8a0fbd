// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

/// How files are read.
namespace touchstone::io {

/// A line of a text file (from 1) or a byte of a binary one (from 0).
struct Place {
  /// What is counted.
  enum class Unit { Line, Byte };
  Unit unit;           ///< of the number
  std::size_t number;  ///< from 1 or 0
};

/// `arm.stl: line 12: reason`.
[[nodiscard]] std::string sentence(const std::string& file, Place place, const std::string& reason);

}  // namespace touchstone::io
