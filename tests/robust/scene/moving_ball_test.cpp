// SPDX-License-Identifier: GPL-3.0-or-later
// What scenes answer about moving balls, against brute force over all faces.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "robust/filtered/motion.h"
#include "robust/scene/detail/first_contact_search.h"
#include "tests/robust/scene/brute_force.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/moving.h"

namespace touchstone::scene_tests {
namespace {

using scene::FaceId;
using scene::Faces;
using scene::Scene;

TEST(MovingBallInScene, TouchesExactlyTheFacesOnItsWay) {
  std::uint64_t touching = 0;
  for_each_query(draw_motion, 2 * TOUCHSTONE_SAMPLES,
                 [&](const Subject& subject, const Motion& motion, std::uint64_t number, const std::string& what) {
                   const auto expected = subject.faces.touched(motion);
                   EXPECT_EQ(subject.built.touched(motion), expected) << what;
                   EXPECT_EQ(subject.built.touches(motion), !expected.empty()) << what;
                   if (number % 20 == 3) {
                     EXPECT_EQ(subject.faces.touched_by_exact(motion), expected) << what;
                   }
                   touching += expected.empty() ? 0 : 1;
                 });
  EXPECT_GT(touching, 5U * TOUCHSTONE_SAMPLES);
}

TEST(MovingBallInScene, TouchesTheFirstFaceFirstAndTheLowestOfEquals) {
  std::uint64_t on_way = 0;
  for_each_query(draw_motion, 2 * TOUCHSTONE_SAMPLES,
                 [&](const Subject& subject, const Motion& motion, std::uint64_t number, const std::string& what) {
                   const auto expected = subject.faces.first(motion);
                   EXPECT_EQ(subject.built.first_contact(motion), expected) << what;
                   if (number % 50 == 7) {
                     EXPECT_EQ(subject.faces.first_by_exact(motion), expected) << what;
                   }
                   on_way += expected && expected->contact.kind == FirstContactKind::Way ? 1 : 0;
                 });
  EXPECT_GT(on_way, 2U * TOUCHSTONE_SAMPLES);
}

TEST(MovingBallInScene, ListsTheFacesOnItsWayInTheOrderOfTheirExactTimes) {
  std::uint64_t several = 0;
  for_each_query(
      draw_motion, TOUCHSTONE_SAMPLES,
      [&](const Subject& subject, const Motion& motion, std::uint64_t number, const std::string& what) {
        const auto listed = subject.built.touched_in_order(motion);
        several += listed.size() > 1 ? 1 : 0;
        EXPECT_EQ(listed.empty() ? std::nullopt : std::optional(listed.front()), subject.built.first_contact(motion))
            << what;
        std::vector<FaceId> faces;
        for (std::size_t i = 0; i < listed.size(); ++i) {
          faces.push_back(listed[i].face);
          if (number % 10 == 3) {
            EXPECT_EQ(listed[i].contact, subject.faces.first_by_exact(motion, listed[i].face)) << what;
          }
          if (i == 0) continue;
          const int order = subject.faces.compare_exactly(motion, listed[i - 1].face, listed[i].face);
          EXPECT_TRUE(order < 0 || (order == 0 && listed[i - 1].face < listed[i].face)) << what;
        }
        std::ranges::sort(faces);
        EXPECT_EQ(faces, subject.built.touched(motion)) << what;
      });
  EXPECT_GT(several, TOUCHSTONE_SAMPLES);
}

TEST(MovingBallInScene, ListsEqualTimesByObjectAndFaceAndTellsApartWhatRoundsToOneDouble) {
  const Motion falls({{0.5, 0.5, 8}, 1}, {0.5, 0.5, 0});
  const auto floor = [](double height) { return Triangle{{-2, -2, height}, {4, -2, height}, {0, 8, height}}; };
  Scene scene;
  scene.add("floors", {{floor(0), floor(8), floor(0x1p-60), floor(7), floor(0)}, {}});
  scene.add("below", {{floor(-1), floor(0x1p-60)}, {Polygon({{-2, -2, 7.5}, {4, -2, 7.5}, {0, 8, 7.5}})}});
  std::vector<FaceId> faces;
  const auto listed = scene.touched_in_order(falls);
  for (const scene::FirstFace& each : listed) faces.push_back(each.face);
  // At the start first, also where the ball reaches a face less far; then upwards to later times.
  EXPECT_EQ(faces, (std::vector<FaceId>{{0, 1}, {0, 3}, {1, 2}, {0, 2}, {1, 1}, {0, 0}, {0, 4}, {1, 0}}));
  EXPECT_EQ(listed[3].contact.time, listed[5].contact.time);
  const Motion at_rest(falls.ball, falls.ball.center);
  const auto at_start = scene.touched_in_order(std::vector<Motion>{at_rest, falls}, std::vector<std::uint32_t>{0});
  ASSERT_EQ(at_start[0].size(), 2U);
  EXPECT_EQ(at_start[0][1].face, (FaceId{0, 3}));
  EXPECT_EQ(at_start[1].size(), 5U);
}

TEST(MovingBallInScene, TouchesAtRestWhatTheBallTouches) {
  for_each_query(draw_motion, TOUCHSTONE_SAMPLES / 2,
                 [](const Subject& subject, const Motion& motion, std::uint64_t, const std::string& what) {
                   const Motion at_rest(motion.ball, motion.ball.center);
                   const auto touched = subject.built.touched(motion.ball);
                   EXPECT_EQ(subject.built.touched(at_rest), touched) << what;
                   EXPECT_EQ(subject.built.touches(at_rest), !touched.empty()) << what;
                   const auto first = subject.built.first_contact(at_rest);
                   ASSERT_EQ(first.has_value(), !touched.empty()) << what;
                   if (!first) return;
                   EXPECT_EQ(first->face, touched.front()) << what;
                   EXPECT_EQ(first->contact.kind, FirstContactKind::Start) << what;
                 });
}

TEST(MovingBallInScene, TouchesTheSameFacesOnItsWayBack) {
  for_each_query(draw_motion, TOUCHSTONE_SAMPLES / 2,
                 [](const Subject& subject, const Motion& motion, std::uint64_t, const std::string& what) {
                   const Motion back({motion.to, motion.ball.radius}, motion.ball.center);
                   EXPECT_EQ(subject.built.touched(back), subject.built.touched(motion)) << what;
                 });
}

TEST(MovingBallInScene, AsksChosenObjectsOnly) {
  for_each_query(draw_motion, TOUCHSTONE_SAMPLES / 5,
                 [](const Subject& subject, const Motion& motion, std::uint64_t, const std::string& what) {
                   const Scene::Objects chosen(std::vector<std::uint32_t>{2, 1, 2}), none(std::vector<std::uint32_t>{});
                   std::vector<FaceId> expected;
                   for (const FaceId& id : subject.faces.touched(motion))
                     if (id.object != 0) expected.push_back(id);
                   EXPECT_EQ(subject.built.touched(motion, chosen), expected) << what;
                   EXPECT_EQ(subject.built.touches(motion, chosen), !expected.empty()) << what;
                   const auto first = subject.built.first_contact(motion, chosen);
                   EXPECT_EQ(first.has_value(), !expected.empty()) << what;
                   EXPECT_TRUE(!first || first->face.object != 0) << what;
                   EXPECT_FALSE(subject.built.touches(motion, none)) << what;
                   EXPECT_FALSE(subject.built.first_contact(motion, none)) << what;
                 });
  const Scene empty;
  const Motion motion({{0, 0, 0}, 1}, {1, 0, 0});
  EXPECT_FALSE(empty.touches(motion) || empty.first_contact(motion) || !empty.touched(motion).empty());
  EXPECT_THROW((void)empty.first_contact(motion, std::vector<std::uint32_t>{0}), std::out_of_range);
}

TEST(MovingBallInScene, AnswersBatchesAsSingleQuestions) {
  for (const Kind kind : all_kinds()) {
    const Subject subject(draw_objects(kind, 2026, 7), name(kind));
    std::vector<Motion> motions;
    for (std::uint64_t i = 0; i < 300; ++i) motions.push_back(draw_motion(subject.faces.polygons(), 2026, i));
    const std::unique_ptr<bool[]> touches(new bool[motions.size()]);
    subject.built.touches(std::span<const Motion>(motions), {touches.get(), motions.size()});
    const auto touched = subject.built.touched(motions);
    const auto first = subject.built.first_contact(motions);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      EXPECT_EQ(touches[i], subject.built.touches(motions[i])) << subject.what << ", motion " << i;
      EXPECT_EQ(touched[i], subject.built.touched(motions[i])) << subject.what << ", motion " << i;
      EXPECT_EQ(first[i], subject.built.first_contact(motions[i])) << subject.what << ", motion " << i;
    }
    EXPECT_THROW(subject.built.touches(std::span<const Motion>(motions), {touches.get(), 1}), std::invalid_argument);
  }
}

TEST(MovingBallInScene, AnswersBatchesInLargeScenesInTheGivenOrder) {
  Faces faces;
  for (int i = 0; i < 1 << 16; ++i) {
    const Eigen::Vector3d corner(i % 256, i / 256, 0);
    faces.triangles.push_back({corner, corner + Eigen::Vector3d::UnitX(), corner + Eigen::Vector3d::UnitY()});
  }
  Scene scene;
  scene.add("grid", std::move(faces));
  std::vector<Motion> motions;
  for (std::uint64_t i = 0; i < 300; ++i) {
    workloads::Random random(2026, i, 31);
    const double x = 256 * random.unit(), y = 256 * random.unit();
    motions.emplace_back(Ball{{x, y, 1}, 0.125}, Eigen::Vector3d(y, x, -1));
  }
  const std::unique_ptr<bool[]> touches(new bool[motions.size()]);
  scene.touches(std::span<const Motion>(motions), {touches.get(), motions.size()});
  const auto first = scene.first_contact(motions);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    EXPECT_EQ(touches[i], scene.touches(motions[i])) << "motion " << i;
    EXPECT_EQ(first[i], scene.first_contact(motions[i])) << "motion " << i;
  }
}

