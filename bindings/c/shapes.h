// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "bindings/c/touchstone.h"
#include "geometry/contact/answer.h"
#include "geometry/contact/first_contact.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/triangle.h"
#include "robust/filtered/filtered.h"

/// The polygon that a handle points to.
struct touchstone_polygon {
  /// Requires that `exact::validate` accepts the polygon.
  explicit touchstone_polygon(touchstone::Polygon valid) : shape(std::move(valid)), prepared(shape) {}

  touchstone::Polygon shape;
  touchstone::filtered::PreparedPolygon prepared;
};

/// Shapes of C as those of C++, which have the same layout and are used without a copy, and answers of C++ as those of
/// C. Functions that take shapes throw std::invalid_argument for NULL, and Rejected, which names the first element of
/// several, if the contract rejects one.
namespace touchstone::c {

[[nodiscard]] std::span<const Ball> balls_of(const touchstone_ball* balls, std::size_t count);
[[nodiscard]] std::span<const Motion> motions_of(const touchstone_motion* motions, std::size_t count);
[[nodiscard]] std::span<const Eigen::Vector3d> points_of(const double* points, std::size_t count);
/// Triangles may be degenerate.
[[nodiscard]] std::span<const Triangle> triangles_of(const touchstone_triangle* triangles, std::size_t count);
/// Copies the triangles, without a check of their coordinates.
[[nodiscard]] std::vector<Triangle> triangles_of(const touchstone_mesh& mesh);
/// Throws Rejected for the first triangle that the contract rejects; `element` is how the message names triangles.
void expect_valid(const char* element, std::span<const Triangle> triangles, Degenerate degenerate);

[[nodiscard]] touchstone_answer in_c(const Answer& answer);
[[nodiscard]] touchstone_closest_point in_c(const ClosestPoint& closest);
[[nodiscard]] touchstone_feature in_c(const Feature& feature);
[[nodiscard]] touchstone_first_contact in_c(const FirstContact& contact);
/// Enumerations have the numbers of those in C++.
template <class Enumeration>
requires std::is_enum_v<Enumeration>
[[nodiscard]] constexpr std::int32_t in_c(Enumeration value) { return static_cast<std::int32_t>(value); }

}  // namespace touchstone::c
