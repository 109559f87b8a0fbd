// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

#include "geometry/io/read_mesh.h"

namespace touchstone::io {

/// A fault after which the rest of the file cannot be interpreted: even OnFault::Skip stops reading there.
class StructureLost : public BrokenMesh {
 public:
  using BrokenMesh::BrokenMesh;
};

/// A mesh file in memory, and the faults found in it.
struct MeshSource {
  std::string name;
  std::string bytes;

  /// Reports a fault of one part. The reader may continue with the next part.
  [[noreturn]] void broken(SourceLocation place, const std::string& reason) const {
    throw BrokenMesh(sentence(name, place, reason));
  }

  /// Reports a fault after which the reader cannot tell where the next part begins.
  [[noreturn]] void lost(SourceLocation place, const std::string& reason) const {
    throw StructureLost(sentence(name, place, reason));
  }

  /// Returns whether the file begins with a byte order mark of UTF-16 or UTF-32.
  [[nodiscard]] bool has_wide_byte_order_mark() const {
    using namespace std::string_view_literals;
    return bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv) || bytes.starts_with("\0\0\xFE\xFF"sv);
  }

  /// Returns the point. Reports a fault if a coordinate is infinite or not a number.
  [[nodiscard]] const Eigen::Vector3d& finite(SourceLocation place, const Eigen::Vector3d& point) const {
    if (!point.allFinite()) broken(place, "a coordinate is not a finite number");
    return point;
  }
};

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

  /// Returns whether the bytes that are left are blanks, ends of lines or zero.
  [[nodiscard]] bool only_blanks_left() const {
    using namespace std::string_view_literals;
    return std::string_view(source_.bytes).find_first_not_of(" \t\r\n\0"sv, position_) == std::string_view::npos;
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
