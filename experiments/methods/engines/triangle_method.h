// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/methods/engines/engines.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::methods {

/// An engine that decides whether a ball touches one triangle; nothing if the engine cannot handle the input.
using TriangleContact = std::optional<bool> (*)(const Ball& ball, const Triangle& triangle);
/// An engine that decides whether a moving ball touches one triangle, without a time; nothing likewise.
using TriangleSweep = std::optional<bool> (*)(const Motion& motion, const Triangle& triangle);
/// Whether the engine answers about the polygon that these triangles cover.
using TrianglesFilter = bool (*)(const std::vector<Triangle>& triangles);

/// Returns a method that uses such engines: a ball touches a polygon if it touches one of its triangles. `summary` is
/// one line. Without `sweep` it cannot answer about moving balls. It is unsure about polygons that `answers` refuses.
[[nodiscard]] std::unique_ptr<Method> triangle_method(std::string_view name, std::string_view summary,
                                                      TriangleContact contact, TriangleSweep sweep = nullptr,
                                                      TrianglesFilter answers = nullptr);

/// Returns a method that asks the library about the triangles of a polygon as a mesh. A moving ball that touches at its
/// start touches at time 0, which not every sweep says of a ball that rests or moves away.
[[nodiscard]] std::unique_ptr<Method> mesh_method(std::string_view name, std::string_view summary, Library library);

}  // namespace touchstone::methods
