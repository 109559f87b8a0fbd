// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::bench_scenes {

/// Returns a closed, bumpy torus of about the given number of triangles (4 m^2, m at least 3), all different, about 8
/// across; the coordinates use all bits of doubles.
[[nodiscard]] std::vector<Triangle> torus(std::size_t triangles);

/// Meshes in the cells of a cube, each scaled by the power of two that makes its longest side at least 1/2 and less
/// than 1: the parts of a real machine in one size. Faces with more vertices are split into fans of triangles;
/// degenerate triangles are left out.
class Machine {
 public:
  /// Reads all meshes in a folder and its subfolders, leaving out their faulty faces. Throws std::runtime_error if the
  /// folder has no meshes, BrokenMesh for a file that cannot be read.
  explicit Machine(const std::filesystem::path& folder);

  [[nodiscard]] std::size_t triangle_count() const { return triangle_count_; }
  /// Returns copies of the machine up to the given number of triangles, never more.
  [[nodiscard]] std::vector<Triangle> replicated(std::size_t triangles) const;

 private:
  std::vector<std::vector<Triangle>> parts_;
  std::size_t triangle_count_ = 0;
};

/// The places of balls in a scene. Their radii are 1/2 to 3/2 of the median size of its triangles, sqrt(2 area).
enum class BallPlace {
  Near,      ///< at most two radii, along each axis, from a random point of a random triangle
  Anywhere,  ///< uniform in the scene's box
  Touching,  ///< Near, but with the double that is nearest to the exact distance as the radius: at one double from
             ///< contact
};

[[nodiscard]] std::string_view to_string(BallPlace place);

/// Draws `count` balls, a function of the arguments. Balls for `Touching` are drawn as for `Near`; the caller, who
/// knows the distances, sets the radii.
[[nodiscard]] std::vector<Ball> draw_scene_balls(BallPlace place, const std::vector<Triangle>& triangles,
                                                 std::uint64_t count, std::uint64_t seed);

}  // namespace touchstone::bench_scenes
