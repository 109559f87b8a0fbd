// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/triangle_contact.h"
#include "robust/scene/detail/ball_walk.h"
#include "robust/scene/detail/walks.h"

namespace touchstone::scene {
inline namespace TOUCHSTONE_TARGET {

/// Returns whether the ball certainly misses the triangle's box along some axis. Culls most triangles of a leaf.
///
/// Compares the differences from the vertices one by one: if a difference is at most r in magnitude, so is its rounded
/// value. Requires round to nearest, without flush-to-zero.
TOUCHSTONE_INLINE bool misses_box(const Ball& ball, const Triangle& triangle) {
  const filtered::Pack center = filtered::load_three(ball.center.data());
  // A radius of -0 becomes +0: -0 - 0 and -0 + -0 have the sign of a miss.
  const filtered::Pack radius = filtered::all_lanes(ball.radius + 0.0);
  const filtered::Pack a = center - filtered::load_three(triangle.a.data());
  const filtered::Pack b = center - filtered::load_three(triangle.b.data());
  const filtered::Pack c = center - filtered::load_three(triangle.c.data());
  const filtered::Pack below = maximum(a, maximum(b, c)) + radius, above = radius - minimum(a, minimum(b, c));
  return (negative_lanes(below | above) & 0b111) != 0;
}

TOUCHSTONE_INLINE bool touches(const Ball& ball, const Triangle& triangle, NoTally) {
  if (misses_box(ball, triangle)) return false;
  filtered::NoCounts counts;
  return filtered::contact(filtered::view_of(ball, triangle), counts);
}

TOUCHSTONE_INLINE bool touches(const Ball& ball, const filtered::PreparedPolygon& polygon, NoTally) {
  return filtered::contact(ball, polygon);
}

/// Returns whether this face settles the query, so that the walk can stop.
template <class Face>
TOUCHSTONE_INLINE bool ends(const Ball& ball, const Face& face, NoTally tally) {
  return touches(ball, face, tally);
}

template <class T>
bool touches_triangle(const Ball& ball, const TriangleSet& set, T& tally) {
  tally.ask(set.triangles.size(), set.edge_count());
  const CullingBall culling_ball(ball, set.tree);
  return walk<false>(set.tree, culling_ball,
                     [&](std::uint32_t place) { return ends(ball, set.triangles[place], tally); });
}

template <class T>
bool touches_polygon(const Ball& ball, const PolygonSet& set, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const CullingBall culling_ball(ball, set.tree);
  return walk<false>(set.tree, culling_ball,
                     [&](std::uint32_t place) { return ends(ball, set.prepared[set.tree.order()[place]], tally); });
}

template <class T>
void touched_triangles(const Ball& ball, const TriangleSet& set, FaceId first, std::vector<FaceId>& faces, T& tally) {
  tally.ask(set.triangles.size(), set.edge_count());
  const CullingBall culling_ball(ball, set.tree);
  walk<false>(set.tree, culling_ball, [&](std::uint32_t place) {
    if (touches(ball, set.triangles[place], tally))
      faces.push_back({first.object, first.face + set.tree.order()[place]});
    return false;
  });
}

template <class T>
void touched_polygons(const Ball& ball, const PolygonSet& set, FaceId first, std::vector<FaceId>& faces, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const CullingBall culling_ball(ball, set.tree);
  walk<false>(set.tree, culling_ball, [&](std::uint32_t place) {
    const std::uint32_t number = set.tree.order()[place];
    if (touches(ball, set.prepared[number], tally)) faces.push_back({first.object, first.face + number});
    return false;
  });
}

template <class T>
void nearest_triangle(const TriangleSet& set, NearestSearch& search, T& tally) {
  tally.ask(set.triangles.size(), set.edge_count());
  if (set.triangles.empty()) return;
  search.expect(set.triangles.front());
  CullingBall culling_ball(search.ball(), set.tree);
  walk<true>(set.tree, culling_ball, [&](std::uint32_t place) {
    if (!touches(search.ball(), set.triangles[place], tally)) return false;
    search.meet(set.triangles[place], set.tree.order()[place]);
    culling_ball.set_radius(search.ball().radius, set.tree);
    return false;
  });
}

template <class T>
void nearest_polygon(const PolygonSet& set, NearestSearch& search, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  if (set.polygons.empty()) return;
  search.expect(set.prepared[0]);
  CullingBall culling_ball(search.ball(), set.tree);
  walk<true>(set.tree, culling_ball, [&](std::uint32_t place) {
    const std::uint32_t number = set.tree.order()[place];
    if (!touches(search.ball(), set.prepared[number], tally)) return false;
    search.meet(set.prepared[number], number);
    culling_ball.set_radius(search.ball().radius, set.tree);
    return false;
  });
}

/// The walks of the target that this is compiled for.
template <class T>
inline constexpr Walks<T> kWalks{touches_triangle<T>, touches_polygon<T>,  touched_triangles<T>,
                                 touched_polygons<T>, nearest_triangle<T>, nearest_polygon<T>};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene
