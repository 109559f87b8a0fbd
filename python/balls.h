// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/shapes/ball.h"
#include "python/doubles.h"

namespace touchstone::python {

/// Rows of x, y, z, r, taken as balls where they lie.
class Balls {
 public:
  /// One ball (an array of 4) or many (n x 4). Throws as doubles_of does, and Rejected, which names the row, for what
  /// is no ball.
  explicit Balls(pybind11::handle rows);

  [[nodiscard]] bool single() const { return rows_.ndim() == 1; }
  [[nodiscard]] std::span<const Ball> all() const { return all_; }

 private:
  Doubles rows_;
  std::span<const Ball> all_;
};

}  // namespace touchstone::python
