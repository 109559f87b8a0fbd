// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/methods/engines/mesh.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"

namespace touchstone::methods {

/// A mesh as built by a library. Queries do not change it; several threads may query it at once.
class BuiltScene {
 public:
  BuiltScene() = default;
  BuiltScene(const BuiltScene&) = delete;
  BuiltScene& operator=(const BuiltScene&) = delete;
  virtual ~BuiltScene() = default;

  /// Returns whether the ball touches any triangle.
  [[nodiscard]] virtual bool any(const Ball& ball) const = 0;

  // The library need not support the following queries, which then throw std::logic_error.

  /// Returns the indices of the triangles that the ball touches, in any order.
  virtual void all(const Ball& ball, std::vector<std::uint32_t>& triangles) const;
  /// Returns the triangle that is nearest to the centre, or one of several.
  [[nodiscard]] virtual std::uint32_t nearest(const Eigen::Vector3d& center) const;
  /// Returns the time at which the moving ball first touches any triangle; nothing if it never does.
  [[nodiscard]] virtual std::optional<double> first_contact(const Motion& motion) const;
  /// Returns the memory that it holds, in bytes, if the library knows that better than `malloc`.
  [[nodiscard]] virtual std::optional<std::size_t> bytes() const { return std::nullopt; }
};

/// A library that answers queries about meshes.
struct Library {
  std::string name;
  /// Builds a scene. The mesh must outlive it.
  std::function<std::unique_ptr<BuiltScene>(const Mesh&)> build;
  bool exact = false;  ///< whether its answers are the truth, which brute force checks
  bool knows_nearest = true;
  bool knows_motions = false;
};

}  // namespace touchstone::methods
