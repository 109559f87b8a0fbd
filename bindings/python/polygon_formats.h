// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pytypes.h>

#include <vector>

#include "geometry/shapes/polygon.h"

namespace touchstone::python {

/// Returns the outer loop and the holes of a polygon in GeoJSON, as a dict or as the `__geo_interface__` of an object,
/// or in WKT, as a str. Each ends with its first point. Points of two coordinates get z = 0.
///
/// Throws pybind11::type_error for other objects, what doubles_of throws, and Rejected for another geometry than a
/// polygon and for malformed text, with the place.
[[nodiscard]] std::vector<Loop> closed_loops_of(pybind11::handle object);

}  // namespace touchstone::python
