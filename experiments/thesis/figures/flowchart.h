// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "experiments/thesis/figures/outlines.h"

namespace touchstone::figures {

/// The ends of the thesis's flowchart (Fig 4.3).
enum class End {
  InFront,  ///< the ball misses the plane: no collision
  Behind,   ///< on the other side
  Inside,   ///< the foot is inside the polygon: collision
  Edge,     ///< an edge is near enough: collision
  Neither,  ///< no collision
};
inline constexpr std::array kEnds{End::InFront, End::Behind, End::Inside, End::Edge, End::Neither};
[[nodiscard]] std::string_view to_string(End end);
[[nodiscard]] constexpr bool is_hit(End end) { return end == End::Inside || end == End::Edge; }

/// Numbers of balls by the end of a method and the end of the exact tests.
struct Ends {
  std::array<std::array<std::uint64_t, kEnds.size()>, kEnds.size()> counts{};  ///< [the method's][the exact one]

  void add(End method, End exact) { ++counts[static_cast<std::size_t>(method)][static_cast<std::size_t>(exact)]; }
  Ends& operator+=(const Ends& other);
  [[nodiscard]] std::uint64_t samples() const;
  [[nodiscard]] std::uint64_t at(End method) const;
  [[nodiscard]] std::uint64_t exactly_at(End exact) const;
  [[nodiscard]] std::uint64_t elsewhere() const;  ///< balls for which the ends differ
  [[nodiscard]] std::uint64_t true_hits() const;
  [[nodiscard]] std::uint64_t false_hits() const;
  [[nodiscard]] std::uint64_t misses() const;
};

/// The thesis's method in our first reading, its variants, and ours in plain doubles.
inline constexpr std::array<std::string_view, 9> kMethods{"thesis",        "thesis-float",  "thesis-0.9999",
                                                          "thesis-1",      "thesis-signed", "thesis-atan2",
                                                          "thesis-newell", "thesis-closed", "fast"};
/// The radii of the balls, as shares of an outline's largest extent.
inline constexpr std::array kRadii{0.002, 0.01, 0.05, 0.1};

/// The results for one outline and radius.
struct Flowchart {
  const Outline* outline;
  double radius;  ///< as a share of the outline's largest extent
  std::array<Ends, kMethods.size()> methods{};
  std::uint64_t culled = 0;  ///< false hits of `thesis` whose ball misses the box around the outline
};

/// Draws balls of one radius, with feet uniform in the outline's bounding box enlarged by 3 radii, and heights uniform
/// within 1.5 radii of its plane; compares the course of every method with that of exact tests.
///
/// Front is the side that the method calls so: one far ball determines it for each method, and the exact sides are
/// named accordingly. The truth is `filtered`. A function of its arguments; streams keep the random numbers of
/// workloads apart. Cost: about 10 us per ball.
[[nodiscard]] Flowchart measure_flowchart(const Outline& outline, double radius, std::uint64_t balls,
                                          std::uint64_t seed, std::uint64_t stream);

}  // namespace touchstone::figures
