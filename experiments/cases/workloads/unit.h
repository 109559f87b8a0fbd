// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "geometry/shapes/mesh.h"

namespace touchstone::workloads {

/// A unit of length, in micrometres.
struct Unit {
  std::string_view name;
  std::int64_t micrometres;
  friend bool operator==(const Unit&, const Unit&) = default;
};

/// Returns the unit named um, mm, cm, m, inch (25.4 mm) or foot (12 inches). Throws std::invalid_argument, which lists
/// these names.
[[nodiscard]] Unit find_unit(std::string_view name);

/// Converts a length to another unit: the exact ratio, rounded once to the nearest double; the length itself if the
/// units are equal. Returns infinity if that rounds beyond the finite doubles. Requires a finite length and rounding to
/// nearest.
[[nodiscard]] double converted(double length, const Unit& from, const Unit& to);

/// Converts every coordinate likewise. Throws std::range_error, which names the vertex, if a coordinate leaves the
/// finite doubles.
void convert(Mesh& mesh, const Unit& from, const Unit& to);

}  // namespace touchstone::workloads