TEST(MovingBallInScene, AnswersInEveryFloatingPointEnvironmentAndLeavesItAsFound) {
  for_each_query(draw_motion, TOUCHSTONE_SAMPLES / 20,
                 [](const Subject& subject, const Motion& motion, std::uint64_t, const std::string& what) {
                   const auto expected = subject.built.touched(motion);
                   const auto expected_first = subject.built.first_contact(motion);
                   for (const contact_tests::State& state : contact_tests::kStates) {
                     const contact_tests::Environment changed(state);
                     const auto touched = subject.built.touched(motion);
                     const auto first = subject.built.first_contact(motion);
                     const bool touches = subject.built.touches(motion);
                     const bool left = changed.left_as_found();
                     EXPECT_EQ(touched, expected) << what << ", " << state;
                     EXPECT_EQ(touches, !expected.empty()) << what << ", " << state;
                     EXPECT_EQ(first, expected_first) << what << ", " << state;
                     EXPECT_TRUE(left) << what << ", " << state;
                   }
                 });
}

// Triangles stay in their own frame where it can hold them; motions are about the posed faces.
TEST(MovingBallInScene, FindsPosedFacesAsIfTheyWereBuiltThere) {
  std::uint64_t posed_scenes = 0, on_way = 0;
  for (const Kind kind : all_kinds())
    for (std::uint64_t index = 0; index < TOUCHSTONE_SAMPLES / 10; ++index) {
      const auto models = draw_objects(kind, 2026, index);
      std::vector<scene::Faces> there;
      Scene moved;
      for (std::uint32_t i = 0; i < models.size(); ++i) {
        const Pose pose = draw_pose({models[i]}, 2026, 10 * index + i);
        try {
          there.push_back(posed(pose, models[i]));
          moved.add(std::to_string(i), models[i], pose);
        } catch (const Rejected&) {
          there.push_back(models[i]);
          moved.add(std::to_string(i), models[i]);
        }
      }
      ++posed_scenes;
      const Subject subject(there, name(kind) + ", scene " + std::to_string(index));
      for (std::uint64_t i = 0; i < 20; ++i) {
        const Motion motion = draw_motion(subject.faces.polygons(), 2026, 100 * index + i);
        const std::string what = subject.what + ", motion " + std::to_string(i);
        const auto expected = subject.faces.first(motion);
        EXPECT_EQ(moved.first_contact(motion), expected) << what;
        const auto touched = subject.faces.touched(motion);
        EXPECT_EQ(moved.touched(motion), touched) << what;
        EXPECT_EQ(moved.touches(motion), !touched.empty()) << what;
        on_way += expected && expected->contact.kind == FirstContactKind::Way ? 1 : 0;
      }
    }
  EXPECT_GT(on_way, posed_scenes);
}

