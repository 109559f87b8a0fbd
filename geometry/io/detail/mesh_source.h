// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "geometry/io/place.h"
#include "geometry/io/read_mesh.h"

namespace touchstone::io {

/// A fault after which the rest of the file means nothing, so that even OnFault::Skip stops reading there.
class StructureLost : public BrokenMesh {
 public:
  using BrokenMesh::BrokenMesh;
};

/// A mesh file in memory, and how messages name its places.
struct MeshSource {
  std::string name;
  std::string bytes;

  /// One part is wrong: the reader may go on with the next.
  [[noreturn]] void broken(Place place, const std::string& reason) const {
    throw BrokenMesh(sentence(name, place, reason));
  }

  /// The reader cannot tell where the next part begins.
  [[noreturn]] void lost(Place place, const std::string& reason) const {
    throw StructureLost(sentence(name, place, reason));
  }

  /// Text of two or four bytes a character begins so; UTF-8 does not.
  [[nodiscard]] bool has_wide_byte_order_mark() const {
    using namespace std::string_view_literals;
    return bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv) || bytes.starts_with("\0\0\xFE\xFF"sv);
  }

  /// The point itself; broken if a coordinate is infinite or not a number.
  [[nodiscard]] const Eigen::Vector3d& finite(Place place, const Eigen::Vector3d& point) const {
    if (!point.allFinite()) broken(place, "a coordinate is not a finite number");
    return point;
  }
};

}  // namespace touchstone::io
