// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/engine.h"
#include "robust/filtered/triangle_contact.h"
#include "robust/scene/ball_walk.h"
#include "robust/scene/engine.h"

namespace touchstone::scene {
inline namespace TOUCHSTONE_TARGET {

TOUCHSTONE_INLINE bool touches(const Ball& ball, const Triangle& triangle) {
  filtered::NoCounts counts;
  return filtered::contact(filtered::question(ball, triangle), counts);
}

inline bool touches_triangle(const Ball& ball, const TriangleSet& set) {
  const Reach reach(ball, set.tree);
  return walk<false>(set.tree, reach, [&](std::uint32_t place) { return touches(ball, set.triangles[place]); });
}

inline bool touches_polygon(const Ball& ball, const PolygonSet& set) {
  const Reach reach(ball, set.tree);
  return walk<false>(set.tree, reach, [&](std::uint32_t place) {
    return filtered::contact(ball, set.prepared[set.tree.order()[place]]);
  });
}

inline void touched_triangles(const Ball& ball, const TriangleSet& set, FaceId first, std::vector<FaceId>& faces) {
  const Reach reach(ball, set.tree);
  walk<false>(set.tree, reach, [&](std::uint32_t place) {
    if (touches(ball, set.triangles[place])) faces.push_back({first.object, first.face + set.tree.order()[place]});
    return false;
  });
}

inline void touched_polygons(const Ball& ball, const PolygonSet& set, FaceId first, std::vector<FaceId>& faces) {
  const Reach reach(ball, set.tree);
  walk<false>(set.tree, reach, [&](std::uint32_t place) {
    const std::uint32_t number = set.tree.order()[place];
    if (filtered::contact(ball, set.prepared[number])) faces.push_back({first.object, first.face + number});
    return false;
  });
}

inline void nearest_triangle(const TriangleSet& set, NearestSearch& search) {
  Reach reach(search.ball(), set.tree);
  walk<true>(set.tree, reach, [&](std::uint32_t place) {
    if (!touches(search.ball(), set.triangles[place])) return false;
    search.meet(set.triangles[place], set.tree.order()[place]);
    reach.set_radius(search.ball().radius, set.tree);
    return false;
  });
}

inline void nearest_polygon(const PolygonSet& set, NearestSearch& search) {
  Reach reach(search.ball(), set.tree);
  walk<true>(set.tree, reach, [&](std::uint32_t place) {
    const std::uint32_t number = set.tree.order()[place];
    if (!filtered::contact(search.ball(), set.prepared[number])) return false;
    search.meet(set.polygons[number], number);
    reach.set_radius(search.ball().radius, set.tree);
    return false;
  });
}

/// The engine of the target that this is compiled for.
inline constexpr Engine kEngine{touches_triangle, touches_polygon,  touched_triangles,
                                touched_polygons, nearest_triangle, nearest_polygon};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene
