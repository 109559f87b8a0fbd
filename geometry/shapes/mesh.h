// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "../floating_point.h"

namespace touchstone {

/// Vertices and faces as a file gives them: each face a loop of vertex numbers (from 0), of three or more vertices,
/// planar or not. Nothing is welded, triangulated or repaired; coordinates are the doubles nearest to the file's
/// numbers, in the file's own unit.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;          ///< in the order of the file
  std::vector<std::vector<std::uint32_t>> faces;  ///< the numbers of each one's vertices
};

}  // namespace touchstone