const Motion kFalls({{0.5, 0.5, 8}, 1}, {0.5, 0.5, 0});  // reaches height 0 with its lowest point at time 7/8

Triangle floor_at(double height) { return {{-2, -2, height}, {4, -2, height}, {0, 8, height}}; }

TEST(MovingBallInScene, NamesTheLowestOfFacesTouchedAtOnce) {
  Scene scene;
  scene.add("late", {{floor_at(-1)}, {}});
  scene.add("twice", {{floor_at(-2), floor_at(0), {{4, -2, 0}, {0, 8, 0}, {-2, -2, 0}}}, {}});
  scene.add("as a polygon", {{}, {Polygon({{-2, -2, 0}, {4, -2, 0}, {0, 8, 0}})}});
  const auto first = scene.first_contact(kFalls);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->face, (FaceId{1, 1}));
  EXPECT_EQ(first->contact,
            (FirstContact{FirstContactKind::Way, 0.875, false, {Feature::Kind::Face, 0}, {0.5, 0.5, 0}, {0, 0, 1}}));
  // Without that object the polygon is first, which is as high.
  const auto polygon = scene.first_contact(kFalls, std::vector<std::uint32_t>{0, 2});
  ASSERT_TRUE(polygon);
  EXPECT_EQ(polygon->face, (FaceId{2, 0}));
  EXPECT_EQ(scene.first_contact(kFalls, std::vector<std::uint32_t>{0})->face, (FaceId{0, 0}));
}

