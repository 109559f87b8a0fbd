// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/triangle_set.h"

/// What `filtered` is compared with, besides `fast`. All use AVX2 where the machine has it.
namespace touchstone::bench {

/// The formulas of `fast::contact` over triangles as structure of arrays, in loops that compilers vectorise: the
/// yardstick for a prepared set.
template <class Real>
class FastBatch {
 public:
  explicit FastBatch(std::span<const Triangle> triangles);
  /// Writes to touches[i] whether the ball touches triangle i; wrong if the input is within rounding error of contact.
  void contact(const Ball& ball, std::span<bool> touches) const;

 private:
  std::array<std::vector<Real>, 9> coordinates_;  ///< x, y, z of the first vertices, then of the others
};

/// `filtered::contact` of a set without its floats: groups that the ball misses or holds as a whole are decided as
/// there, and every other triangle is asked about alone.
void set_contact_without_floats(const Ball& ball, const filtered::TriangleSet& set, std::span<bool> touches);

/// `fast` with the frame, the edges and the hierarchy of `filtered`, in plain doubles without error bounds: what
/// certainty costs when both look at the same edges. Wrong if the input is within rounding error of contact.
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

/// The functions above, compiled for one target.
struct Yardsticks {
  void (*set_contact)(const Ball& ball, const filtered::TriangleSet& set, std::span<bool> touches);
  bool (*tree_contact)(const Ball& ball, const filtered::PreparedPolygon& polygon);
};

[[nodiscard]] Yardsticks baseline_yardsticks();
[[nodiscard]] Yardsticks avx2_yardsticks();

}  // namespace detail

}  // namespace touchstone::bench
