// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "robust/scene/detail/asked_triangles.h"
#include "robust/scene/detail/ball_walk.h"
#include "robust/scene/detail/walks.h"

namespace touchstone::scene {
inline namespace TOUCHSTONE_TARGET {

/// Returns whether the ball touches the triangle at a place.
template <class Triangles>
TOUCHSTONE_INLINE bool touches(const Triangles& triangles, std::uint32_t place, NoTally) {
  return triangles.touches(place);
}
template <class Triangles>
bool touches(const Triangles& triangles, std::uint32_t place, Tally& tally) {
  return touches(triangles.ball(), triangles.triangle(place), tally);
}

TOUCHSTONE_INLINE bool touches(const Ball& ball, const filtered::PreparedPolygon& polygon, NoTally) {
  return filtered::contact(ball, polygon);
}

/// Adds a face to those that are touched. The first makes room for more.
TOUCHSTONE_INLINE void add(std::vector<FaceId>& faces, FaceId face) {
  constexpr std::size_t kFew = 16;
  if (faces.capacity() == 0) faces.reserve(kFew);
  faces.push_back(face);
}

/// For polygons, which lie where they were prepared.
inline constexpr auto kFetchNothing = [](std::uint32_t, std::uint32_t) {};
/// Returns what fetches triangles from memory, by their first place and their number.
inline auto prefetch_of(const std::vector<Triangle>& triangles) {
  return [&triangles](std::uint32_t first, std::uint32_t count) { prefetch(&triangles[first], count); };
}

/// Returns whether this face settles the query, so that the walk can stop.
template <class Asked, class Face>
TOUCHSTONE_INLINE bool ends(const Asked& asked, const Face& face, NoTally tally) {
  return touches(asked, face, tally);
}

/// Calls f(triangles) with the triangles of the set, as the ball asks about them.
template <class F>
TOUCHSTONE_INLINE auto with_triangles(const TriangleSet& set, const Ball& ball, const F& f) {
  return set.frame ? f(TrianglesInOwnFrame(set, ball)) : f(StandingTriangles(set, ball));
}

template <class T>
bool touches_triangle(const Ball& ball, const TriangleSet& set, T& tally) {
  tally.ask(set.size(), set.edge_count());
  const BoxTree& tree = set.placed->tree;
  return with_triangles(set, ball, [&](const auto& triangles) {
    return walk<false>(
        tree, CullingBall(triangles.culling(), tree),
        [&](std::uint32_t place) { return ends(triangles, place, tally); }, prefetch_of(set.placed->triangles));
  });
}

template <class T>
bool touches_polygon(const Ball& ball, const PolygonSet& set, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const CullingBall culling_ball(ball, set.tree);
  return walk<false>(
      set.tree, culling_ball,
      [&](std::uint32_t place) { return ends(ball, set.prepared[set.tree.order()[place]], tally); }, kFetchNothing);
}

template <class T>
void touched_triangles(const Ball& ball, const TriangleSet& set, FaceId first, std::vector<FaceId>& faces, T& tally) {
  tally.ask(set.size(), set.edge_count());
  const BoxTree& tree = set.placed->tree;
  with_triangles(set, ball, [&](const auto& triangles) {
    walk<false>(
        tree, CullingBall(triangles.culling(), tree),
        [&](std::uint32_t place) {
          if (touches(triangles, place, tally)) add(faces, {first.object, first.face + tree.order()[place]});
          return false;
        },
        prefetch_of(set.placed->triangles));
  });
}

template <class T>
void touched_polygons(const Ball& ball, const PolygonSet& set, FaceId first, std::vector<FaceId>& faces, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  const CullingBall culling_ball(ball, set.tree);
  walk<false>(
      set.tree, culling_ball,
      [&](std::uint32_t place) {
        const std::uint32_t number = set.tree.order()[place];
        if (touches(ball, set.prepared[number], tally)) add(faces, {first.object, first.face + number});
        return false;
      },
      kFetchNothing);
}

/// Returns whether the ball may touch the triangle at a place. Walks that count ask exactly.
template <class Triangles>
TOUCHSTONE_INLINE bool may_touch(const Triangles& triangles, std::uint32_t place, NoTally) {
  return triangles.may_touch(place);
}
template <class Triangles>
bool may_touch(const Triangles& triangles, std::uint32_t place, Tally& tally) {
  return touches(triangles, place, tally);
}

// Upper bounds of distances shrink the ball; only triangles that it may still touch at the end are compared exactly.
template <class T>
void nearest_triangle(const TriangleSet& set, NearestSearch& search, T& tally) {
  tally.ask(set.size(), set.edge_count());
  if (set.size() == 0) return;
  const BoxTree& tree = set.placed->tree;
  std::vector<std::uint32_t> met;
  with_triangles(set, search.ball(), [&](auto triangles) {
    const auto shrink = [&](std::uint32_t place) {
      const double bound = triangles.distance_at_most(place);
      if (bound >= search.ball().radius && std::isfinite(bound)) return false;
      if (std::isfinite(bound))
        search.shrink(bound);
      else
        search.shrink(triangles.triangle(place));
      triangles.set_radius(search.ball().radius);
      return true;
    };
    if (!search.has_shrunk()) shrink(0);
    CullingBall culling_ball(triangles.culling(), tree);
    walk<true>(
        tree, culling_ball,
        [&](std::uint32_t place) {
          if (!may_touch(triangles, place, tally)) return false;
          met.push_back(place);
          if (shrink(place)) culling_ball.set_radius(triangles.culling().radius, tree);
          return false;
        },
        prefetch_of(set.placed->triangles));
    for (const std::uint32_t place : met)
      if (triangles.may_touch(place)) search.meet(triangles.triangle(place), tree.order()[place]);
  });
}

template <class T>
void nearest_polygon(const PolygonSet& set, NearestSearch& search, T& tally) {
  tally.ask(set.polygons.size(), set.edge_count());
  if (set.polygons.empty()) return;
  search.expect(set.prepared[0]);
  CullingBall culling_ball(search.ball(), set.tree);
  walk<true>(
      set.tree, culling_ball,
      [&](std::uint32_t place) {
        const std::uint32_t number = set.tree.order()[place];
        if (!touches(search.ball(), set.prepared[number], tally)) return false;
        search.meet(set.prepared[number], number);
        culling_ball.set_radius(search.ball().radius, set.tree);
        return false;
      },
      kFetchNothing);
}

/// The walks of the target that this is compiled for.
template <class T>
inline constexpr Walks<T> kWalks{touches_triangle<T>, touches_polygon<T>,  touched_triangles<T>,
                                 touched_polygons<T>, nearest_triangle<T>, nearest_polygon<T>};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene
