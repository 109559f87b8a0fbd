// SPDX-License-Identifier: GPL-3.0-or-later
// Every engine that this machine can run finds the same faces.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "geometry/detail/floating_point_state.h"
#include "robust/scene/detail/walks.h"
#include "tests/robust/scene/brute_force.h"
#include "tests/robust/support/printing.h"

namespace touchstone::scene_tests {
namespace {

using scene::FaceId;

struct Found {
  bool any, any_on_way;
  std::vector<FaceId> all, all_on_way;
  std::optional<scene::NearestFace> nearest;
  std::optional<scene::FirstFace> first;
  std::vector<std::optional<int>> crossings;  ///< of the rays along every axis, either way
};

/// Asks about contact; tells whether there is any, and adds the faces.
template <class Query>
bool ask(const scene::detail::ContactWalks<Query>& walks, const Query& query,
         const scene::detail::TriangleSet& triangles, const scene::detail::PolygonSet& polygons,
         std::vector<FaceId>& all) {
  const bool any = walks.touches_triangle(query, triangles) || walks.touches_polygon(query, polygons);
  walks.touched_triangles(query, triangles, {0, 0}, all);
  walks.touched_polygons(query, polygons, {1, 0}, all);
  std::sort(all.begin(), all.end());
  return any;
}

Found ask(const scene::detail::Walks& walks, const Motion& motion, const scene::detail::TriangleSet& triangles,
          const scene::detail::PolygonSet& polygons) {
  const FloatingPointState nearest_mode;
  Found found;
  const Ball& ball = motion.ball;
  found.any = ask(walks.ball, ball, triangles, polygons, found.all);
  found.any_on_way = ask(walks.motion, motion, triangles, polygons, found.all_on_way);
  scene::detail::FirstContactSearch first(motion);
  first.enter({0, 0});
  walks.first_triangle(triangles, first);
  first.enter({1, 0});
  walks.first_polygon(polygons, first);
  found.first = first.first();
  scene::detail::NearestSearch search(ball);
  search.enter({0, 0});
  walks.nearest_triangle(triangles, search);
  search.enter({1, 0});
  walks.nearest_polygon(polygons, search);
  found.nearest = search.nearest();
  for (const int axis : {0, 1, 2})
    for (const bool up : {false, true})
      found.crossings.push_back(walks.crossings(triangles, {{ball.center, 0}, axis, up}));
  return found;
}

void expect_equal(const Found& found, const Found& expected, const std::string& what) {
  EXPECT_EQ(found.any, expected.any) << what;
  EXPECT_EQ(found.all, expected.all) << what;
  EXPECT_EQ(found.any_on_way, expected.any_on_way) << what;
  EXPECT_EQ(found.all_on_way, expected.all_on_way) << what;
  EXPECT_EQ(found.first, expected.first) << what;
  EXPECT_EQ(found.nearest, expected.nearest) << what;
  EXPECT_EQ(found.crossings, expected.crossings) << what;
}

/// Asks every engine.
void expect_the_same_faces(const Motion& motion, const scene::detail::TriangleSet& triangles,
                           const scene::detail::PolygonSet& polygons, const std::string& what) {
  const Found expected = ask(scene::detail::baseline_walks(), motion, triangles, polygons);
  EXPECT_EQ(expected.any, !expected.all.empty()) << what;
  EXPECT_EQ(expected.any_on_way, !expected.all_on_way.empty()) << what;
  EXPECT_EQ(expected.first.has_value(), expected.any_on_way) << what;
  expect_equal(ask(scene::detail::fastest_walks(), motion, triangles, polygons), expected, what);
}

TEST(SceneEngines, FindTheSameFaces) {
  for (const Kind kind : all_kinds())
    for (std::uint64_t index = 0; index < TOUCHSTONE_SAMPLES / 10; ++index) {
      const auto objects = draw_objects(kind, 2027, index);
      const scene::detail::TriangleSet triangles(objects.front().triangles);
      const scene::detail::PolygonSet polygons(objects.front().polygons);
      for (std::uint64_t i = 0; i < 10; ++i)
        expect_the_same_faces(draw_motion(all_polygons(objects), 2027, 1000 * index + i), triangles, polygons,
                              name(kind) + ", scene " + std::to_string(index) + ", motion " + std::to_string(i));
    }
}

// In their own frame where it can hold them; motions are about the posed faces.
TEST(SceneEngines, FindTheSameFacesUnderPoses) {
  std::size_t held = 0;
  const scene::detail::PolygonSet none(std::vector<Polygon>{});
  for (const Kind kind : {Kind::Soup, Kind::Coplanar, Kind::Needles, Kind::Duplicates, Kind::FarAway})
    for (std::uint64_t index = 0; index < TOUCHSTONE_SAMPLES / 5; ++index) {
      const scene::Faces model{draw_objects(kind, 2027, index).front().triangles, {}};
      const Pose pose = draw_pose({model}, 2027, index);
      std::optional<scene::detail::TriangleSet> triangles;
      scene::Faces there;
      try {
        const FloatingPointState nearest_mode;
        triangles.emplace(scene::detail::TriangleSet(model.triangles), pose);
        there = posed(pose, model);
      } catch (const scene::detail::FaceRejected&) {
        continue;
      }
      held += triangles->frame.has_value();
      for (std::uint64_t i = 0; i < 10; ++i)
        expect_the_same_faces(draw_motion(all_polygons({there}), 2027, 1000 * index + i), *triangles, none,
                              name(kind) + ", scene " + std::to_string(index) + ", motion " + std::to_string(i));
    }
  EXPECT_GT(held, TOUCHSTONE_SAMPLES / 5U);
}

}  // namespace
}  // namespace touchstone::scene_tests
