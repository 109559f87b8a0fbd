// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "robust/scene/scene.h"

namespace touchstone::scene_tests {

/// Scenes in which culling might lie.
enum class Kind {
  Soup,         ///< random triangles and a few polygons
  Coplanar,     ///< a lattice of triangles in one plane, vertices and edges shared
  Needles,      ///< thin triangles, in rays from one point
  Duplicates,   ///< the same few faces many times
  MixedSizes,   ///< faces of 2^-60 to 2^60 about one place
  HugeNumbers,  ///< coordinates about 1e300
  TinyNumbers,  ///< coordinates about 1e-300, subnormal ones too
  FarAway,      ///< small faces 2^40 sizes from the origin
  OffPlane,     ///< polygons that are off their planes by up to their size
};

[[nodiscard]] const std::vector<Kind>& all_kinds();
[[nodiscard]] std::string name(Kind kind);

/// Objects of faces that `exact::validate` accepts: a function of the arguments. Most kinds have `times` as many faces,
/// the lattice `times` as many along each side.
[[nodiscard]] std::vector<scene::Faces> draw_objects(Kind kind, std::uint64_t seed, std::uint64_t index, int times = 1);

/// A ball near a face: its radius is 0, large, or within a few doubles of the distance to some face.
[[nodiscard]] Ball draw_ball(const std::vector<Polygon>& all, std::uint64_t seed, std::uint64_t index);

/// A motion that has such a ball at its start, at its end or in between, and is as short or as long as may be; or at
/// rest. The centre moves along an edge, along an axis, to a vertex, or anywhere.
[[nodiscard]] Motion draw_motion(const std::vector<Polygon>& all, std::uint64_t seed, std::uint64_t index);

/// All faces as polygons, object by object.
[[nodiscard]] std::vector<Polygon> all_polygons(const std::vector<scene::Faces>& objects);

/// The identity, a translation, a quarter or eighth of a turn, any rotation, or a matrix that is not a rotation.
[[nodiscard]] Pose draw_pose(const std::vector<scene::Faces>& objects, std::uint64_t seed, std::uint64_t index);

/// The faces under a pose. Throws Rejected if one of them becomes invalid.
[[nodiscard]] scene::Faces posed(const Pose& pose, const scene::Faces& model);

}  // namespace touchstone::scene_tests
