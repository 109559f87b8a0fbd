// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/thesis/cell/model/solid_faces.h"

namespace touchstone::cell::browser {

/// The faces of a solid as they are drawn. Used for pictures only, never for answers.
struct Drawing {
  std::vector<Eigen::Vector3d> points;  ///< without duplicates
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::size_t> face_ends;  ///< for each face, one past the last of its triangles
  /// The edges at which faces meet at more than 20 degrees, and the edges that do not have exactly two faces.
  std::vector<std::array<std::uint32_t, 2>> outline;
};

[[nodiscard]] Drawing drawing_of(const SolidFaces& solid);

}  // namespace touchstone::cell::browser
