// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/triangle_set.h"

namespace touchstone::bench {

/// Another way to decide exactly whether a ball touches a triangle: `filtered` without one of its stages, or with other
/// exact arithmetic behind its first stage. Requires numbers whose products neither overflow nor underflow.
struct Variant {
  std::string_view name;
  bool (*contact)(const Ball& ball, const Triangle& triangle);
};

/// Returns all variants, with AVX2 where the machine has it. The first one is `filtered` itself, in the same frame.
[[nodiscard]] const std::vector<Variant>& variants();

/// The same predicate over CGAL's intervals, then over its exact numbers: CGAL::Filtered_predicate, which writes the
/// filter.
[[nodiscard]] bool generated_filter_contact(const Ball& ball, const Triangle& triangle);

/// `filtered::contact` of a set without its floats: groups that the ball misses or holds as a whole are decided as
/// there, and every other triangle is asked about alone. Uses AVX2 where the machine has it.
void set_contact_without_floats(const Ball& ball, const filtered::TriangleSet& set, std::span<bool> touches);

namespace detail {
using SetContact = void (*)(const Ball& ball, const filtered::TriangleSet& set, std::span<bool> touches);
[[nodiscard]] const std::vector<Variant>& baseline_variants();
[[nodiscard]] const std::vector<Variant>& avx2_variants();
[[nodiscard]] SetContact baseline_set_contact();
[[nodiscard]] SetContact avx2_set_contact();
}  // namespace detail

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
