// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/studies/stability/axis.h"
#include "experiments/studies/stability/environment.h"
#include "experiments/studies/stability/stands.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::stability {

/// A polygon, and where the centres of its balls stand.
struct Placed {
  Polygon polygon;
  std::vector<Stand> stands;
};

/// A polygon under stress.
struct Scene {
  std::string id;                     ///< names axis, level, seed and sample: all that is needed to draw it again
  Placed asked;                       ///< what methods are asked about
  std::optional<Placed> meant;        ///< of ChainMotion and PoseMotion: what was moved, stand by stand
  FloatingPointMode mode;             ///< in which methods prepare and answer
  std::vector<std::size_t> critical;  ///< vertices at which the stress is
};

/// Sample `index` of a level of an axis, a function of (axis, level, seed, index) alone; Rounding and Flush have the
/// same scenes at each level. The polygon is accepted by `exact::validate`, and its stress as measured (measure.h) is
/// within a factor of 2 of the level, where the level is a ratio, an angle or a distance; exactly as said where it is a
/// count. Nothing where no such polygon was found.
///
/// Polygons that oblique planes and roundings would break or blur stand axis-parallel, or about zero, where doubles are
/// dense; others stand as they come. Requires rounding to nearest. Cost: that of exact::validate, and 5 ns a rotation
/// and vertex.
[[nodiscard]] std::optional<Scene> draw_scene(Axis axis, std::size_t level, std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone::stability
