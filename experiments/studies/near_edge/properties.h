// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/cases/crossings.h"

namespace touchstone::near_edge {

/// What failures may depend on besides the clearance in u x size.
enum class Property {
  Radius,    ///< the radius, as a share of the size
  Thinness,  ///< the square of the size over the area: small normals are rounded more
  Tilt,      ///< the normal's largest component, of length 1: 1 along an axis, 0.58 where all three tie
  Length,    ///< of the edge next to the ball, as a share of the size
  Angle,     ///< between the edges that meet at the vertex next to the ball, in degrees
};
inline constexpr std::array kProperties{Property::Radius, Property::Thinness, Property::Tilt, Property::Length,
                                        Property::Angle};
[[nodiscard]] std::string_view to_string(Property property);

/// Returns the ends of the ranges of a property, ascending; what lies beyond the last one belongs to the last range.
[[nodiscard]] const std::vector<double>& ends(Property property);

/// By Property, the range in which a crossing lies, or nothing if it has none: only balls at an edge have one of Length,
/// only those at a vertex one of Angle.
using Ranges = std::array<std::optional<std::size_t>, kProperties.size()>;
[[nodiscard]] Ranges ranges(const cases::Crossing& crossing);

}  // namespace touchstone::near_edge
