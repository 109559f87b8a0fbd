// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>

#include "geometry/io/detail/mesh_source.h"

namespace touchstone::io {

/// Reads numbers from the bytes of a binary file, in either byte order.
class ByteReader {
 public:
  ByteReader(const MeshSource& source, std::size_t position, std::endian order)
      : source_(source), position_(std::min(position, source.bytes.size())), reversed_(order != std::endian::native) {}

  [[nodiscard]] SourceLocation place() const { return {SourceLocation::Unit::Byte, position_}; }
  [[nodiscard]] std::size_t bytes_left() const { return source_.bytes.size() - position_; }

  template <class Number>
  Number take() {
    need(sizeof(Number));
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(source_.bytes.data() + position_, bytes.size(), bytes.data());
    if (reversed_) std::reverse(bytes.begin(), bytes.end());
    position_ += bytes.size();
    return std::bit_cast<Number>(bytes);
  }

  void skip(std::size_t size) {
    need(size);
    position_ += size;
  }

  /// Reports a fault if bytes are left over at the end.
  void file_is_done() const {
    if (bytes_left() > 0)
      source_.broken(place(),
                     std::to_string(bytes_left()) + " bytes left over after the elements that the counts declare");
  }

 private:
  void need(std::size_t size) const {
    if (bytes_left() < size)
      source_.lost(place(), "the file is truncated: expected " + std::to_string(size) + " bytes, found " +
                                std::to_string(bytes_left()));
  }

  const MeshSource& source_;
  std::size_t position_;
  bool reversed_;
};

}  // namespace touchstone::io
