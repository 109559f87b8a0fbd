// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/shapes/ball.h"
#include "robust/filtered/filtered.h"

namespace touchstone::bench {

/// `fast` with the frame, the edges and the hierarchy of `filtered`, in plain doubles without error bounds: what
/// certainty costs when both look at the same edges. Uses AVX2 where the machine has it. Wrong if the input is within
/// rounding error of contact.
class FastTree {
 public:
  explicit FastTree(const Polygon& polygon) : prepared_(polygon) { prepared_.complete(); }

 private:
  friend bool contact(const Ball& ball, const FastTree& polygon);
  filtered::PreparedPolygon prepared_;
};

/// Returns whether the ball touches the polygon. Requires a ball that is no farther from it than 2^60 of its sizes.
[[nodiscard]] bool contact(const Ball& ball, const FastTree& polygon);

namespace detail {
[[nodiscard]] bool baseline_tree_contact(const Ball& ball, const filtered::PreparedPolygon& polygon);
[[nodiscard]] bool avx2_tree_contact(const Ball& ball, const filtered::PreparedPolygon& polygon);
}  // namespace detail

}  // namespace touchstone::bench