// Whichever leaf of the tree comes first, the others follow.
TEST(MovingBallInScene, NamesTheLowestOfManyPolygonsTouchedAtOnce) {
  for (const bool reversed : {false, true}) {
    std::vector<Polygon> floors;
    for (int i = 0; i < 64; ++i) {
      const double x = (reversed ? 63 - i : i) / 64.0;
      floors.emplace_back(Loop{{x - 4, -4, 0}, {x + 4, -4, 0}, {x + 4, 4, 0}, {x - 4, 4, 0}});
    }
    Scene scene;
    scene.add("floors", {{}, floors});
    const auto first = scene.first_contact(kFalls);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->face, (FaceId{0, 0}));
  }
}

// Both times round to 7/8, but the second floor is higher.
TEST(MovingBallInScene, TellsTimesApartThatRoundToOneDouble) {
  Scene scene;
  scene.add("floors", {{floor_at(0), floor_at(0x1p-60)}, {}});
  const auto first = scene.first_contact(kFalls);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->face, (FaceId{0, 1}));
  EXPECT_EQ(first->contact.time, 0.875);
}

// A pyramid: its apex and its ridges belong to four faces.
TEST(MovingBallInScene, NamesTheLowestFaceAtASharedVertexOrEdge) {
  const Eigen::Vector3d apex(0, 0, 1), corners[] = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  scene::Faces pyramid;
  for (int i = 3; i >= 0; --i) pyramid.triangles.push_back({corners[i], corners[(i + 1) % 4], apex});
  Scene scene;
  scene.add("pyramid", pyramid);
  const auto on_apex = scene.first_contact(Motion({{0, 0, 3}, 1}, {0, 0, 0}));
  ASSERT_TRUE(on_apex);
  EXPECT_EQ(on_apex->face, (FaceId{0, 0}));
  EXPECT_EQ(on_apex->contact.feature, (Feature{Feature::Kind::Vertex, 2}));
  // Along a diagonal onto the ridge to (1, 1, 0), which faces 0 (as edge 1) and 3 (as edge 2) share.
  const auto on_ridge = scene.first_contact(Motion({{2.5, 2.5, 2.5}, 0.5}, {0.5, 0.5, 0.5}));
  ASSERT_TRUE(on_ridge);
  EXPECT_EQ(on_ridge->face, (FaceId{0, 0}));
  EXPECT_EQ(on_ridge->contact.feature, (Feature{Feature::Kind::Edge, 1}));
}

// Needles whose tips are at distance 5 from the way's end, except for the first, which is a double farther.
TEST(MovingBallInScene, ComparesTimesAtDifferentPlacesExactly) {
  const auto needle = [](double x, double y) {
    return Triangle{{x, y, 0}, {1.25 * x, 1.25 * y, -8}, {1.25 * x - 0.25 * y, 1.25 * y + 0.25 * x, -8}};
  };
  Scene scene;
  scene.add("needles", {{needle(4, 3.0000000000000004), needle(-3, 4), needle(3, -4), needle(0, 5)}, {}});
  const auto first = scene.first_contact(Motion({{0, 0, 8}, 5}, {0, 0, 0}));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->face, (FaceId{0, 1}));
  EXPECT_EQ(first->contact.time, 1);
  EXPECT_EQ(first->contact.momentary, true);
}

