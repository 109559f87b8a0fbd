// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "experiments/workloads/lattice/triangle_queries.h"

// CGAL's kernels on the same question, each in its own file: they take long to compile. Source: [cgal2022].
namespace touchstone::bench::cgal {

/// Computes squared_distance(centre, triangle) <= r^2 in doubles.
[[nodiscard]] bool cartesian_contact(const Ball& ball, const Triangle& triangle);
/// Uses exact predicates: a vertex inside the sphere or do_intersect(sphere, triangle). Not exact for a given radius,
/// because the kernel's sphere stores a rounded r^2.
[[nodiscard]] bool epick_contact(const Ball& ball, const Triangle& triangle);
/// Computes squared_distance(centre, triangle) <= r^2 in exact numbers, converted from the doubles in each call.
[[nodiscard]] bool epeck_contact(const Ball& ball, const Triangle& triangle);

/// Computes the same from kernel objects that were made before.
class EpeckQueries {
 public:
  EpeckQueries();
  EpeckQueries(EpeckQueries&&) noexcept;
  EpeckQueries& operator=(EpeckQueries&&) noexcept;
  ~EpeckQueries();

  /// Makes the objects again, since exact numbers cache earlier results.
  void make(std::span<const workloads::TriangleQuery> queries);
  [[nodiscard]] bool contact(std::size_t i) const;

 private:
  struct Objects;
  std::unique_ptr<Objects> objects_;
};

}  // namespace touchstone::bench::cgal
