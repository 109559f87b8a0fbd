// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/contact/first_contact.h"
#include "robust/filtered/detail/polygon/newell_plane.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "robust/filtered/detail/triangle/ball_triangle_view.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/triangle_set.h"

namespace touchstone::filtered::detail {

/// The functions that are compiled once per instruction set, for one way of counting stages.
template <class Counts>
struct KernelTable {
  using Parts = PreparedPolygon::Parts;
  bool (*triangle_contact)(BallTriangleView, Counts&);
  /// For a ball of radius 0: the feature that contains the closest point; its distance. For any ball: the closest
  /// point, and the depth unless the pointer is null.
  Feature (*triangle_nearest)(BallTriangleView, Counts&);
  double (*triangle_distance)(BallTriangleView, const Feature&, Counts&);
  void (*triangle_closest)(BallTriangleView, ClosestPoint&, double* depth, Counts&);
  bool (*triangle_motion_contact)(MotionTriangleView, Counts&);
  void (*triangle_first_contact)(MotionTriangleView, FirstContact&, Counts&);
  void (*set_contact)(const Ball&, const TriangleSet::Parts&, std::span<bool>, Counts&);
  bool (*set_any_contact)(const Ball&, const TriangleSet::Parts&, Counts&);
  std::vector<std::size_t> (*set_triangles_hit)(const Ball&, const TriangleSet::Parts&, Counts&);
  bool (*contact)(const Ball&, const Parts&, Counts&);
  Relation (*relation)(const Ball&, const Parts&, Counts&);
  PlaneSide (*plane_side)(const Ball&, const Parts&, Counts&);
  PointLocation (*foot)(const Ball&, const Parts&, Counts&);
  std::vector<std::size_t> (*edges_hit)(const Ball&, const Parts&, Counts&);
  Answer (*answer)(const Ball&, const Parts&, Counts&);
  bool (*motion_contact)(const Motion&, const Parts&, Counts&);
  void (*first_contact)(const Motion&, const Parts&, FirstContact&, Counts&);
};

/// All kernels for one instruction set.
struct Kernels {
  KernelTable<NoCounts> plain;
  KernelTable<StageCounts> counted;
  void (*balls_contact)(std::span<const Ball>, const PreparedPolygon::Parts&, std::span<bool>);
  void (*triangles_contact)(const Ball&, std::span<const Triangle>, std::span<bool>);
  void (*motions_contact)(std::span<const Motion>, const PreparedPolygon::Parts&, std::span<bool>);
  void (*motion_triangles_contact)(const Motion&, std::span<const Triangle>, std::span<bool>);
  /// Requires a feature that the first stage has found to be touched first, and round to nearest.
  std::optional<FirstContact> (*triangle_first_contact_with)(MotionTriangleView, const Feature&);
  NewellSums (*newell_sums)(const ScaledVertex*, std::size_t);
};

/// Returns the centre of a ball, followed by its radius.
[[nodiscard]] __attribute__((always_inline)) inline const double* numbers_of(const Ball& ball) {
  static_assert(sizeof(Ball) == 4 * sizeof(double), "a ball is four doubles in a row");
  return reinterpret_cast<const double*>(&ball);
}

/// Returns a view of a ball and a triangle.
[[nodiscard]] __attribute__((always_inline)) inline BallTriangleView view_of(const Ball& ball,
                                                                             const Triangle& triangle) {
  static_assert(sizeof(Triangle) == 9 * sizeof(double), "a triangle is nine doubles in a row");
  return {reinterpret_cast<const double(*)[3]>(&triangle), numbers_of(ball)};
}

/// The kernels for any machine, and those for x86-64 with AVX2 and FMA.
[[nodiscard]] const Kernels& baseline_kernels();
[[nodiscard]] const Kernels& avx2_kernels();

/// Selects the kernels for this machine and stores the choice. Throws what expect_sound_arithmetic throws.
[[nodiscard]] const Kernels& find_fastest_kernels();
extern std::atomic<const Kernels*> found_kernels;  ///< null until they are selected

/// Returns the fastest kernels that this machine can run. All kernels return the same answers.
[[nodiscard]] inline const Kernels& kernels() {
  // A local static would add 2 % to a query of 25 ns.
  const Kernels* const found = found_kernels.load(std::memory_order_relaxed);
  return found != nullptr ? *found : find_fastest_kernels();
}

/// Returns the closest point, computed by one set of kernels.
template <class Counts>
[[nodiscard]] ClosestPoint closest(const KernelTable<Counts>& table, const Eigen::Vector3d& center,
                                   const Triangle& triangle, Counts& counts) {
  const Ball point_ball{center, 0};
  ClosestPoint point{};
  table.triangle_closest(view_of(point_ball, triangle), point, nullptr, counts);
  return point;
}

}  // namespace touchstone::filtered::detail