/// Needles whose tips lie on the lower half of the sphere of radius 9 about the origin, at all 49 places of integers,
/// `first` places further in their order. A ball of radius 9 that falls along z touches all tips as it comes to the
/// origin, and only the tips.
std::vector<Triangle> needles_at_once(std::size_t first) {
  std::vector<Triangle> needles;
  for (int x = -9; x <= 9; ++x)
    for (int y = -9; y <= 9; ++y)
      for (int z = -9; z < 0; ++z) {
        const Eigen::Vector3d tip(x, y, z), end(2 * x, 2 * y, 2 * z - 8);
        if (tip.squaredNorm() == 81) needles.push_back({tip, end, end + Eigen::Vector3d(-y, x + 1, 0) / 8});
      }
  std::rotate(needles.begin(), needles.begin() + static_cast<std::ptrdiff_t>(first), needles.end());
  return needles;
}

/// Calls f(scene, words) with scenes of these triangles: as triangles and as polygons, standing and as a quarter turn
/// about z and a translation by 2^20 take them there.
template <class F>
void for_each_standing(const std::vector<Triangle>& triangles, const F& f) {
  Pose quarter;
  quarter.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  quarter.translation = Eigen::Vector3d(0x1p20, 0, 0);
  const auto back = [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.y(), 0x1p20 - p.x(), p.z()); };
  for (const bool as_polygons : {false, true})
    for (const bool under_pose : {false, true}) {
      scene::Faces faces;
      for (Triangle t : triangles) {
        if (under_pose) t = {back(t.a), back(t.b), back(t.c)};
        if (as_polygons)
          faces.polygons.push_back(Polygon({t.a, t.b, t.c}));
        else
          faces.triangles.push_back(t);
      }
      Scene scene;
      if (under_pose)
        scene.add("turned", faces, quarter);
      else
        scene.add("standing", faces);
      f(scene, std::string(as_polygons ? "polygons" : "triangles") + (under_pose ? ", turned" : ""));
    }
}

// Many faces in many boxes at exactly the same time, in different orders. The times 1/3 and 2/3 round down and up, 1/2
// and 1 do not round.
TEST(MovingBallInScene, NamesTheLowestOfManyFacesTouchedAtOnce) {
  ASSERT_EQ(needles_at_once(0).size(), 49U);
  for (std::size_t first = 0; first < 49; first += 3)
    for_each_standing(needles_at_once(first), [&](const Scene& scene, const std::string& what) {
      for (const auto& [above, below] : {std::pair(1, 2), {2, 1}, {1, 1}, {3, 0}, {64, 128}, {1024, 512}}) {
        const Motion falls({{0, 0, static_cast<double>(above)}, 9}, {0, 0, -static_cast<double>(below)});
        const auto found = scene.first_contact(falls);
        ASSERT_TRUE(found) << what;
        EXPECT_EQ(found->face, (FaceId{0, 0})) << what << ", from " << first << ", falling " << above;
        EXPECT_EQ(found->contact.time, static_cast<double>(above) / (above + below)) << what;
        EXPECT_EQ(found->contact.feature.kind, Feature::Kind::Vertex) << what;
      }
    });
}

// Into a corner of three walls, whose boxes are flat: the ball comes to each box exactly when it touches the wall in
// it. Each wall stands there often enough to fill boxes of its own.
TEST(MovingBallInScene, NamesTheLowestOfThreeWallsInACorner) {
  for (int lowest = 0; lowest < 3; ++lowest) {
    std::vector<Triangle> walls;
    for (int wall = lowest; wall < lowest + 3; ++wall)
      for (int copy = 0; copy < 9; ++copy) {
        const auto at = [wall](double u, double v) {
          Eigen::Vector3d point(0, 0, 0);
          point[(wall + 1) % 3] = u, point[(wall + 2) % 3] = v;
          return point;
        };
        walls.push_back({at(0.5, 0.5), at(8, 0.5), at(0.5, 8)});
      }
    for_each_standing(walls, [&](const Scene& scene, const std::string& what) {
      for (const auto& [before, behind] : {std::pair(1.0, 2.0), {2.0, 1.0}, {3.0, 1.0}, {2.5, 0.5}, {16.0, 5.0}}) {
        const Eigen::Vector3d ones(1, 1, 1);
        const auto found = scene.first_contact(Motion({(1 + before) * ones, 1}, (1 - behind) * ones));
        ASSERT_TRUE(found) << what;
        EXPECT_EQ(found->face, (FaceId{0, 0})) << what << ", lowest " << lowest << ", from " << before;
        EXPECT_EQ(found->contact.time, before / (before + behind)) << what;
      }
    });
  }
}

