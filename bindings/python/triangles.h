// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "bindings/python/doubles.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::python {

/// An array of n x 3 x 3, used as triangles without a copy.
class Triangles {
 public:
  /// Takes n triangles of three vertices each. Throws what doubles_of throws, and Rejected for another shape.
  explicit Triangles(pybind11::handle rows);

  [[nodiscard]] std::span<const Triangle> all() const { return all_; }

 private:
  Doubles rows_;
  std::span<const Triangle> all_;
};

/// Returns a copy, n x 3 x 3.
[[nodiscard]] Doubles array_of(std::span<const Triangle> triangles);

}  // namespace touchstone::python
