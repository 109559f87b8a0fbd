// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::bench {

/// The formulas of `fast::contact` over triangles as structure of arrays, in loops that compilers vectorise: the
/// yardstick for a prepared set. Uses AVX2 where the machine has it.
template <class Real>
class FastBatch {
 public:
  explicit FastBatch(std::span<const Triangle> triangles);
  /// Writes to touches[i] whether the ball touches triangle i; wrong if the input is within rounding error of contact.
  void contact(const Ball& ball, std::span<bool> touches) const;

 private:
  std::array<std::vector<Real>, 9> coordinates_;  ///< x, y, z of the first vertices, then of the others
};

}  // namespace touchstone::bench
