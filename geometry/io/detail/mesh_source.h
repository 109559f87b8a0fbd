// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
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

}  // namespace touchstone::io
