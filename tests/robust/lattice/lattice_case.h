// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "tests/robust/lattice/lattice_loops.h"

namespace touchstone::lattice_tests {

/// Planes into which lattice loops are put.
enum class PlaneKind {
  Upright,  ///< parallel to two coordinate axes
  Tilted,   ///< of integer points, parallel to none; skew, too, and with ties of the dropped axis
  Warped,   ///< integer points off their plane, onto which they are lifted as integers
  Rounded,  ///< an isometry that is not representable, every coordinate rounded: nothing is a tie any more
};
inline constexpr PlaneKind kAllPlanes[] = {PlaneKind::Upright, PlaneKind::Tilted, PlaneKind::Warped,
                                           PlaneKind::Rounded};
[[nodiscard]] std::string_view name(PlaneKind kind);

/// Some number made of two: the same on every machine.
[[nodiscard]] std::uint64_t mixed(std::uint64_t number, std::uint64_t subject);

/// A radius and what is true about the ball that has it.
struct Radius {
  double value;
  Relation relation;
};

/// The questions about one centre: where its foot is, and the three doubles around its distance.
struct Questions {
  Eigen::Vector3d center;
  PointLocation foot;
  std::vector<Radius> radii;
};

/// Lattice loops in space.
class LatticeCase {
 public:
  /// Orientation, first vertices, axes and offsets vary with `variation`. Vertices lie at the even points of a finer
  /// lattice, so that halves of the lattice are points of it.
  LatticeCase(const std::vector<LatticeLoop>& loops, PlaneKind kind, std::uint64_t variation);

  [[nodiscard]] const Polygon& polygon() const { return *polygon_; }

  /// The questions about a centre whose foot is the point of the finer lattice, 0, 1 or 2 steps above the plane. The
  /// truth is computed in integers from the contract alone; of Rounded loops `exact` tells it.
  [[nodiscard]] Questions questions(const LatticePoint& foot, int steps) const;

 private:
  using Vector = std::array<std::int64_t, 3>;
  struct Squared;

  void put_into_doubles(std::uint64_t variation);
  void put_into_integers(PlaneKind kind, std::uint64_t variation);
  void lift();
  [[nodiscard]] Squared squared_distance(const Vector& center, PointLocation place, int steps) const;
  [[nodiscard]] Vector on_plane(const LatticePoint& point) const;

  std::vector<LatticeLoop> loops_;  // finer
  bool integers_;
  std::optional<Polygon> polygon_;
  Vector origin_{}, along_x_{}, along_y_{};    // of the finer lattice, before the lift
  std::vector<std::vector<Vector>> vertices_;  // lifted
  Vector normal_{};                            // without common factor
  Eigen::Vector3d rounded_origin_, rounded_x_, rounded_y_;
};

}  // namespace touchstone::lattice_tests
