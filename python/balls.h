// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/shapes/ball.h"
#include "python/doubles.h"

namespace touchstone::python {

/// Rows of x, y, z, r, used as balls without a copy.
class Balls {
 public:
  /// Takes one ball (an array of 4) or many (n x 4). Throws what doubles_of throws, and Rejected, which names the row,
  /// for an invalid ball.
  explicit Balls(pybind11::handle rows);

  [[nodiscard]] bool single() const { return rows_.ndim() == 1; }
  [[nodiscard]] std::span<const Ball> all() const { return all_; }

 private:
  Doubles rows_;
  std::span<const Ball> all_;
};

}  // namespace touchstone::python
