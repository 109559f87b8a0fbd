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

/// A closed, bumpy torus of about so many triangles (4 m^2, m at least 3), all different, about 8 across: coordinates
/// have all bits.
[[nodiscard]] std::vector<Triangle> torus(std::size_t triangles);

/// Meshes in the cells of a cube, each scaled by the power of two that makes its longest side at least 1/2 and less
/// than 1: a real machine's parts in one size. Faces of more vertices are fans of triangles; degenerate triangles are
/// left out.
class Machine {
 public:
  /// All meshes in a folder and those below it, whatever is wrong in them left out. Throws std::runtime_error where
  /// there is none, BrokenMesh for a file that cannot be read.
  explicit Machine(const std::filesystem::path& folder);

  [[nodiscard]] std::size_t triangle_count() const { return triangle_count_; }
  /// The machine again and again, until there are so many triangles; never more.
  [[nodiscard]] std::vector<Triangle> replicated(std::size_t triangles) const;

 private:
  std::vector<std::vector<Triangle>> parts_;
  std::size_t triangle_count_ = 0;
};

/// Where balls lie in a scene. Their radii are 1/2 to 3/2 of the median size of its triangles, sqrt(2 area).
enum class BallPlace {
  Near,      ///< at most two radii, along each axis, from a random point of a random triangle
  Anywhere,  ///< uniform in the scene's box
  Touching,  ///< Near, but with the double that is nearest to the exact distance as the radius: at one double from
             ///< contact
};

[[nodiscard]] std::string_view word(BallPlace place);

/// So many balls: a function of the arguments. Those of `Touching` are drawn as of `Near`; who knows the distances sets
/// the radii.
[[nodiscard]] std::vector<Ball> draw_scene_balls(BallPlace place, const std::vector<Triangle>& triangles,
                                                 std::uint64_t count, std::uint64_t seed);

}  // namespace touchstone::bench_scenes
