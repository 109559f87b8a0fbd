// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "geometry/shapes/polygon.h"

// Shapes as people write them on a command line.
namespace touchstone::judge {

/// Returns the polygon of a text. The text is either loops or WKT:
///  - loops are separated by `;`, the outer loop first; their points by `,`; coordinates by white space:
///    `0 0 0, 4 0 0, 0 4 0; 1 1 0, 2 1 0, 1 2 0`;
///  - WKT repeats the first point of each loop at its end, which is left out here:
///    `POLYGON Z ((0 0 0, 4 0 0, 0 4 0, 0 0 0))`.
///
/// A point of two coordinates lies at z = 0. Numbers are read as the nearest doubles. Throws std::runtime_error, which
/// names the loop and the point, if the text does not have this form, and Rejected as Polygon and exact::validate say.
[[nodiscard]] Polygon polygon_of(std::string_view text);

/// Returns the numbers of a text such as `1,2.5,-3`. Throws std::runtime_error, which names the number, if there are
/// not as many, or one is not finite.
[[nodiscard]] Eigen::VectorXd numbers_of(std::string_view text, int count);

}  // namespace touchstone::judge
