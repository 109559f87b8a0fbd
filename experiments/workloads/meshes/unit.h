// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "geometry/shapes/mesh.h"

namespace touchstone::workloads {

/// A unit of length, as so many micrometres.
struct Unit {
  std::string_view name;
  std::int64_t micrometres;
  friend bool operator==(const Unit&, const Unit&) = default;
};

/// um, mm, cm, m, inch (25.4 mm) or foot (12 inches). Throws std::invalid_argument, which names those that there are.
[[nodiscard]] Unit find_unit(std::string_view name);

/// A length in another unit: the exact ratio, rounded once to the nearest double; the length itself where the units
/// are equal. Infinite where that rounds beyond the finite doubles. Requires a finite length, and round to nearest.
[[nodiscard]] double converted(double length, const Unit& from, const Unit& to);

/// Every coordinate, as above. Throws std::range_error, which names the vertex, where one leaves the finite doubles.
void convert(Mesh& mesh, const Unit& from, const Unit& to);

}  // namespace touchstone::workloads
