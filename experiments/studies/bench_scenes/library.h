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
#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::bench_scenes {

/// One scene as built by a library, for queries by one thread.
class BuiltScene {
 public:
  BuiltScene() = default;
  BuiltScene(const BuiltScene&) = delete;
  BuiltScene& operator=(const BuiltScene&) = delete;
  virtual ~BuiltScene() = default;

  /// Returns whether the ball touches any triangle.
  virtual bool any(const Ball& ball) = 0;
  /// Returns the indices of the triangles that the ball touches, in any order.
  virtual void all(const Ball& ball, std::vector<std::uint32_t>& triangles) = 0;
  /// Returns the triangle that is nearest to the centre, or one of several. Throws std::logic_error if the library does
  /// not support this query.
  virtual std::uint32_t nearest(const Eigen::Vector3d& center);
  /// Returns the time at which the moving ball first touches any triangle; nothing if it never does. Throws
  /// std::logic_error if the library does not support this query.
  virtual std::optional<double> first_contact(const Motion& motion);
  /// Returns the memory that it holds, in bytes, if the library knows that better than `malloc`.
  [[nodiscard]] virtual std::optional<std::size_t> bytes() const { return std::nullopt; }
};

/// A library that answers queries about scenes.
struct Library {
  std::string name;
  /// Builds a scene. The triangles must outlive it.
  std::function<std::unique_ptr<BuiltScene>(std::span<const Triangle>)> build;
  bool exact = false;  ///< whether its answers are the truth, which brute force checks
  bool knows_nearest = true;
  bool knows_motions = false;
};

// One a file. Where a library answers by boxes alone, the triangles are asked by `fast::contact`, plain doubles.
[[nodiscard]] Library touchstone_library();
[[nodiscard]] Library boost_rtree_library();
[[nodiscard]] Library cgal_aabb_tree_library();
// What textbooks name (broad_phases/): conservative candidates, then `fast::contact`; they do not know `nearest`.
[[nodiscard]] Library grid_library();
[[nodiscard]] Library octree_library();
[[nodiscard]] Library kd_tree_library();
[[nodiscard]] Library sphere_tree_library();
[[nodiscard]] Library kdop_tree_library();
[[nodiscard]] Library embree_library();  ///< with libembree-dev
[[nodiscard]] Library fcl_library();     ///< with libfcl-dev
[[nodiscard]] Library bullet_library();  ///< with libbullet-dev

/// The name of the library with which the goals compare the exact scene.
inline constexpr const char* kEmbree = "Embree 3";

/// Returns the libraries that this program was built with, the exact one first.
[[nodiscard]] std::vector<Library> all_libraries();
/// Returns the libraries that it was built without, and the Debian package that each needs.
[[nodiscard]] std::vector<std::string> absent_libraries();

}  // namespace touchstone::bench_scenes
