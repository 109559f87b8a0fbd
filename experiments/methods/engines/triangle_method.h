// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/methods/add_methods.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::methods {

/// An engine that decides whether a ball touches one triangle; nothing if the engine cannot handle the input.
using TriangleContact = std::optional<bool> (*)(const Ball& ball, const Triangle& triangle);

/// Returns a method that uses such an engine: a ball touches a polygon if it touches one of its triangles. `summary` is
/// one line.
[[nodiscard]] std::unique_ptr<Method> triangle_method(std::string_view name, std::string_view summary,
                                                      TriangleContact contact);

/// An engine that processes all triangles of a polygon at once.
class TriangleSet {
 public:
  virtual ~TriangleSet() = default;
  /// Returns whether the ball touches a triangle; nothing if the engine cannot handle the input. Several threads may
  /// call it.
  [[nodiscard]] virtual std::optional<bool> contact(const Ball& ball) const = 0;
};
using BuildTriangleSet = std::unique_ptr<TriangleSet> (*)(std::vector<Triangle> triangles);

[[nodiscard]] std::unique_ptr<Method> triangle_set_method(std::string_view name, std::string_view summary,
                                                          BuildTriangleSet build);

}  // namespace touchstone::methods