// A motion is shortened to a time at which the first face has been touched: 1/3 is more than its nearest double.
TEST(FirstContactSearch, EndsNoEarlierThanTheFirstContact) {
  const Motion falls({{0, 0, 3}, 1}, {0, 0, -3});
  const Triangle floor{{-4, -4, 0}, {4, -4, 0}, {0, 8, 0}};
  const filtered::PreparedPolygon polygon(Polygon({floor.a, floor.b, floor.c}));
  for (const bool as_polygon : {false, true}) {
    scene::detail::FirstContactSearch search(falls);
    EXPECT_EQ(search.end(), 1);
    const FirstContact contact = filtered::first_contact(falls, polygon);
    as_polygon ? search.meet(polygon, 0, contact) : search.meet(floor, 0, contact);
    EXPECT_GE(3 * mpq_class(search.end()), 1);
    EXPECT_LT(search.end(), 0.34);
    // A face at the same time counts still.
    as_polygon ? search.meet(floor, 1, contact) : search.meet(polygon, 1, contact);
    EXPECT_EQ(search.first()->face, (FaceId{0, 0}));
  }
}

// Many faces that are touched at the start, at time 0.
TEST(MovingBallInScene, NamesTheLowestOfManyFacesTouchedAtTheStart) {
  for (std::size_t first = 0; first < 49; first += 3)
    for_each_standing(needles_at_once(first), [&](const Scene& scene, const std::string& what) {
      for (const double down : {0.0, 1.0, 100.0}) {
        const auto found = scene.first_contact(Motion({{0, 0, 0}, 9}, {0, 0, -down}));
        ASSERT_TRUE(found) << what;
        EXPECT_EQ(found->face, (FaceId{0, 0})) << what << ", from " << first;
        EXPECT_EQ(found->contact.kind, FirstContactKind::Start) << what;
      }
    });
}

// Of the faces touched at the start the lowest counts, whichever the walk meets first, and none that is touched later.
TEST(MovingBallInScene, NamesTheLowestFaceTouchedAtTheStart) {
  Scene scene;
  scene.add("ahead", {{floor_at(6.5)}, {}});
  scene.add("floors", {{floor_at(0), floor_at(8.5), floor_at(7.75), floor_at(8)}, {}});
  const auto first = scene.first_contact(kFalls);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->face, (FaceId{1, 1}));
  EXPECT_EQ(first->contact.kind, FirstContactKind::Start);
  EXPECT_EQ(first->contact.time, 0);
  EXPECT_EQ(first->contact.point, Eigen::Vector3d(0.5, 0.5, 8.5));
}

TEST(MovingBallInScene, SeesAGrazeOfASingleMoment) {
  Scene scene;
  scene.add("fin", {{{{0, 0, 0}, {1, 0, -1}, {-1, 0, -1}}}, {}});
  const auto first = scene.first_contact(Motion({{0, -4, 1}, 1}, {0, 4, 1}));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->contact,
            (FirstContact{FirstContactKind::Way, 0.5, true, {Feature::Kind::Vertex, 0}, {0, 0, 0}, {0, 0, 1}}));
  EXPECT_FALSE(scene.first_contact(Motion({{0, -4, 1.0000000000000002}, 1}, {0, 4, 1.0000000000000002})));
}

// A motion whose centre is twice the largest double from its end.
TEST(MovingBallInScene, CrossesTheLargestNumbers) {
  const double far = 0x1.fp1023;
  Scene scene;
  scene.add("wall", {{{{0, -far, -far}, {0, far, -far}, {0, 0, far}}}, {}});
  const auto first = scene.first_contact(Motion({{-far, 0, 0}, 0}, {far, 0, 0}));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->contact.time, 0.5);
  EXPECT_FALSE(scene.touches(Motion({{-far, 0, 0}, 0}, {-1, 0, 0})));
}

}  // namespace
}  // namespace touchstone::scene_tests
