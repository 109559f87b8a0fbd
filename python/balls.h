// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/shapes/ball.h"
#include "python/polygon.h"

namespace touchstone::python {

/// Rows of x, y, z, r, taken as balls where they lie.
class Balls {
 public:
  /// One ball (an array of 4) or many (n x 4). Throws Rejected, which names the row, for what is no ball.
  explicit Balls(Doubles rows);

  [[nodiscard]] bool single() const { return rows_.ndim() == 1; }
  [[nodiscard]] std::span<const Ball> all() const { return all_; }

 private:
  Doubles rows_;
  std::span<const Ball> all_;
};

}  // namespace touchstone::python
