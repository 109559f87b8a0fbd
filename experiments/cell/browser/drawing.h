// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/cell/model/solid_faces.h"

namespace touchstone::cell::browser {

/// The faces of a solid as they are drawn. Pictures are made of it, never answers.
struct Drawing {
  std::vector<Eigen::Vector3d> points;  ///< different ones
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::size_t> face_ends;  ///< of each face, one past the last of its triangles
  /// The edges that faces meet in at more than 20 degrees, or that have not two faces.
  std::vector<std::array<std::uint32_t, 2>> outline;
};

[[nodiscard]] Drawing drawing_of(const SolidFaces& solid);

}  // namespace touchstone::cell::browser
