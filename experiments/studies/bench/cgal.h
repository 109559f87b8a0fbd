// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "experiments/workloads/lattice/triangle_queries.h"

// CGAL's kernels on the same question, each in its own file: they take long to compile. Source: [cgal2022].
namespace touchstone::bench::cgal {

/// squared_distance(centre, triangle) <= r^2 in doubles.
[[nodiscard]] bool cartesian_contact(const Ball& ball, const Triangle& triangle);
/// By exact predicates: a vertex inside the sphere or do_intersect(sphere, triangle). Not exact for a given radius: the
/// kernel's sphere keeps r^2, rounded.
[[nodiscard]] bool epick_contact(const Ball& ball, const Triangle& triangle);
/// squared_distance(centre, triangle) <= r^2 in exact numbers, made from the doubles within.
[[nodiscard]] bool epeck_contact(const Ball& ball, const Triangle& triangle);

/// The same with the kernel's objects made before.
class EpeckQueries {
 public:
  EpeckQueries();
  EpeckQueries(EpeckQueries&&) noexcept;
  EpeckQueries& operator=(EpeckQueries&&) noexcept;
  ~EpeckQueries();

  /// Makes them anew: exact numbers remember what was once found of them.
  void make(std::span<const workloads::TriangleQuery> queries);
  [[nodiscard]] bool contact(std::size_t i) const;

 private:
  struct Objects;
  std::unique_ptr<Objects> objects_;
};

}  // namespace touchstone::bench::cgal
