// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::figures {

/// A loop in the plane z = 0 on which the thesis's method is known to be wrong. Extents are about 1 to 5.
struct Outline {
  std::string_view name;
  std::vector<std::pair<double, double>> corners;

  [[nodiscard]] Polygon polygon() const;
  [[nodiscard]] double area() const;
};

/// Returns the outlines triangle, square, L, U3x3, U3x5, comb, dart, star.
[[nodiscard]] const std::vector<Outline>& outlines();
/// Returns the outline of that name. Requires the name of one of them.
[[nodiscard]] const Outline& find_outline(std::string_view name);

/// A rectangle in the plane z = 0.
struct Box {
  double left, right, bottom, top;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return top - bottom; }
  [[nodiscard]] double area() const { return width() * height(); }
  [[nodiscard]] Box enlarged(double dx, double dy) const { return {left - dx, right + dx, bottom - dy, top + dy}; }
  /// Uniform.
  [[nodiscard]] Eigen::Vector3d point(workloads::Random& random) const;
};

[[nodiscard]] Box bounds(const Outline& outline);

}  // namespace touchstone::figures
