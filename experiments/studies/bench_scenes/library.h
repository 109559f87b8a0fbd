// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::bench_scenes {

/// What a library made of one scene, to be asked by one thread.
class BuiltScene {
 public:
  BuiltScene() = default;
  BuiltScene(const BuiltScene&) = delete;
  BuiltScene& operator=(const BuiltScene&) = delete;
  virtual ~BuiltScene() = default;

  /// Does the ball touch any triangle?
  virtual bool any(const Ball& ball) = 0;
  /// The triangles that it touches, by number, in any order.
  virtual void all(const Ball& ball, std::vector<std::uint32_t>& triangles) = 0;
  /// The triangle that is nearest to the centre, or one of these. Throws std::logic_error where the library does not
  /// know this question.
  virtual std::uint32_t nearest(const Eigen::Vector3d& center);
  /// The memory that it holds, in bytes, where it knows that better than `malloc`.
  [[nodiscard]] virtual std::optional<std::size_t> bytes() const { return std::nullopt; }
};

/// A way to ask about scenes.
struct Library {
  std::string name;
  /// The triangles stay where they are while what is built is asked.
  std::function<std::unique_ptr<BuiltScene>(std::span<const Triangle>)> build;
  bool exact = false;  ///< its answers are the truth, which brute force checks
  bool knows_nearest = true;
};

// One a file. Where a library answers by boxes alone, the triangles are asked by `fast::contact`, plain doubles.
[[nodiscard]] Library touchstone_library();
[[nodiscard]] Library boost_rtree_library();
[[nodiscard]] Library cgal_aabb_tree_library();
[[nodiscard]] Library embree_library();  ///< with libembree-dev
[[nodiscard]] Library fcl_library();     ///< with libfcl-dev
[[nodiscard]] Library bullet_library();  ///< with libbullet-dev

/// By this name the goals know whom to hold the exact scene against.
inline constexpr const char* kEmbree = "Embree 3";

/// All that this program was built with, the exact one first.
[[nodiscard]] std::vector<Library> all_libraries();
/// Those that it was built without, and the Debian package that each takes.
[[nodiscard]] std::vector<std::string> absent_libraries();

}  // namespace touchstone::bench_scenes
