// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "../floating_point.h"

namespace touchstone {

/// Vertices and faces as read from a file.
///
/// Each face is a loop of three or more vertex numbers, counted from 0; it need not be planar. Nothing is welded,
/// triangulated or repaired. Coordinates are the doubles nearest to the numbers in the file, in the file's unit.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;          ///< in the order of the file
  std::vector<std::vector<std::uint32_t>> faces;  ///< the vertex numbers of each face
};

}  // namespace touchstone
