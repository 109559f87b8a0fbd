// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Third-party engines: the file NAME.cpp of this folder defines add_NAME(MethodList&), which all_methods calls, or
// is empty if the engine's library is missing: experiments/program/built_with.h says which are there. As methods they decide
// contact as their users would ask: engines for triangles get those of a triangulation, whose vertices are not lifted.
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/triangulate.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"
#include "robust/scene/scene.h"

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
  /// Returns the scene of this project that it is; null for a library's.
  [[nodiscard]] virtual const scene::Scene* own_scene() const { return nullptr; }
  /// Returns the memory that it holds, in bytes, if the library knows that better than `malloc`.
  [[nodiscard]] virtual std::optional<std::size_t> bytes() const { return std::nullopt; }
};

/// A library that answers queries about meshes.
struct Library {
  std::string name;
  /// Builds a scene. The mesh must outlive it.
  std::function<std::unique_ptr<BuiltScene>(const Mesh&)> build;
  bool exact = false;  ///< whether its answers are the truth, which brute force checks
  bool knows_all = true;
  bool knows_nearest = true;
  bool knows_motions = false;
};

/// @{
/// Those that know every query about a mesh, with the same answers.
[[nodiscard]] Library bullet_library();  ///< with libbullet-dev
[[nodiscard]] Library embree_library();  ///< with libembree-dev
[[nodiscard]] Library fcl_library();     ///< with libfcl-dev
/// @}

/// The name of Embree's.
inline constexpr const char* kEmbree = "Embree 3";

/// An engine that decides whether a ball touches one triangle; nothing if the engine cannot handle the input.
using TriangleContact = std::optional<bool> (*)(const Ball& ball, const Triangle& triangle);
/// An engine that decides whether a moving ball touches one triangle, without a time; nothing likewise.
using TriangleSweep = std::optional<bool> (*)(const Motion& motion, const Triangle& triangle);
/// Whether the engine answers about the polygon that these triangles cover.
using TrianglesFilter = bool (*)(const std::vector<Triangle>& triangles);

/// Returns a method that uses such engines: a ball touches a polygon if it touches one of its triangles. `summary` is
/// one line. Without `sweep` it cannot answer about moving balls. It is unsure about polygons that `answers` refuses.
[[nodiscard]] std::unique_ptr<Method> triangle_method(const char* name, const char* summary, TriangleContact contact,
                                                      TriangleSweep sweep = nullptr, TrianglesFilter answers = nullptr);

/// Returns a method that asks the library about the triangles of a polygon or of the faces of a mesh. A moving ball
/// that touches at its start touches at time 0, which not every sweep says of a ball that rests or moves away.
[[nodiscard]] std::unique_ptr<Method> mesh_method(const char* name, const char* summary, Library library);

}  // namespace touchstone::methods
