// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

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

namespace detail {
[[nodiscard]] const std::vector<Variant>& baseline_variants();
[[nodiscard]] const std::vector<Variant>& avx2_variants();
}  // namespace detail

}  // namespace touchstone::bench
