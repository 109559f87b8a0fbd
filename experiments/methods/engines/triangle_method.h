// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/methods/add_methods.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::methods {

/// An engine that decides whether a ball touches one triangle; nothing if the engine cannot handle the input.
using TriangleContact = std::optional<bool> (*)(const Ball& ball, const Triangle& triangle);

/// The answer of an engine about a moving ball.
struct Sweep {
  bool touches;
  std::optional<double> time{};  ///< the first, if the engine tells; infinite without contact
};
/// An engine that decides whether a moving ball touches one triangle; nothing if the engine cannot handle the input.
using TriangleSweep = std::optional<Sweep> (*)(const Motion& motion, const Triangle& triangle);

/// Returns a method that uses such engines: a ball touches a polygon if it touches one of its triangles, at the least
/// of their times. `summary` is one line. Without `sweep` it cannot answer about moving balls.
[[nodiscard]] std::unique_ptr<Method> triangle_method(std::string_view name, std::string_view summary,
                                                      TriangleContact contact, TriangleSweep sweep = nullptr);

/// An engine that processes all triangles of a polygon at once.
class TriangleSet {
 public:
  virtual ~TriangleSet() = default;
  /// Returns whether the ball touches a triangle; nothing if the engine cannot handle the input. Several threads may
  /// call it.
  [[nodiscard]] virtual std::optional<bool> contact(const Ball& ball) const = 0;

  /// Returns whether `sweep` may be called.
  [[nodiscard]] virtual bool sweeps() const { return false; }
  /// Returns the same as `contact` about a moving ball.
  [[nodiscard]] virtual std::optional<Sweep> sweep(const Motion& motion) const;
};
using BuildTriangleSet = std::unique_ptr<TriangleSet> (*)(std::vector<Triangle> triangles);

[[nodiscard]] std::unique_ptr<Method> triangle_set_method(std::string_view name, std::string_view summary,
                                                          BuildTriangleSet build);

}  // namespace touchstone::methods
